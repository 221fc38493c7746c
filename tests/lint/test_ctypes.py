# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What Python declares of the C interface is what its headers say."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cpp_tools" / "generators"))
import write_ctypes


@pytest.fixture(scope="module")
def interface():
    return write_ctypes.Interface(write_ctypes.INCLUDE)


@pytest.fixture(scope="module")
def declared():
    """The module alone: the package would load the library."""
    spec = importlib.util.spec_from_file_location("_capi", write_ctypes.OUTPUT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_what_is_committed_is_what_the_generator_makes(interface):
    assert write_ctypes.OUTPUT.read_text("utf-8") == write_ctypes.text_of(interface), (
        "run .venv/bin/python cpp_tools/generators/write_ctypes.py"
    )


def test_structures_lie_as_the_compiler_lays_them(interface, declared, tmp_path):
    lines = ["#include <stddef.h>", "#include <stdio.h>", '#include "nacre/capi.h"']
    lines += ["int main(void) {"]
    for name, fields in interface.structures.items():
        lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
        for field in fields:
            at = f"offsetof({name}, {field.name})"
            lines.append(f'printf("{name}.{field.name} %zu\\n", {at});')
    source, program = tmp_path / "layout.c", tmp_path / "layout"
    source.write_text("\n".join([*lines, "return 0; }"]))
    compiler = [os.environ.get("CC", "cc"), f"-I{write_ctypes.INCLUDE}"]
    subprocess.run([*compiler, source, "-o", program], check=True)
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    laid = dict(line.split() for line in printed.splitlines())

    assert len(interface.structures) > 10
    for name, fields in interface.structures.items():
        structure = getattr(declared, write_ctypes.class_name(name))
        assert ctypes.sizeof(structure) == int(laid[name]), name
        for field in fields:
            offset = getattr(structure, field.name).offset
            assert offset == int(laid[f"{name}.{field.name}"]), f"{name}.{field.name}"


def test_every_function_is_declared(interface, declared):
    assert set(declared.SIGNATURES) == set(interface.functions)
    assert interface.constants["API_VERSION"] == declared.API_VERSION
