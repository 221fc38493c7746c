# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Tables of the pages say what the code says."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest

from support.osl import SHADER_MATERIALS
from support.paths import PACKAGE, ROOT, manifest

DOCS = ROOT / "cpp_tools" / "doc"
WORDS = {"osl": "OSL", "nodes": "nodes"}


def test_page_of_templates_is_that_of_the_schema(nacre):
    """cpp_tools/generators/write_template_page.py writes it anew."""
    written = subprocess.run(
        [sys.executable, ROOT / "cpp_tools/generators/write_template_page.py"],
        input=nacre.ok("library", "schema"), capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert (DOCS / "templates.md").read_text("utf-8") == written.stdout


def row(material: str) -> str:
    of = manifest(material)
    forms = ", ".join(word for form, word in WORDS.items() if of["graphs"][form] is not None)
    presets = ", ".join(preset["name"] for preset in of.get("presets", []))
    return f"| {of['name']} | `{material}` | {forms} | {presets} | {of['description']} |"


def test_every_shader_has_its_row():
    page = (DOCS / "shaders.md").read_text("utf-8")
    rows = re.findall(r"^\| [^|]+ \| `\w+` \| (?:OSL|nodes).*$", page, re.MULTILINE)
    assert sorted(rows) == sorted(map(row, SHADER_MATERIALS))


def numbers(line: str) -> list[float]:
    return [float(number) for number in re.findall(r"\d+\.\d+", line.rpartition("`")[2])]


def test_tables_of_bands_are_what_bands_do(tmp_path):
    """cpp_tools/generators/write_band_errors.py writes them anew."""
    page = (DOCS / "bands.md").read_text("utf-8")
    (tmp_path / "bands.md").write_text(page, "utf-8")
    subprocess.run(
        [
            sys.executable,
            ROOT / "cpp_tools/generators/write_band_errors.py",
            tmp_path / "bands.md",
        ],
        env={**os.environ, "PYTHONPATH": str(PACKAGE)},
        check=True,
    )
    lines = zip(
        page.splitlines(), (tmp_path / "bands.md").read_text("utf-8").splitlines(), strict=True
    )
    for stored, made in lines:
        assert re.sub(r"\d+\.\d+", "", stored) == re.sub(r"\d+\.\d+", "", made)
        assert numbers(stored) == pytest.approx(numbers(made), abs=0.011)
