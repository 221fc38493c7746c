# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectral pictures of patches, as a render would have written them."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

import nacre

SIZE = 2  # pixels of a patch


def power_of(bands: nacre.Bands, light: str) -> np.ndarray:
    """Of Y = 1."""
    power = bands.in_bands(light)
    return power / bands.xyz(power)[1]


def table_of(bands: nacre.Bands) -> dict:
    return {
        "version": 1,
        "observer": bands.observer,
        "edges_nm": list(bands.edges_nm),
        "wavelength_nm": list(bands.wavelength_nm),
        "xyz": bands.XYZ.tolist(),
        "is_line": [bool(line) for line in bands.is_line],
    }


def write(path: Path, bands, layers: dict, lights=None, table=None, size: int = SIZE) -> Path:
    """A row of patches; layers: radiance (patches, N) by name of a light group, the whole without. Without
    a table of bands where `table` is False."""
    names = [_channel(nm) for nm in bands.wavelength_nm]
    names = [f"{layer}.{name}" if layer else name for layer in layers for name in names]
    values = np.concatenate(list(layers.values()), axis=-1)
    pixels = np.repeat(np.repeat(values[None], size, 0), size, 1).astype(np.float32)
    spec = oiio.ImageSpec(pixels.shape[1], size, len(names), oiio.FLOAT)
    spec.channelnames = names
    if table is not False:
        spec.attribute("nacre:bands", json.dumps(table or table_of(bands)))
    if lights is not None:
        spec.attribute("nacre:lights", json.dumps(lights))
    buffer = oiio.ImageBuf(spec)
    buffer.set_pixels(oiio.ROI(), pixels)
    assert buffer.write(str(path)), buffer.geterror()
    return path


def shop(path: Path) -> Path:
    """Three patches of 50 pixels under two light groups of daylight."""
    bands = nacre.bands(24, ["D65"])
    power = power_of(bands, "D65")
    patches = np.linspace(0.2, 0.8, 3)[:, None] * np.linspace(1.0, 0.5, len(bands)) * power
    layers = {"": patches, "Ceiling": 0.7 * patches, "Window": 0.3 * patches}
    lights = [{"layer": name, "light": "D65", "power": list(power)} for name in layers]
    return write(path, bands, layers, lights, size=50)


def _channel(nm: float) -> str:
    return f"S0.{nm:.3f}nm".replace(".", ",").replace("S0,", "S0.", 1)
