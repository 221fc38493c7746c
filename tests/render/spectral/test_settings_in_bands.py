# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Bands with whatever else a scene may have set: kept, or left out and put back."""

from __future__ import annotations

import numpy as np
import OpenImageIO as oiio
import pytest

from support.images import read_image
from support.spectral import delta_e_of_parts


@pytest.fixture(scope="module")
def settings(blender):
    said = blender.call(
        "spectral.settings.settings", folder=str(blender.folder), size=64, samples=8, passes=8
    )
    pictures = {}
    for name in ("plain", "clean", "truth", "awkward"):
        file = oiio.ImageBuf(str(blender.folder / f"{name}.exr"))
        channels = file.spec().channelnames
        pixels = file.get_pixels(oiio.FLOAT)
        pictures[name] = {channel: pixels[..., i] for i, channel in enumerate(channels)}
    return said, pictures


def test_denoising_takes_most_of_the_noise(settings):
    """Of RGB; the bands stay as they were rendered."""
    _, pictures = settings
    truth, plain, clean = (
        np.stack([pictures[name][c] for c in "RGB"], axis=-1)
        for name in ("truth", "plain", "clean")
    )
    noise, left = (np.sqrt(np.mean((found - truth) ** 2)) for found in (plain, clean))
    assert left < 0.6 * noise
    np.testing.assert_allclose(clean.mean((0, 1)), truth.mean((0, 1)), rtol=0.01)
    for name, values in pictures["plain"].items():
        if name.startswith("S0."):
            np.testing.assert_array_equal(pictures["clean"][name], values)


def test_settings_that_get_in_the_way_are_left_out_and_put_back(settings):
    said, pictures = settings
    assert not said["changed"]
    plain, awkward = pictures["plain"], pictures["awkward"]
    assert set(awkward) - set(plain) == {"A"}
    inside = awkward["A"] == 1.0
    assert 0.3 < inside.mean() < 1.0
    for name in plain:
        np.testing.assert_array_equal(awkward[name][inside], plain[name][inside])


@pytest.mark.parametrize(
    "what",
    ["path guiding", "clamping", "volumes", "motion blur", "view layers", "depth of field"],
)
def test_what_goes_with_bands(blender, what):
    """A room of diffuse colours looks as it does in RGB, but for what is saturated twice over; the rest is
    noise."""
    blender.see_in("5.2")
    said = blender.call(
        "spectral.settings.tried",
        what=what, folder=str(blender.folder), size=64, samples=64, triples=8,
    )  # fmt: skip
    assert not said["remarks"]
    before, again, bands = (
        read_image(blender.folder / f"{name}.exr")[..., :3] for name in ("before", "again", "bands")
    )
    np.testing.assert_allclose(bands.mean((0, 1)), before.mean((0, 1)), rtol=0.02)
    assert delta_e_of_parts(bands, before) < 0.3 + 1.2 * delta_e_of_parts(again, before)
