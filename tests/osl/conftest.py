# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs OSL inside real Blenders.

NACRE_BPY45 and NACRE_BPY52 name Python programs that have `bpy` 4.5 and 5.2. Each test runs once per
version that is there and is skipped, with a word, for the others.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "osl" / "include"
SHADERS = sorted((ROOT / "osl" / "shaders").glob("*.osl"))
VERSIONS = {"4.5": "NACRE_BPY45", "5.2": "NACRE_BPY52"}


def inline(text: str, seen: set[str] | None = None) -> str:
    """OSL text with our includes in place: Cycles' compiler takes no include path."""
    seen = set() if seen is None else seen
    lines = []
    for line in text.splitlines():
        found = re.fullmatch(r'#include "(nacre/[^"]+)"', line)
        if not found:
            if line != "#pragma once":
                lines.append(line)
        elif found[1] not in seen:
            seen.add(found[1])
            lines.append(inline((INCLUDE / found[1]).read_text(encoding="utf-8"), seen))
    return "\n".join(lines) + "\n"


class Blender:
    """One `bpy`; every call is a process of its own."""

    def __init__(self, version: str, python: str, folder: Path):
        self.version = version
        self.python = python
        self.folder = folder
        # Cycles changed the direction of t after 5.1; see the test of nacre_table.
        self.table_origin_top = int(version < "5.2")

    def run(self, task: str, **arguments) -> dict:
        job = self.folder / "job.json"
        result = self.folder / "result.json"
        job.write_text(json.dumps({"task": task, "folder": str(self.folder), **arguments}))
        result.unlink(missing_ok=True)
        process = subprocess.run(
            [self.python, str(Path(__file__).with_name("worker.py")), str(job), str(result)],
            check=False,
            capture_output=True,
            text=True,
            timeout=600,
        )
        assert result.exists(), process.stdout + process.stderr
        return json.loads(result.read_text()) | {"log": process.stdout + process.stderr}

    def compile(self, shaders: dict[str, str]) -> dict:
        """Compiles shader texts by name; the answer has what the compiler said about each."""
        return self.run("compile", shaders=shaders)

    def values(self, headers: list[str], body: str, count: int) -> np.ndarray:
        """Runs `body` for i = 0 … count − 1; it sets `color value`. Shape (count, 3)."""
        includes = "".join(f'#include "nacre/{name}"\n' for name in headers)
        osl = (
            f"{includes}shader probe(output closure color BSDF = 0)\n"
            "{\n    int i = (int)floor(P[0]);\n    color value = 0.0;\n"
            f"{body}\n    BSDF = value * emission();\n}}\n"
        )
        answer = self.run("values", osl=inline(osl), count=count)
        return np.load(answer["file"])

    def write_table(self, rows: np.ndarray) -> str:
        """Path of an EXR with these colours, shape (height, width, 3), row 0 at the top."""
        return self.run("write_table", rows=np.asarray(rows).tolist())["file"]

    def render(self, **arguments) -> np.ndarray:
        """A picture of shape (height, width, 3), row 0 at the top."""
        return np.load(self.run("render", **arguments)["file"])


@pytest.fixture(params=VERSIONS)
def blender(request, tmp_path) -> Blender:
    variable = VERSIONS[request.param]
    python = os.environ.get(variable)
    if not python:
        pytest.skip(f"{variable} names no Python with bpy {request.param}")
    return Blender(request.param, python, tmp_path)
