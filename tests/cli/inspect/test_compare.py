# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre compare` and `nacre info` on images of our own and of others."""

from __future__ import annotations

import json

import numpy as np
import OpenImageIO as oiio
import pytest

from support.colours import delta_e
from support.images import read_all, write_as

RANDOM = np.random.default_rng(1)


@pytest.fixture
def pair(tmp_path):
    """Two linear Rec.709 images, and the ΔE00 of their pixels by colour-science."""
    first = RANDOM.uniform(0.02, 1.0, (4, 6, 3)).astype(np.float32)
    second = np.clip(first + RANDOM.normal(0, 0.03, first.shape), 0.001, 2).astype(np.float32)
    write_as(tmp_path / "a.exr", first)
    write_as(tmp_path / "b.exr", second)

    expected = delta_e(first, second)
    return (
        tmp_path / "a.exr",
        tmp_path / "b.exr",
        expected,
        np.sqrt(np.mean((first - second) ** 2.0)),
    )


def test_figures_agree_with_colour_science(nacre, pair):
    a, b, expected, rmse = pair
    result = json.loads(nacre.ok("compare", a, b, "--json"))
    assert result["dE00"]["mean"] == pytest.approx(expected.mean(), rel=1e-5)
    assert result["dE00"]["max"] == pytest.approx(expected.max(), rel=1e-5)
    assert result["rmse"] == pytest.approx(rmse, rel=1e-5)
    row, column = np.unravel_index(np.argmax(expected), expected.shape)
    assert result["worst"] == [column, row]
    assert result["not_finite"] == 0


def test_an_image_is_like_itself(nacre, pair):
    a = pair[0]
    assert nacre.ok("compare", a, a, "--max", "0") == (
        "ΔE00 mean 0, max 0 at pixel (0, 0); RMSE 0\n"
    )


def test_above_the_limit(nacre, pair):
    a, b, expected, _ = pair
    assert nacre("compare", a, b, "--max", expected.max() * 1.01).returncode == 0
    result = nacre("compare", a, b, "--max", expected.max() * 0.99)
    assert result.returncode == 2
    assert "is above --max" in result.stderr
    assert result.stdout.startswith("ΔE00 mean")


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_pixel_that_is_not_finite_is_a_failure(nacre, pair, tmp_path, value):
    pixels = read_all(pair[0])[0].copy()
    pixels[2, 3, 1] = value
    write_as(tmp_path / "broken.exr", pixels)
    for files in ((pair[0], tmp_path / "broken.exr"), (tmp_path / "broken.exr", pair[0])):
        result = nacre("compare", *files, "--max", "100", "--json")
        assert result.returncode == 2
        assert "1 pixels are not finite" in result.stderr
        assert json.loads(result.stdout)["not_finite"] == 1
        assert json.loads(result.stdout)["dE00"]["max"] == 0


def test_sizes_differ(nacre, pair, tmp_path):
    write_as(tmp_path / "small.exr", np.zeros((2, 6, 3)))
    errors = nacre.fails("compare", pair[0], tmp_path / "small.exr", "--max", "100")
    assert "must be 6 x 4 pixels" in errors
    assert "(got 6 x 2)" in errors


def test_heat_map(nacre, pair, tmp_path):
    a, b, expected, _ = pair
    nacre.ok("compare", a, b, "--heatmap", tmp_path / "map.exr")
    pixels, _ = read_all(tmp_path / "map.exr")
    assert pixels[..., 0] == pytest.approx(expected, rel=1e-4)
    nacre.ok("compare", a, b, "--heatmap", tmp_path / "map.png")
    picture = read_all(tmp_path / "map.png")[0].sum(axis=-1)
    assert np.argmax(picture) == np.argmax(expected)


def test_eight_bit_files_are_decoded(nacre, tmp_path):
    """Mid grey: sRGB 188/255 is 0.5029 linear."""
    grey = np.full((2, 2, 3), 188 / 255)
    write_as(tmp_path / "grey.png", grey, oiio.UINT8)
    linear = ((grey + 0.055) / 1.055) ** 2.4
    write_as(tmp_path / "grey.exr", linear)
    result = json.loads(nacre.ok("compare", tmp_path / "grey.png", tmp_path / "grey.exr", "--json"))
    assert result["dE00"]["max"] < 1e-4


def test_alpha_is_left_out_and_grey_is_grey(nacre, tmp_path):
    write_as(tmp_path / "rgba.exr", np.dstack([np.full((2, 2, 3), 0.5), np.zeros((2, 2))]))
    write_as(tmp_path / "grey.exr", np.full((2, 2, 1), 0.5))
    nacre.ok("compare", tmp_path / "rgba.exr", tmp_path / "grey.exr", "--max", "0")


def test_the_space_of_the_files_counts(nacre, pair, tmp_path):
    pixels_a, pixels_b = read_all(pair[0])[0], read_all(pair[1])[0]
    for name in ("lin_rec709_scene", "lin_ap1_scene"):
        write_as(tmp_path / f"a_{name}.exr", pixels_a, colorInteropID=name)
        write_as(tmp_path / f"b_{name}.exr", pixels_b, colorInteropID=name)
    results = [
        json.loads(
            nacre.ok("compare", tmp_path / f"a_{name}.exr", tmp_path / f"b_{name}.exr", "--json")
        )
        for name in ("lin_rec709_scene", "lin_ap1_scene")
    ]
    assert [result["space"] for result in results] == ["lin_rec709_scene", "lin_ap1_scene"]
    assert results[0]["dE00"]["max"] != pytest.approx(results[1]["dE00"]["max"], rel=1e-3)
    mixed = (tmp_path / "a_lin_rec709_scene.exr", tmp_path / "b_lin_ap1_scene.exr")
    assert "must be in lin_rec709_scene" in nacre.fails("compare", *mixed)
    assert nacre("compare", *mixed, "--space", "lin_rec709_scene").returncode == 0


def test_info_of_a_table(nacre, film_json, tmp_path):
    path = tmp_path / "film.exr"
    nacre.ok("bake", "stack", film_json, "--size", "7x5", "-o", path)
    text = nacre.ok("info", path)
    assert f"{path}: 7 x 5 float, channels R G B, openexr" in text
    assert "axis: thickness_nm, 0 … 400 nm" in text
    assert "axis: cos_theta, 0 … 1\n" in text
    assert "illuminant: D65" in text
    data = json.loads(nacre.ok("info", path, "--json"))
    assert (data["width"], data["height"]) == (7, 5)
    assert data["axes"][1]["max"] == 400
    assert data["stack"]["layer"][0]["n"] == 1.33


def test_info_of_anything_else_says_so(nacre, pair):
    assert "not a table of nacre" in nacre.ok("info", pair[0])


def test_info_survives_attributes_that_are_not_what_they_should_be(nacre, tmp_path):
    path = tmp_path / "odd.exr"
    write_as(
        path, np.zeros((2, 2, 3)), **{"nacre:axes": '[3, {}, {"unit": 5}', "nacre:schema": "x"}
    )
    nacre.ok("info", path)
    nacre.ok("info", path, "--json")
    write_as(path, np.zeros((2, 2, 3)), **{"nacre:axes": '[3, {}, {"unit": 5}]', "nacre:schema": 7})
    assert nacre("info", path).returncode in (0, 1)
    nacre.ok("info", path, "--json")


@pytest.mark.parametrize("share", [0.0, 0.02, 0.5, 0.95])
@pytest.mark.parametrize("command", ["info", "compare"])
def test_truncated_image(nacre, pair, tmp_path, command, share):
    whole = RANDOM.uniform(0, 1, (64, 64, 3))
    write_as(tmp_path / "whole.exr", whole)
    data = (tmp_path / "whole.exr").read_bytes()
    cut = tmp_path / "cut.exr"
    cut.write_bytes(data[: int(len(data) * share)])
    files = (cut,) if command == "info" else (tmp_path / "whole.exr", cut)
    errors = nacre.fails(command, *files)
    assert f"nacre {command}: {cut}: " in errors


@pytest.mark.parametrize("command", ["info", "compare"])
def test_not_an_image(nacre, pair, tmp_path, command):
    others = {"text.exr": b"hello", "zero.png": b"\x00" * 100}
    for name, data in others.items():
        path = tmp_path / name
        path.write_bytes(data)
        files = (path,) if command == "info" else (pair[0], path)
        assert f"{path}: " in nacre.fails(command, *files)
    missing = tmp_path / "missing.exr"
    files = (missing,) if command == "info" else (pair[0], missing)
    assert f"{missing}: " in nacre.fails(command, *files)
    files = (tmp_path,) if command == "info" else (pair[0], tmp_path)
    assert f"{tmp_path}: " in nacre.fails(command, *files)
