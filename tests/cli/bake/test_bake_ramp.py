# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre bake ramp`: exact colours along thickness, as tables of other programs."""

from __future__ import annotations

import json
import re

import numpy as np
import OpenImageIO as oiio
import pytest

from support.exact import colours_of_spectra, exact_colour

THICKNESSES = [0, 100, 200, 300, 400]
OPTIONS = ("--size", "5", "--angle", "40", "--illuminant", "D50")


@pytest.fixture
def ramp(nacre, film_json, tmp_path):
    """Bakes a ramp of five colours and returns its path."""

    def bake(name, *options):
        path = tmp_path / name
        nacre.ok("bake", "ramp", film_json, *OPTIONS, *options, "-o", path)
        return path

    return bake


@pytest.fixture(scope="module")
def expected(nacre):
    stacks = [{"n": [1, 1.33, 1.5], "d_nm": [nm], "angle_deg": 40} for nm in THICKNESSES]
    return colours_of_spectra(nacre, stacks, illuminant="D50")


def numbers(lines):
    return np.array([[float(word) for word in re.split(r"[ ,]+", line.strip())] for line in lines])


def test_csv(ramp, expected):
    lines = ramp("film.csv").read_text().splitlines()
    comments = [line for line in lines if line.startswith("#")]
    assert "reflectance at 40 degrees, along thickness_nm 0 ... 400" in comments[1]
    assert (
        "illuminant D50, observer cie1931, adaptation bradford, space lin_rec709_scene"
        in comments[2]
    )
    header, *rows = lines[len(comments) :]
    assert header == "thickness_nm,R,G,B"
    table = numbers(rows)
    assert table[:, 0].tolist() == THICKNESSES
    np.testing.assert_allclose(table[:, 1:], expected, rtol=0, atol=1e-8)


def test_cube(ramp, expected):
    text = ramp("film.cube").read_text()
    head, rows = text.split("DOMAIN_MAX 400 400 400\n")
    assert head.startswith('TITLE "Stack"\n# ')
    assert head.endswith("LUT_1D_SIZE 5\nDOMAIN_MIN 0 0 0\n")
    np.testing.assert_allclose(numbers(rows.splitlines()), expected, rtol=0, atol=1e-8)


def test_spi1d(ramp, expected):
    text = ramp("film.spi1d").read_text()
    head, rows = text.split("{\n")
    assert head == "Version 1\nFrom 0 400\nLength 5\nComponents 3\n"
    assert rows.endswith("}\n")
    table = numbers(rows.removesuffix("}\n").splitlines())
    np.testing.assert_allclose(table, expected, rtol=0, atol=1e-8)


@pytest.mark.parametrize("extension", ["cube", "spi1d"])
def test_opencolorio_reads_the_ramp(ramp, expected, extension):
    """A grey of so many nanometres becomes the colour of that thickness."""
    path = ramp(f"film.{extension}")
    image = oiio.ImageBuf(oiio.ImageSpec(5, 1, 3, "float"))
    for x, thickness in enumerate(THICKNESSES):
        image.setpixel(x, 0, [thickness] * 3)
    done = oiio.ImageBufAlgo.ociofiletransform(image, str(path))
    assert not done.has_error, done.geterror()
    read = done.get_pixels(oiio.FLOAT)[0]
    np.testing.assert_allclose(read, expected, rtol=0, atol=1e-4)


def test_transmittance(nacre, ramp):
    table = numbers(ramp("film.csv", "--quantity", "transmittance").read_text().splitlines()[4:])
    film = [[1, 0], [1.33, 0], [1.5, 0]]
    expected = exact_colour(nacre, film, [200], 40, quantity="T", illuminant="D50")
    assert table[2, 1:] == pytest.approx(expected, abs=1e-8)


def test_a_factor_on_all_layers(nacre, tmp_path):
    source = tmp_path / "mirror.json"
    stack = {
        "ambient": {"n": 1.0},
        "layer": [{"n": 2.3, "thickness_nm": 60}, {"n": 1.45, "thickness_nm": 95}],
        "substrate": {"n": 1.5},
        "stack": {"scale": {"default": 1.0, "min": 0.8, "max": 1.2}},
    }
    source.write_text(json.dumps(stack))
    path = tmp_path / "mirror.csv"
    nacre.ok("bake", "ramp", source, "--size", "2", "-o", path)
    *_, header, _, last = path.read_text().splitlines()
    assert header == "thickness_scale,R,G,B"
    expected = exact_colour(nacre, [1, 2.3, 1.45, 1.5], [72, 114], 0)
    assert numbers([last])[0] == pytest.approx([1.2, *expected], abs=1e-8)


def test_bad_input(nacre, film_json, templates, tmp_path):
    path = tmp_path / "film.exr"
    assert "must end in .cube, .spi1d or .csv" in nacre.fails("bake", "ramp", film_json, "-o", path)
    good = tmp_path / "film.csv"
    error = nacre.fails("bake", "ramp", film_json, "--size", "1", "-o", good)
    assert "--size" in error
    assert "--angle" in nacre.fails("bake", "ramp", film_json, "--angle", "90", "-o", good)
    error = nacre.fails("bake", "ramp", templates / "cd.toml", "-o", good)
    assert "must be a film: no other kind has a ramp" in error
    fixed = tmp_path / "fixed.json"
    record = json.loads(film_json.read_text())
    record["layer"][0]["thickness_nm"] = 200
    fixed.write_text(json.dumps(record))
    error = nacre.fails("bake", "ramp", fixed, "-o", good)
    assert "must have a thickness that varies, or the stack a scale" in error
    assert not good.exists()
