# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install` puts under a prefix works without the checkout."""

from __future__ import annotations

import json
import os

import pytest

from support.tool import Tool


@pytest.fixture
def installed(prefix) -> Tool:
    return Tool(prefix / "bin" / "nacre")


def test_layout(installed, templates):
    share = installed.program.parents[1] / "share" / "nacre"
    for name in ("addon", "osl/include", "templates", "data/optical_constants", "materials"):
        assert (share / name).is_dir(), name
    assert {path.name for path in (share / "materials").iterdir()} == {
        path.stem for path in templates.glob("*.toml")
    }
    assert not [path for path in share.rglob("*") if path.is_symlink()]
    assert not list(share.rglob("__pycache__"))


def test_every_command_but_render(installed, tmp_path):
    template = installed.program.parents[1] / "share/nacre/templates/soap_film.toml"
    run = {"cwd": tmp_path, "env": {"HOME": str(tmp_path)}}
    assert json.loads(installed.ok("eval", "spectrum", stdin='{"illuminant": "D65"}', **run))[
        "cct_K"
    ]
    installed.ok("bake", "cmf", "-o", "cmf.exr", **run)
    installed.ok("bake", "stack", template, "--size", "8x8", "-o", "soap.exr", **run)
    installed.ok("compile", template, "--tolerance", "2", "-o", "materials", **run)
    installed.ok("library", "show", "water/Daimon-20C", "--at", "550", **run)
    installed.ok("info", "soap.exr", **run)
    installed.ok("compare", "soap.exr", "soap.exr", "--max", "0", **run)


def test_the_program_names_no_folder_of_the_checkout(installed):
    root = os.fsencode(__file__).rsplit(b"/tests/", 1)[0]
    assert root not in installed.program.read_bytes()


def test_render_finds_its_driver_under_the_prefix(installed, tmp_path):
    python = tmp_path / "python"
    python.write_text('#!/bin/sh\n[ "$1" = -c ] || echo "$1"\n')
    python.chmod(0o755)
    result = installed("render", "--material", "water", env={"NACRE_PYTHON": str(python)})
    driver = installed.program.parents[1] / "share" / "nacre" / "addon" / "driver.py"
    if not driver.is_file():
        assert f"{driver}: is missing" in result.stderr
    else:
        assert result.stdout.strip() == str(driver)
