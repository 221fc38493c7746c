# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Lamps that are exchanged after the render."""

from __future__ import annotations

import json

import colour
import numpy as np
import OpenImageIO as oiio

from nacre import library
from support.images import read_image
from support.spectral import delta_e, read_spectral
from support.tool import nacre

CHART = [key for key in library.keys("spectra") if key.startswith("colorchecker/")][:12]


def test_an_exchanged_lamp_is_as_if_it_had_been_there(blender, record_property):
    """Asked for: within ΔE00 0.05."""
    folder = blender.folder / "groups"
    folder.mkdir()
    said = blender.call(
        "spectral.lights.groups",
        **{"reflectances": CHART, "light": "A", "other": "F11", "folder": str(folder)},
        samples=16 * 32,
    )
    assert said["left"] == []
    buffer = oiio.ImageBuf(str(folder / "before.exr"))
    lights = json.loads(buffer.spec()["nacre:lights"])
    assert [(entry["layer"], entry["light"]) for entry in lights] == [("Key", "A"), ("Fill", "D65")]
    names = buffer.spec().channelnames
    pixels = buffer.get_pixels(oiio.FLOAT)

    def of(prefix: str) -> np.ndarray:
        return pixels[..., [at for at, name in enumerate(names) if name.startswith(prefix)]]

    np.testing.assert_allclose(of("Key.S0.") + of("Fill.S0."), of("S0."), rtol=1e-5, atol=1e-6)
    nacre("develop", folder / "before.exr", "--light", "Key=F11", "-o", folder / "developed.exr")
    expected, _ = read_spectral(folder / "after.exr")
    before, _ = read_spectral(folder / "before.exr")
    to_xyz = colour.RGB_COLOURSPACES["sRGB"].matrix_RGB_to_XYZ.T
    found = read_image(folder / "developed.exr") @ to_xyz
    white = expected[2, -2] / expected[2, -2, 1]
    scale = expected[2, -2, 1]
    errors = delta_e(found / scale, expected / scale, white)
    record_property("delta_e", f"mean {errors.mean():.4f}, max {errors.max():.4f}")
    print(f"mean {errors.mean():.4f}, max {errors.max():.4f}")
    assert errors.max() <= 0.05
    assert delta_e(before / scale, expected / scale, white).mean() > 2.0
