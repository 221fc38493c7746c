# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectral pictures in Blender's image editor: what the panel shows is what `nacre develop` writes."""

from __future__ import annotations

import json

import numpy as np
import pytest
from nacre_extension.core import spectral_image
from nacre_extension.core.exr import ExrError
from nacre_extension.core.exr_write import ExrWriter
from nacre_extension.core.space import REC709
from nacre_extension.core.spectral_image import BandTable

import nacre
from support.images import read_image
from support.tool import nacre as tool

SIZE = 24, 16
RANDOM = np.random.default_rng(28)
WISHES = {
    "as rendered": [],
    "wide": ["--observer", "cie1964"],
    "camera": ["--camera", "nikon-d5100", "--white", "A", "--exposure", "1"],
    "evening": ["--light", "Key=lamp/hps", "--strength", "Window=0.2"],
    "white place": ["--white-at", "3,4"],
}


def write(path, groups):
    """Smooth reflectances under lamps, each a light group."""
    bands = nacre.bands(24, list(groups.values()))
    knots = RANDOM.random((SIZE[1], SIZE[0], 5))
    at = np.linspace(360.0, 830.0, 5)
    surfaces = np.stack(
        [[np.interp(bands.wavelength_nm, at, pixel) for pixel in row] for row in knots]
    )
    powers = {}
    for name, light in groups.items():
        power = bands.in_bands(light)
        powers[name] = power / bands.xyz(power)[1]
    layers = {name: (surfaces * power).astype(np.float32) for name, power in powers.items()}
    whole = np.sum(list(layers.values()), axis=0)
    table = BandTable("cie1931", bands.edges_nm, bands.wavelength_nm, bands.XYZ, bands.is_line)
    lights = [
        {"layer": name, "light": groups[name], "power": list(power)}
        for name, power in powers.items()
    ]
    if len(groups) == 1:
        layers, lights = {}, [{**lights[0], "layer": ""}]
    spectral_image.write(path, table, REC709, whole, groups=layers, lights=lights)


@pytest.fixture
def picture(tmp_path):
    path = tmp_path / "shop.exr"
    write(path, {"Key": "A", "Window": "D65"})
    return path


def test_the_panel_shows_what_the_tool_writes(blender, picture, tmp_path):
    said = json.loads(blender.script("develop/panel", picture, tmp_path).splitlines()[-1])
    assert set(said) == set(WISHES)
    for name, options in WISHES.items():
        tool("develop", picture, *options, "-o", tmp_path / "tool.exr")
        shown = np.load(tmp_path / f"{name}.npy")
        np.testing.assert_allclose(shown, read_image(tmp_path / "tool.exr"), rtol=1e-4, atol=1e-5)
    places = ("--region", "3,4", "--region", "20,9", "--spectra", tmp_path / "tool.csv")
    tool("develop", picture, *WISHES["evening"], *places)
    own, other = (
        np.loadtxt(tmp_path / f"{n}.csv", delimiter=",", skiprows=1) for n in ("own", "tool")
    )
    np.testing.assert_allclose(own, other, rtol=1e-5)
    headings = [
        (tmp_path / f"{n}.csv").read_text("utf-8").partition("\n")[0] for n in ("own", "tool")
    ]
    assert headings[0] == headings[1]


def test_lamps_of_one_light_are_exchanged_and_places_compared(blender, tmp_path):
    path = tmp_path / "one.exr"
    write(path, {"Key": "D65"})
    said = json.loads(blender.script("develop/compare", path).splitlines()[-1])
    places = ("--region", "3,4", "--region", "20,9")
    (under,) = json.loads(tool("develop", path, *places, "--under", "A", "--json"))["under"]
    assert said["difference"] == pytest.approx(under["dE00"], rel=1e-6)
    assert said["index"] == pytest.approx(under["index"], rel=1e-6)


def test_a_picture_comes_back_as_it_was_written(picture):
    found = spectral_image.read(picture)
    assert found.size == SIZE
    assert set(found.layers) == {"", "Key", "Window"}
    assert {name: lamps.light for name, lamps in found.lamps.items()} == {
        "Key": "A",
        "Window": "D65",
    }
    np.testing.assert_allclose(
        found.layers[""], found.layers["Key"] + found.layers["Window"], rtol=1e-5
    )
    assert found.alpha is None


def test_pictures_of_other_programs_have_bands_around_their_wavelengths(tmp_path):
    path, names = tmp_path / "a.exr", ["S0.700,000nm", "S0.400,000nm", "A", "S0.550,000nm"]
    with ExrWriter(path, 3, 2, names, {}) as writer:
        writer.append(np.arange(24, dtype=np.float32).reshape(2, 3, 4))
    found = spectral_image.read(path)
    assert found.table is None
    assert found.wavelength_nm.tolist() == [400.0, 550.0, 700.0]
    assert found.layers[""][0, 0].tolist() == [1.0, 3.0, 0.0]
    assert found.alpha[0].tolist() == [2.0, 6.0, 10.0]


@pytest.mark.parametrize(
    ("names", "attributes", "message"),
    [
        (["R"], {}, "has no spectra"),
        (["S0.4nm"], {"nacre:bands": "{"}, "nacre:bands: cannot be read"),
        (["S0.4nm"], {"nacre:bands": '{"version": 9}'}, "made by a newer Nacre"),
        (["S0.400,000nm", "Key.S0.410,000nm"], {}, "Key has no channel of 400.000 nm"),
        (["S0.400,000nm"], {"nacre:lights": '[{"layer": "", "light": "A"}]'}, "nacre:lights"),
        (
            ["S0.400,000nm"],
            {"nacre:lights": '[{"layer": "Key", "light": "A", "power": [1]}]'},
            "nacre:lights: cannot be read",
        ),
    ],
)
def test_what_is_no_spectral_picture_is_named(tmp_path, names, attributes, message):
    path = tmp_path / "a.exr"
    with ExrWriter(path, 3, 2, names, attributes) as writer:
        writer.append(np.zeros((2, 3, len(names)), np.float32))
    with pytest.raises(ExrError, match=message) as caught:
        spectral_image.read(path)
    assert str(path) in str(caught.value)
