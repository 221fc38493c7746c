# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre bake stack`: tables of films, checked texel by texel against `nacre eval`."""

from __future__ import annotations

import json

import colour
import numpy as np
import OpenImageIO as oiio
import pytest

from support.exact import colours_of_spectra, exact_colour
from support.images import json_attribute, read_all, spec_of

GRID = list(range(360, 831))


@pytest.fixture(scope="session")
def soap_table(nacre, templates, tmp_path_factory):
    path = tmp_path_factory.mktemp("bake") / "soap.exr"
    nacre.ok("bake", "stack", templates / "soap_film.toml", "-o", path)
    return path


def test_texels_are_the_exact_colours(nacre, film_json, tmp_path):
    path = tmp_path / "film.exr"
    nacre.ok("bake", "stack", film_json, "--size", "5x3", "-o", path)
    pixels, _ = read_all(path)
    assert pixels.shape == (3, 5, 3)
    stacks = [  # row 0 holds the minimum
        {"n": [[1, 0], [1.33, 0], [1.5, 0]], "d_nm": [nm], "angle_deg": np.degrees(np.arccos(c))}
        for nm in (0, 200, 400)
        for c in (0.25, 0.5, 0.75, 1.0)
    ]
    expected = colours_of_spectra(nacre, stacks).reshape(3, 4, 3)
    np.testing.assert_allclose(pixels[:, 1:], expected, rtol=0, atol=1e-6)
    # At grazing angles everything is a mirror.
    assert pixels[:, 0] == pytest.approx(np.ones((3, 3)), abs=1e-6)


def test_transmittance(nacre, film_json, tmp_path):
    path = tmp_path / "film.exr"
    options = ("--quantity", "transmittance", "--size", "3x2", "--illuminant", "A")
    nacre.ok("bake", "stack", film_json, *options, "-o", path)
    pixels, attributes = read_all(path)
    assert attributes["nacre:quantity"] == "transmittance"
    assert attributes["nacre:illuminant"] == "A"
    expected = exact_colour(
        nacre, [[1, 0], [1.33, 0], [1.5, 0]], [400], 0, quantity="T", illuminant="A"
    )
    assert pixels[1, 2] == pytest.approx(expected, abs=1e-6)


def test_colours_may_have_the_light_in_them(nacre, film_json, tmp_path):
    """A surface of R = ((n - 1) / (n + 1))^2 at all wavelengths has the colour of the light: CIE A,
    by the coordinates that CIE 15 prints."""
    path = tmp_path / "film.exr"
    options = ("--size", "2x3", "--illuminant", "A", "--cat", "none")
    nacre.ok("bake", "stack", film_json, *options, "-o", path)
    pixels, attributes = read_all(path)
    assert attributes["nacre:adaptation"] == "none"
    to_xyz = colour.RGB_COLOURSPACES["sRGB"].matrix_RGB_to_XYZ
    light = np.linalg.solve(to_xyz, colour.xy_to_XYZ([0.44757, 0.40745]))
    np.testing.assert_allclose(pixels[0, 1], 0.04 * light, rtol=2e-3)  # no film, seen from above
    nacre.ok("bake", "stack", film_json, *options[:-2], "-o", path)
    pixels, attributes = read_all(path)
    assert attributes["nacre:adaptation"] == "bradford"
    np.testing.assert_allclose(pixels[0, 1], 0.04, rtol=1e-5)


def test_template_table_says_what_it_is(soap_table):
    pixels, attributes = read_all(soap_table)
    height, width, _ = pixels.shape
    assert json_attribute(attributes, "axes") == [
        {"name": "cos_theta", "unit": "1", "min": 0.0, "max": 1.0, "mapping": "linear"},
        {"name": "thickness_nm", "unit": "nm", "min": 20.0, "max": 1500.0, "mapping": "linear"},
    ]
    assert width >= 2
    assert height > 100  # nine fringes of the thickest film
    error = json_attribute(attributes, "error")
    assert error["unit"] == "dE00"
    assert 0 < error["mean"] < error["max"] <= 0.1
    stack = json_attribute(attributes, "stack")
    assert stack["ambient"] == {"medium": "air"}
    assert stack["layer"][0]["thickness_nm"] == {
        "default": 400.0,
        "min": 20.0,
        "max": 1500.0,
        "varies": True,
    }
    assert attributes["nacre:illuminant"] == "D65"
    assert attributes["nacre:observer"] == "cie1931"
    assert attributes["nacre:space"] == "lin_rec709_scene"
    assert attributes["colorInteropID"] == "lin_rec709_scene"
    assert attributes["chromaticities"] == pytest.approx(
        (0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329), abs=1e-6
    )
    assert attributes["wrapmodes"] == "clamp,clamp"
    assert attributes["nacre:quantity"] == "reflectance"


def test_the_thinnest_film_is_nearly_black(nacre, soap_table):
    """Row 0, cosθ = 1: 20 nm of water in air, from the optical constants of the library."""
    entry = json.loads(
        nacre.ok(
            "library", "show", "water/Daimon-20C", "--json", *[w for x in GRID for w in ("--at", x)]
        )
    )
    records = [
        {
            "n": [1, [at["n"], at["k"]], 1],
            "d_nm": [20],
            "angle_deg": 0,
            "wavelength_nm": at["wavelength_nm"],
            "pol": "u",
        }
        for at in entry["at"]
    ]
    values = [answer["R"] for answer in nacre.evaluate("stack", records)]
    spectrum = {"wavelength_nm": GRID, "values": values, "kind": "reflectance"}
    expected = nacre.evaluate("spectrum", spectrum)["rgb"]
    assert read_all(soap_table)[0][0, -1] == pytest.approx(expected, rel=1e-5)


def test_colours_outside_the_gamut_are_kept(soap_table):
    assert read_all(soap_table)[0].min() < 0


def test_the_stack_in_the_file_bakes_the_same_file(nacre, soap_table, tmp_path):
    stack = json.loads(nacre.ok("info", soap_table, "--json"))["stack"]
    again = tmp_path / "again.exr"
    nacre.ok("bake", "stack", "-", "-o", again, stdin=json.dumps(stack))
    assert again.read_bytes() == soap_table.read_bytes()


def test_tolerance_decides_the_size(nacre, film_json, tmp_path):
    coarse, fine = tmp_path / "coarse.exr", tmp_path / "fine.exr"
    nacre.ok("bake", "stack", film_json, "--tolerance", "1", "-o", coarse)
    nacre.ok("bake", "stack", film_json, "--tolerance", "0.05", "-o", fine)
    coarse_pixels, coarse_attributes = read_all(coarse)
    fine_pixels, fine_attributes = read_all(fine)
    assert coarse_pixels.size < fine_pixels.size
    assert json_attribute(coarse_attributes, "error")["max"] <= 1
    assert json_attribute(fine_attributes, "error")["max"] <= 0.05


def test_half_tables_measure_their_own_error(nacre, film_json, tmp_path):
    single, half = tmp_path / "float.exr", tmp_path / "half.exr"
    nacre.ok("bake", "stack", film_json, "-o", single)
    nacre.ok("bake", "stack", film_json, "--depth", "half", "-o", half)
    assert spec_of(half).format == oiio.HALF
    exact, rounded = (
        json_attribute(read_all(single)[1], "error"),
        json_attribute(read_all(half)[1], "error"),
    )
    assert rounded["mean"] > exact["mean"]
    assert rounded["max"] < 0.5


def test_tx_is_tiled_without_mip_maps(nacre, film_json, tmp_path):
    exr, tx = tmp_path / "film.exr", tmp_path / "film.tx"
    nacre.ok("bake", "stack", film_json, "--size", "100x70", "-o", exr)
    nacre.ok("bake", "stack", film_json, "--size", "100x70", "-o", tx)
    assert (spec_of(tx).tile_width, spec_of(tx).tile_height) == (64, 64)
    levels = oiio.ImageInput.open(str(tx))
    assert not levels.seek_subimage(0, 1)  # there is no second level
    assert np.array_equal(read_all(exr)[0], read_all(tx)[0])


def test_threads_do_not_change_the_bytes(nacre, film_json, tmp_path):
    one, two = tmp_path / "one.exr", tmp_path / "two.exr"
    nacre.ok("--threads", "1", "bake", "stack", film_json, "-o", one)
    nacre.ok("bake", "stack", film_json, "--threads", "2", "-o", two)
    assert one.read_bytes() == two.read_bytes()


def film(**change):
    layer = {"n": 1.33, "thickness_nm": 200, **change.pop("layer", {})}
    return {"ambient": {"n": 1.0}, "layer": [layer], "substrate": {"n": 1.5}, **change}


VARIES = {"thickness_nm": {"default": 5, "min": 10, "max": 20, "varies": True}}
BAD_STACKS = {
    "negative-thickness": (film(layer={"thickness_nm": -5}), ["thickness_nm", "-5"]),
    "nan-thickness": (film(layer={"thickness_nm": float("nan")}), ["thickness_nm", "nan"]),
    "zero-index": (film(layer={"n": 0}), ["n", "0"]),
    "gain": (film(layer={"k": -0.1}), ["k", "-0.1"]),
    "unknown-medium": (film(substrate={"medium": "unobtainium/Smith"}), ["unobtainium/Smith"]),
    "unknown-key": (film(colour="red"), ["colour"]),
    "default-outside-range": (film(layer=VARIES), ["thickness_nm"]),
    "65-layers": ({**film(), "layer": [{"n": 1.4, "thickness_nm": 10}] * 65}, ["layer", "64"]),
    "null": (film(substrate=None), ["null"]),
    "two-forms": (film(layer={"medium": "air"}), ["exactly one"]),
}


@pytest.mark.parametrize("name", BAD_STACKS)
def test_bad_stack(nacre, tmp_path, name):
    stack, words = BAD_STACKS[name]
    target = tmp_path / "film.exr"
    errors = nacre.fails("bake", "stack", "-", "-o", target, stdin=json.dumps(stack))
    assert errors.startswith("nacre bake stack: -")
    for word in words:
        assert word in errors
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--tolerance", "0"), "--tolerance: must be > 0 (got 0)"),
        (("--tolerance", "nan"), "--tolerance: must be > 0 (got nan)"),
        (("--tolerance", "x"), "--tolerance"),
        (("--size", "5"), "--size: must be WIDTHxHEIGHT"),
        (("--size", "1x1"), "--size: must be WIDTHxHEIGHT"),
        (("--size", "9999x9999"), "--size: must be WIDTHxHEIGHT"),
        (("--illuminant", "F99"), "F99"),
        (("--observer", "me"), "me"),
        (("--space", "srgb"), "srgb"),
        (("--threads", "-1"), "--threads"),
        (("--frobnicate",), "--frobnicate"),
    ],
)
def test_bad_option(nacre, film_json, tmp_path, options, message):
    target = tmp_path / "film.exr"
    assert message in nacre.fails("bake", "stack", film_json, *options, "-o", target)
    assert not target.exists()


def test_a_table_does_not_fit_into_bytes(nacre, film_json, tmp_path):
    target = tmp_path / "film.png"
    assert "must end in .exr, .tx or .ftxt" in nacre.fails("bake", "stack", film_json, "-o", target)
