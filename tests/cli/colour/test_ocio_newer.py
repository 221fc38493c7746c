# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Configs newer than the tool's own OpenColorIO, by the one of a Python or a Blender at hand."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from support.tool import Tool

RECORDS = [
    {"wavelength_nm": [360, 600, 640, 830], "values": [0, 0, 1, 1], "kind": "reflectance"},
    {"illuminant": "D65"},
    *({"blackbody_K": kelvin} for kelvin in range(2000, 10000, 200)),
]
LAMP = '{"illuminant": "D65"}'

# Half of XYZ.
CONFIG = """\
ocio_profile_version: 2
roles: {default: xyz, scene_linear: half, cie_xyz_d65_interchange: xyz}
displays: {d: [!<View> {name: v, colorspace: half}]}
colorspaces:
  - !<ColorSpace> {name: xyz}
  - !<ColorSpace>
    name: half
    from_scene_reference: !<MatrixTransform>
      matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]
"""


def bpy_folder(python: str) -> Path:
    probe = "import importlib.util as u; print(u.find_spec('bpy').submodule_search_locations[0])"
    return Path(subprocess.check_output([python, "-c", probe], text=True).strip())


def config_in(python: str) -> Path:
    return next(bpy_folder(python).glob("*/datafiles/colormanagement/config.ocio"))


@pytest.fixture(scope="session")
def newer() -> dict[str, str]:
    """The environment that names a Python with Blender 5.2, whose OpenColorIO is 2.5."""
    python = os.environ.get("NACRE_BPY52")
    if not python:
        pytest.skip("NACRE_BPY52 does not name a Python with bpy 5.2")
    return {"NACRE_PYTHON": python, "NACRE_BLENDER": ""}


@pytest.fixture(scope="session")
def config_of_5_2(newer) -> Path:
    return config_in(newer["NACRE_PYTHON"])


@pytest.fixture(scope="session")
def alone(prefix, tmp_path_factory):
    """An installation on a machine without any Python or Blender."""
    empty = str(tmp_path_factory.mktemp("path"))
    tool = Tool(prefix / "bin" / "nacre")
    environment = {"PATH": empty, "NACRE_PYTHON": "", "NACRE_BLENDER": ""}

    def run(*arguments, **more):
        return tool("eval", "spectrum", *arguments, stdin=LAMP, env={**environment, **more})

    return run


def rgb(nacre, config, space: str, environment: dict[str, str]) -> list[list[float]]:
    options = ("--config", config, "--space", space)
    out = nacre.ok(
        "eval", "spectrum", *options, stdin=json.dumps(RECORDS), env=environment, timeout=60
    )
    return [answer["rgb"] for answer in json.loads(out)]


@pytest.mark.parametrize(
    ("theirs", "ours"),
    [
        ("scene_linear", "lin_rec709_scene"),
        ("Linear Rec.2020", "lin_rec2020_scene"),
        ("ACEScg", "lin_ap1_scene"),
        ("cie_xyz_d65_interchange", "xyz_d65"),
    ],
)
def test_spaces_of_blender_5_2_are_our_spaces(nacre, newer, config_of_5_2, theirs, ours):
    lamps = json.dumps(RECORDS[1:])
    options = ("--config", config_of_5_2, "--space", theirs)
    out = nacre.ok("eval", "spectrum", *options, stdin=lamps, env=newer)
    built_in = nacre.evaluate("spectrum", RECORDS[1:], "--space", ours)
    for answer, expected in zip(json.loads(out), built_in, strict=True):
        assert answer["space"] == theirs
        # Blender's matrices have rounded primaries and whites.
        assert answer["rgb"] == pytest.approx(expected["rgb"], abs=5e-4)


def test_a_curve_of_blender_5_2_is_followed(nacre, newer, config_of_5_2):
    """IEC 61966-2-1 over the linear colours, whichever of the records is asked first."""
    encoded = rgb(nacre, config_of_5_2, "sRGB", newer)
    linear = rgb(nacre, config_of_5_2, "Linear Rec.709", newer)
    checked = 0
    for curve, values in zip(encoded, linear, strict=True):
        for code, value in zip(curve, values, strict=True):
            if value > 0.0031308:
                assert code == pytest.approx(1.055 * value ** (1 / 2.4) - 0.055, abs=1e-3)
                checked += 1
    assert checked > 100


def test_a_python_answers_as_the_tool_itself_does(nacre, tmp_path):
    """Blender 4.5's config, which both can read, and the same named newer than the tool reads."""
    source = config_in(sys.executable)
    for name in ("luts", "filmic"):
        if (source.parent / name).is_dir():
            (tmp_path / name).symlink_to(source.parent / name)
    config = tmp_path / "config.ocio"
    text, count = re.subn(
        r"(?m)^ocio_profile_version:.*$", "ocio_profile_version: 2.4", source.read_text("utf-8")
    )
    assert count == 1
    config.write_text(text, encoding="utf-8")
    environment = {"NACRE_PYTHON": sys.executable}
    for space in ("ACEScg", "sRGB", "AgX Log", "Filmic Log"):
        by_tool = rgb(nacre, source, space, environment)
        by_python = rgb(nacre, config, space, environment)
        for theirs, ours in zip(by_python, by_tool, strict=True):
            assert theirs == pytest.approx(ours, rel=2e-5, abs=2e-6), space


@pytest.mark.parametrize(
    ("uri", "space"),
    [
        ("ocio://default", "scene_linear"),
        ("ocio://cg-config-v1.0.0_aces-v1.3_ocio-v2.1", "ACEScg"),
        ("ocio://studio-config-v4.0.0_aces-v2.0_ocio-v2.5", "ACEScg"),
    ],
)
def test_configs_inside_open_color_io(nacre, newer, uri, space):
    out = nacre.ok("eval", "spectrum", "--config", uri, "--space", space, stdin=LAMP, env=newer)
    ours = nacre.evaluate("spectrum", json.loads(LAMP), "--space", "lin_ap1_scene")
    assert json.loads(out)["rgb"] == pytest.approx(ours["rgb"], abs=5e-4)


def test_an_archive_is_read(nacre, newer, tmp_path):
    """A zip with the config at its top, which OpenColorIO reads from 2.2 on."""
    archive = tmp_path / "studio.ocioz"
    with zipfile.ZipFile(archive, "w") as file:
        file.writestr("config.ocio", CONFIG)
    out = nacre.ok("eval", "spectrum", "--config", archive, stdin=LAMP, env=newer)
    answer = json.loads(out)
    assert answer["rgb"] == pytest.approx([component / 2 for component in answer["XYZ"]], rel=1e-6)


def test_a_table_in_a_space_of_a_newer_config(nacre, newer, config_of_5_2, film_json, tmp_path):
    size = ("bake", "stack", film_json, "--size", "16x8")
    ours, theirs = tmp_path / "ours.exr", tmp_path / "theirs.exr"
    nacre.ok(*size, "--space", "lin_ap1_scene", "-o", ours)
    nacre.ok(*size, "--config", config_of_5_2, "--space", "ACEScg", "-o", theirs, env=newer)
    compared = json.loads(nacre.ok("compare", ours, theirs, "--space", "lin_ap1_scene", "--json"))
    assert compared["dE00"]["max"] < 0.1


@pytest.mark.parametrize(
    ("space", "message"),
    [
        ("Kodachrome", "--space: must be a space or role of the config: Linear CIE-XYZ D65, "),
        ("Non-Color", "--space: must be a space of colours; Non-Color holds data"),
    ],
)
def test_wrong_spaces_are_told_as_of_an_older_config(nacre, newer, config_of_5_2, space, message):
    options = ("--config", config_of_5_2, "--space", space)
    errors = nacre.fails("eval", "spectrum", *options, stdin=LAMP, env=newer)
    assert f"{config_of_5_2}: {message}" in errors


def test_without_a_newer_one_the_message_says_what_is_wanted_and_how_to_get_it(alone, tmp_path):
    config = tmp_path / "config.ocio"
    config.write_text("# Of the year after next\nocio_profile_version: 99.5\n")
    result = alone("--config", config)
    assert result.returncode == 1
    assert result.stdout == ""
    found = re.search(r"at hand: (\d+\.\d+\.\d+) \(this tool's\); ", result.stderr)
    assert found, result.stderr
    assert result.stderr == (
        f"nacre eval spectrum: {config}:2: ocio_profile_version: a config of version 99.5 needs "
        f"OpenColorIO 99.5 or newer; at hand: {found[1]} (this tool's); to get it: pip install "
        "opencolorio, for a Python that NACRE_PYTHON names or that is python3 on the path\n"
    )


@pytest.mark.parametrize(
    ("uri", "needed"), [("ocio://cg-config-v9.0.0_aces-v9.0_ocio-v98.7", "98.7")]
)
def test_a_uri_tells_which_version_has_it(alone, uri, needed):
    errors = alone("--config", uri).stderr
    assert f"{uri}: a config inside OpenColorIO needs OpenColorIO {needed} or newer" in errors


def test_a_uri_that_no_open_color_io_has(nacre, newer):
    errors = nacre.fails("eval", "spectrum", "--config", "ocio://nothing", stdin=LAMP, env=newer)
    assert "ocio://nothing: cannot be used as a colour config by OpenColorIO 2." in errors
    assert "Could not find 'nothing' in the built-in configurations" in errors


def stub(path: Path, script: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    return path


def test_every_python_that_was_asked_is_named(alone, tmp_path):
    config = tmp_path / "config.ocio"
    config.write_text("ocio_profile_version: 99\n")
    old = stub(tmp_path / "old", "echo '\"2.3.4\"'; read -r request")
    for python, said in (
        (old, f"2.3.4 ({old}, NACRE_PYTHON)"),
        (stub(tmp_path / "none", "echo null; read -r request"), "none in "),
        (stub(tmp_path / "ends", "exit 3"), "none in "),
        (stub(tmp_path / "chats", "echo 'no Python here'; echo more"), "none in "),
        (tmp_path / "missing", "none in "),
    ):
        errors = alone("--config", config, NACRE_PYTHON=str(python)).stderr
        assert "config of version 99.0 needs OpenColorIO 99.0 or newer" in errors
        assert said in errors
        assert str(python) in errors


def test_a_python_that_ends_half_way_is_an_error(alone, tmp_path):
    config = tmp_path / "config.ocio"
    config.write_text("ocio_profile_version: 99\n")
    head = "echo '\"99.0.0\"'; read -r request"
    answer = json.dumps(
        {"names": [], "is_known": True, "is_data": False, "has_interchange": True, "failure": ""}
    )
    for script in (head, f"{head}; echo '{answer}'; read -r colour"):
        python = stub(tmp_path / "python", script)
        result = alone("--config", config, NACRE_PYTHON=str(python))
        assert result.returncode == 1
        assert result.stdout == ""
        assert "the Python that reads the config has ended" in result.stderr


def test_the_python_inside_a_blender_is_found(alone, newer, config_of_5_2, tmp_path):
    """Laid out as an unpacked Blender, reached by a link as package managers make it."""
    blender = stub(tmp_path / "blender-5.2" / "blender", "exit 1")
    stub(
        blender.parent / "5.2" / "python" / "bin" / "python3.13",
        f'exec "{newer["NACRE_PYTHON"]}" "$@"',
    )
    link = tmp_path / "bin" / "blender"
    link.parent.mkdir()
    link.symlink_to(blender)
    for environment in ({"NACRE_BLENDER": str(link)}, {"PATH": str(link.parent)}):
        result = alone("--config", config_of_5_2, **environment)
        assert json.loads(result.stdout)["space"] == "scene_linear", result.stderr


def test_files_where_the_user_stands_are_not_imported(nacre, newer, config_of_5_2, tmp_path):
    (tmp_path / "json.py").write_text("raise SystemExit('a file of the user, not the module')")
    out = nacre.ok(
        "eval", "spectrum", "--config", config_of_5_2, stdin=LAMP, env=newer, cwd=tmp_path
    )
    assert json.loads(out)["space"] == "scene_linear"
