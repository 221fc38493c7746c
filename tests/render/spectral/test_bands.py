# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes rendered in bands against sums over 0.1 nm by colour-science."""

from __future__ import annotations

import os

import colour
import numpy as np
import OpenImageIO as oiio
import pytest

import nacre
from nacre import library
from support.images import read_channels, read_image
from support.spectral import (
    delta_e,
    delta_e_of_parts,
    light_at,
    observer_at,
    read_spectral,
    reflectance_at,
)
from support.truth import material_template, spectra

LIGHTS = ["D65", "A", "F2", "F11", "LED-B3", "lamp/hps", "line:462@1,532@0.8,638@1.2"]
SHOWN_BY_EEVEE = LIGHTS if os.environ.get("NACRE_SOAK") else LIGHTS[3:4]
CHART = [key for key in library.keys("spectra") if key.startswith("colorchecker/")]
SIZE = 4
"""Pixels of a patch."""
COUNT = 200 if os.environ.get("NACRE_SOAK") else 40
"""Of materials that chance makes."""


def exact(light):
    """XYZ of the chart, where white has Y = 1, and of white."""
    nm, power = light_at(light)
    seen = observer_at(nm) * power[:, None]
    white = seen.sum(axis=0)
    chart = np.array([reflectance_at(key, nm) @ seen for key in CHART])
    return chart / white[1], white / white[1]


@pytest.fixture(scope="module")
def chart(blender):
    """XYZ of the middle of each patch."""
    file = blender.folder / "chart.exr"
    said = blender.call(
        "spectral.scenes.chart",
        reflectances=CHART, lights=LIGHTS, file=str(file), size=SIZE, samples=8, passes=0,
    )  # fmt: skip
    assert not said["left"]
    xyz, bands = read_spectral(file)
    assert bands == 3 * said["passes"]
    return xyz[SIZE // 2 :: SIZE, SIZE // 2 :: SIZE]


@pytest.mark.parametrize("light", LIGHTS)
def test_chart_has_the_colours_that_it_should(chart, light):
    expected, white = exact(light)
    errors = delta_e(chart[LIGHTS.index(light)], expected, white)
    assert errors.mean() <= 0.1
    assert errors.max() <= 0.3


@pytest.mark.parametrize("light", ["F11", "lamp/hps", LIGHTS[-1]])
def test_matt_patches_under_a_lamp(blender, light):
    """The lamp is as bright as its colour was, and what it shines on has its colour under it."""
    blender.call(
        "spectral.scenes.lit_chart",
        reflectances=CHART, light=light, folder=str(blender.folder), size=SIZE, samples=8, passes=0,
    )  # fmt: skip
    xyz, _ = read_spectral(blender.folder / "bands.exr")
    patches = xyz[SIZE // 2, SIZE // 2 :: SIZE]
    white = patches[-1]
    expected, expected_white = exact(light)
    np.testing.assert_allclose(white / white[1], expected_white, atol=1e-3)
    errors = delta_e(patches[:-1] / white[1], expected, expected_white)
    assert errors.mean() <= 0.1
    assert errors.max() <= 0.3
    before = read_image(blender.folder / "before.exr")
    luminance = colour.RGB_COLOURSPACES["sRGB"].matrix_RGB_to_XYZ[1] @ before[SIZE // 2, -1]
    assert white[1] == pytest.approx(luminance, rel=5e-3)
    np.testing.assert_array_equal(read_image(blender.folder / "after.exr"), before)


FILM = ("anodised_titanium", 110.0)


@pytest.fixture(scope="module")
def chart_in_eevee(blender, request):
    """Shaders are compiled in software, half a minute for a chart: in one version."""
    blender.see_in("4.5")
    displayed = request.getfixturevalue("displayed")
    displayed.call(
        "spectral.scenes.eevee",
        reflectances=CHART, lights=SHOWN_BY_EEVEE, folder=str(displayed.folder), size=SIZE, samples=4,
        film={"material": FILM[0], "values": {"thickness_nm": FILM[1], "roughness": 0.0}},
    )  # fmt: skip
    return displayed.folder


@pytest.mark.parametrize("light", SHOWN_BY_EEVEE)
def test_chart_and_a_film_in_eevee(chart_in_eevee, light, record_property):
    """It keeps the colour of a closure in ten bits, which is much of a dark one, and light in nine with an
    exponent that three channels share: of a laser, which is one band, that is a step of up to 2^-8."""
    xyz, _ = read_spectral(chart_in_eevee / f"{light.replace('/', '_')}.exr")
    *patches, white, film = xyz[SIZE // 2, SIZE // 2 :: SIZE]
    expected, expected_white = exact(light)
    step = 2.0**-8 if light.startswith("line:") else 2e-3
    np.testing.assert_allclose(white / white[1], expected_white, rtol=step)
    errors = delta_e(np.array(patches) / white[1], expected, expected_white)
    record_property("dE00", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f}")
    assert errors.mean() <= 0.5
    nm, power = light_at(light)
    reflectance = spectra(material_template(FILM[0]), FILM[1], np.array([1.0])).R[0]
    seen = observer_at(nm) * power[:, None]
    colour_of_film = np.interp(nm, np.arange(360, 831), reflectance) @ seen / seen.sum(axis=0)[1]
    assert delta_e(film * colour_of_film[1] / film[1], colour_of_film, expected_white) <= 2.0


def test_bands_are_those_of_all_lights():
    bands, choice = nacre.choose_bands(LIGHTS)
    assert choice.met
    assert bands.is_line.sum() == 3


@pytest.fixture(scope="module")
def box(blender):
    said = blender.call(
        "spectral.scenes.box", folder=str(blender.folder), size=48, samples=64, passes=16
    )  # fmt: skip
    pictures = {
        name: read_image(blender.folder / f"{name}.exr") for name in ("before", "rgb", "after")
    }
    pictures["bands"], _ = read_channels(blender.folder / "bands.exr", "RGB")
    return said, pictures


def test_every_colour_gets_a_spectrum_once(box):
    said, _ = box
    # red, painted, mixed, glowing, lamp, world
    assert said["spectra"] == said["removed"] == 6
    assert said["twice"] == 0
    assert not said["remarks"]
    assert not said["left"]
    assert not said["is_spectral"]


def test_undo_is_exact(box):
    _, pictures = box
    np.testing.assert_array_equal(pictures["after"], pictures["before"])


def test_a_spectral_scene_in_rgb_looks_as_before(box):
    _, pictures = box
    assert delta_e_of_parts(pictures["rgb"], pictures["before"]) < 0.3


def test_under_its_own_lights_a_spectral_scene_is_near_the_rgb_one(box):
    _, pictures = box
    mean = [pictures[name].mean(axis=(0, 1)) for name in ("bands", "before")]
    np.testing.assert_allclose(mean[0], mean[1], rtol=0.02)
    assert delta_e_of_parts(pictures["bands"], pictures["before"]) < 1.0


def test_many_materials_and_back(blender):
    """Whatever shaders and sources of colours chance has put together."""
    said = blender.call("spectral.scenes.many", folder=str(blender.folder), count=COUNT, samples=16)
    before, again, after = (
        read_image(blender.folder / f"{name}.exr") for name in ("before", "again", "after")
    )
    np.testing.assert_array_equal(after, before)
    assert said["spectra"] == said["removed"] > 1.5 * COUNT
    assert said["remarks"]
    known = (
        "its link is muted",
        "is RGB; its colours are taken for daylight",
        "thin film is Blender's",
    )
    assert all(any(part in text for part in known) for text in said["remarks"])
    file = oiio.ImageBuf(str(blender.folder / "bands.exr"))
    names = file.spec().channelnames
    pixels = file.get_pixels(oiio.FLOAT)
    assert np.isfinite(pixels).all()
    bands = pixels[..., [names.index(name) for name in "RGB"]]
    # Where light goes through several colours, spectra and RGB differ by nature.
    np.testing.assert_allclose(bands.mean((0, 1)), before.mean((0, 1)), rtol=0.03)
    assert delta_e_of_parts(bands, before) < 1.0 + delta_e_of_parts(again, before)


def test_what_meets_a_spectrum_is_one_too(blender):
    """A measured colour times white is that colour, times another the product in each band."""
    file = blender.folder / "mixed.exr"
    said = blender.call("spectral.mixed.patches", file=str(file), size=SIZE, samples=64)
    buffer = oiio.ImageBuf(str(file))
    names = buffer.spec().channelnames
    pixels = buffer.get_pixels(oiio.FLOAT)[SIZE // 2, SIZE // 2 :: SIZE]
    bands = pixels[:, [at for at, name in enumerate(names) if name.startswith("S0.")]]
    alone, times_white, times_colour, colour, _, into_group, out_of_group, _, _ = bands
    np.testing.assert_allclose(times_white, alone, rtol=1e-3)
    daylight = alone / reflectance_at("colorchecker/blue-sky", wavelengths(names))
    np.testing.assert_allclose(times_colour, alone * colour / daylight, rtol=5e-3)
    rgb = pixels[:, [names.index(channel) for channel in "RGB"]]
    np.testing.assert_allclose(rgb[4], rgb[2], atol=0.02)  # another spectrum of the same colour
    np.testing.assert_allclose(into_group, times_colour, rtol=5e-3)
    np.testing.assert_allclose(out_of_group, times_colour, rtol=5e-3)
    product = np.array([0.9, 0.9, 0.3]) * [0.7, 0.3, 0.1]
    np.testing.assert_allclose(rgb[7] / rgb[3], product / [0.7, 0.3, 0.1], atol=0.15)
    (where, what), *more = said["remarks"]
    assert not more
    assert where.startswith("material ")
    assert what == "Hue/Saturation/Value: takes the spectrum that comes in for RGB"
    assert said["spectra"] == [said["removed"], 0]
    # The sky, colours in a material and two groups, one that goes into a group, alone, and a picture.
    assert said["removed"] == 7


def wavelengths(names):
    return np.array([float(name[3:-2].replace(",", ".")) for name in names if "S0." in name])
