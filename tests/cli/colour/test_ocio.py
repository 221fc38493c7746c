# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colour spaces of OpenColorIO configs, Blender's among them."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path

import pytest

RED = {"wavelength_nm": [360, 600, 640, 830], "values": [0, 0, 1, 1], "kind": "reflectance"}


@pytest.fixture(scope="session")
def blender_config() -> Path:
    """The config of the Blender that this Python carries, without importing it."""
    spec = importlib.util.find_spec("bpy")
    if spec is None:
        pytest.skip("needs bpy for Blender's colour config")
    folder = Path(spec.submodule_search_locations[0])
    return next(folder.glob("*/datafiles/colormanagement/config.ocio"))


@pytest.mark.parametrize(
    ("theirs", "ours"),
    [
        ("scene_linear", "lin_rec709_scene"),
        ("Linear Rec.709", "lin_rec709_scene"),
        ("Linear Rec.2020", "lin_rec2020_scene"),
        ("ACEScg", "lin_ap1_scene"),
        ("cie_xyz_d65_interchange", "xyz_d65"),
    ],
)
def test_blender_spaces_are_our_spaces(nacre, blender_config, theirs, ours):
    options = ("--config", blender_config, "--space", theirs)
    through_config = nacre.evaluate("spectrum", RED, *options)
    built_in = nacre.evaluate("spectrum", RED, "--space", ours)
    assert through_config["space"] == theirs
    # Blender's matrices have rounded primaries and whites.
    assert through_config["rgb"] == pytest.approx(built_in["rgb"], abs=5e-4)


def test_the_default_space_of_a_config_is_scene_linear(nacre, blender_config):
    assert nacre.evaluate("spectrum", RED, "--config", blender_config)["space"] == "scene_linear"


def test_display_spaces_work_for_numbers_but_not_for_tables(
    nacre, blender_config, film_json, tmp_path
):
    options = ("--config", blender_config, "--space", "sRGB")
    rgb = nacre.evaluate("spectrum", RED, *options)["rgb"]
    linear = nacre.evaluate("spectrum", RED)["rgb"]
    assert rgb[0] == pytest.approx(1.055 * linear[0] ** (1 / 2.4) - 0.055, abs=1e-3)
    target = tmp_path / "film.exr"
    errors = nacre.fails("bake", "stack", film_json, *options, "-o", target)
    assert "--space: must be scene-linear" in errors
    assert not target.exists()


def test_table_in_a_config_space_carries_its_name(nacre, blender_config, film_json, tmp_path):
    ours, theirs = tmp_path / "ours.exr", tmp_path / "theirs.exr"
    size = ("--size", "16x8")
    nacre.ok("bake", "stack", film_json, *size, "--space", "lin_ap1_scene", "-o", ours)
    config = ("--config", blender_config, "--space", "ACEScg")
    nacre.ok("bake", "stack", film_json, *size, *config, "-o", theirs)
    info = json.loads(nacre.ok("info", theirs, "--json"))
    assert info["space"] == "ACEScg"
    assert info["colorInteropID"] == "unknown"
    compared = json.loads(nacre.ok("compare", ours, theirs, "--space", "lin_ap1_scene", "--json"))
    assert compared["dE00"]["max"] < 0.1


def test_unknown_space_lists_what_the_config_has(nacre, blender_config):
    options = ("--config", blender_config, "--space", "Kodachrome")
    errors = nacre.fails("eval", "spectrum", *options, stdin=json.dumps(RED))
    assert "--space: must be a space or role of the config: " in errors
    assert "ACEScg" in errors
    assert "(got Kodachrome)" in errors


def test_data_is_not_a_space_of_colours(nacre, blender_config):
    options = ("--config", blender_config, "--space", "Non-Color")
    assert "holds data" in nacre.fails("eval", "spectrum", *options, stdin=json.dumps(RED))


CONFIG = """\
ocio_profile_version: {version}
roles:
  scene_linear: lin
displays:
  d:
    - !<View> {{name: v, colorspace: lin}}
colorspaces:
  - !<ColorSpace>
    name: lin
"""


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (CONFIG.format(version=1), "roles: must have cie_xyz_d65_interchange"),
        ("colorspaces: [", "cannot be used as a colour config"),
        ("", "cannot be used as a colour config"),
    ],
)
def test_configs_that_cannot_be_used_are_errors_not_fallbacks(nacre, tmp_path, text, message):
    config = tmp_path / "config.ocio"
    config.write_text(text)
    result = nacre("eval", "spectrum", "--config", config, "--space", "lin", stdin=json.dumps(RED))
    assert result.returncode == 1
    assert result.stdout == ""
    assert f"{config}: " in result.stderr
    assert message in result.stderr


def test_missing_config(nacre, tmp_path):
    errors = nacre.fails(
        "eval", "spectrum", "--config", tmp_path / "no.ocio", stdin=json.dumps(RED)
    )
    assert "no.ocio" in errors


def test_a_uri_is_no_missing_file(nacre):
    for command in (("library", "check"), ("library", "import"), ("info",)):
        errors = nacre.fails(*command, "https://example.org/glass.yml")
        assert "https://example.org/glass.yml: must be a file; this is a URI" in errors
