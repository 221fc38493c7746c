# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What shaders have by channel, in bands: indices of metals, distances under skin, and what stays RGB."""

from __future__ import annotations

import colour
import numpy as np
import pytest

from nacre import library
from support.images import read_image
from support.spectral import delta_e, light_at, observer_at

SIZE = 12
METALS = ["Au/Johnson", "Cu/Johnson", "Ag/Johnson", "Al/Rakic"]
MATT, BY_CHANNEL, SKIN = slice(0, 5), slice(5, 7), 7
POLISHED = slice(8, 8 + len(METALS))
TO_XYZ = colour.RGB_COLOURSPACES["sRGB"].matrix_RGB_to_XYZ


def patches(blender, light):
    folder = blender.folder / f"channels_{light.replace('/', '_')}"
    folder.mkdir()
    said = blender.call(
        "spectral.channels.patches",
        folder=str(folder), size=SIZE, samples=512, metals=METALS, light=light,
    )  # fmt: skip
    assert said == {"left": [], "remarks": [], "given": METALS}
    found = {}
    for name in ("before", "bands", "after"):
        pixels = read_image(folder / f"{name}.exr")[..., :3]
        parts = pixels.reshape(SIZE, -1, SIZE, 3)[2:10, :, 2:10]
        found[name] = parts.mean(axis=(0, 2)) @ TO_XYZ.T
    return found


@pytest.fixture(scope="module")
def under_daylight(blender):
    return patches(blender, "D65")


def test_what_is_put_in_comes_out_again(under_daylight):
    np.testing.assert_array_equal(under_daylight["before"], under_daylight["after"])


def test_what_has_channels_has_them_along_the_spectrum(under_daylight):
    white = TO_XYZ @ np.ones(3)
    errors = delta_e(under_daylight["bands"], under_daylight["before"], white)
    assert errors[BY_CHANNEL].max() < 1.0, errors[BY_CHANNEL]
    assert errors[SKIN] < 2.0, errors[SKIN]  # noise: 1


def test_what_stays_rgb_looks_much_as_in_rgb(under_daylight):
    """A third of the spectrum each, as if filters were of one colour: off, but never another hue."""
    white = TO_XYZ @ np.ones(3)
    errors = delta_e(under_daylight["bands"], under_daylight["before"], white)[MATT]
    assert 1.0 < errors.mean() < 6.0, errors
    assert errors.max() < 10.0, errors


@pytest.mark.parametrize("light", ["D65", "F11", "lamp/hps"])
def test_metals_of_the_library_are_exact(blender, under_daylight, light):
    found = under_daylight if light == "D65" else patches(blender, light)
    nm, power = light_at(light)
    seen = observer_at(nm) * power[:, None]
    white = seen.sum(axis=0)
    expected = []
    for key in METALS:
        index = np.interp(nm, np.arange(360, 831), library.medium(key).index_on_grid())
        expected.append((np.abs((index - 1.0) / (index + 1.0)) ** 2) @ seen / white[1])
    errors = delta_e(found["bands"][POLISHED], np.array(expected), white / white[1])
    assert errors.max() < 0.15, errors
