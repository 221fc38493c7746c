# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install` puts under a prefix works without the checkout."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from blender.harness import VERSIONS
from support.osl import SHADER_MATERIALS
from support.tool import Tool


@pytest.fixture
def installed(prefix) -> Tool:
    return Tool(prefix / "bin" / "nacre")


def test_layout(installed, templates):
    share = installed.program.parents[1] / "share" / "nacre"
    for name in ("addon", "osl/include", "templates", "data/optical_constants", "materials"):
        assert (share / name).is_dir(), name
    sources = {path.stem for path in templates.glob("*.toml")}
    assert {path.name for path in (share / "materials").iterdir()} == sources | set(
        SHADER_MATERIALS
    )
    prefix = installed.program.parents[1]
    for path in share.rglob("*"):
        assert path.resolve(strict=True).is_relative_to(prefix.resolve()), path
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
    python.write_text('#!/bin/sh\n[ "$1" = -c ] || echo "$1" >&"$NACRE_REPORT_FD"\n')
    python.chmod(0o755)
    result = installed("render", "--material", "water", env={"NACRE_PYTHON": str(python)})
    driver = installed.program.parents[1] / "share" / "nacre" / "addon" / "background" / "driver.py"
    if not driver.is_file():
        assert f"{driver}: is missing" in result.stderr
    else:
        assert result.stdout.strip() == str(driver)


BLENDERS = [*VERSIONS.values(), "NACRE_BLENDER"]


@pytest.fixture(params=BLENDERS)
def clean_render(request, installed, tmp_path):
    """`nacre render` of an installation for someone who has a path, a home and one Blender: a Python with
    bpy on the path, or a program that is named."""
    program = os.environ.get(request.param)
    if not program:
        pytest.skip(f"{request.param} names no Blender")
    environment = {"PATH": os.defpath, "HOME": str(tmp_path)}
    if request.param == "NACRE_BLENDER":
        if "NACRE_BLENDER_TMP" in os.environ:
            pytest.skip("this Blender does not see the installation")
        environment["NACRE_BLENDER"] = program
    else:
        (tmp_path / "bin").mkdir()
        python = tmp_path / "bin" / "python3"
        python.write_text(f'#!/bin/sh\nexec "{program}" "$@"\n')
        python.chmod(0o755)
        environment["PATH"] = f"{python.parent}:{os.defpath}"
    quick = ("--stage", "furnace", "--size", "16x16", "--samples", "1", "--set", "range_nm=100:200")

    def run(*arguments) -> subprocess.CompletedProcess:
        command = [installed.program, "render", "--material", "oil_on_water", *quick, *arguments]
        return subprocess.run(
            list(map(str, command)), env=environment, cwd=tmp_path, capture_output=True, text=True,
            timeout=600, check=False,
        )  # fmt: skip

    return run


def test_render_computes_with_what_is_installed(clean_render, installed):
    done = clean_render(
        "--set", "substrate=Au/Johnson", "--set", "thickness_nm=150", "--pixel", "8", "8", "--json"
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    (found,) = json.loads(done.stdout)["probes"]
    film = {"n": ["air", 1.47, "Au/Johnson"], "d_nm": [150], "angle_deg": found["angle_deg"]}
    exact = installed.evaluate("colour", film)["reflectance"]
    # The oil disperses (Abbe number 50), the film here does not.
    assert found["R"]["XYZ"] == pytest.approx(exact["XYZ"], abs=5e-3)


def test_render_is_quiet_when_asked(clean_render, tmp_path):
    picture = ("--technique", "airy", "--vary", "drop", "-o", "picture.exr")
    done = clean_render(*picture, "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert Path(tmp_path, "picture.exr").is_file()
    done = clean_render(*picture, "--quiet", "--set", "substrate=Unobtainium")
    assert done.returncode == 1
    assert done.stdout == ""
    assert "Unobtainium" in done.stderr
