# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small pictures that a panel shows: colours over angle and thickness, and a spectrum. Arrays are
float32 (height, width, 4), display-referred sRGB, bottom row first as Blender wants them."""

from __future__ import annotations

import numpy as np

SIZE = 256
CHIP = 16
LAST_ANGLE_DEG = 85.0
FIRST_NM, LAST_NM = 380.0, 780.0

_BACKGROUND, _GRID, _LINE = 0.11, 0.2, 0.92


def encode(linear: np.ndarray) -> np.ndarray:
    """sRGB of linear Rec.709; what is out of gamut is held to it."""
    held = np.clip(linear, 0.0, 1.0)
    return np.where(held <= 0.0031308, 12.92 * held, 1.055 * held ** (1.0 / 2.4) - 0.055)


def swatch(reflectance: np.ndarray) -> np.ndarray:
    """`reflectance`: (H, W, 3) over cosθ from 0 to 1, row 0 the least thickness. The picture has
    normal incidence on the left and 85° on the right, the least thickness at the bottom."""
    height, width = reflectance.shape[:2]
    angle = np.radians(np.linspace(0.0, LAST_ANGLE_DEG, SIZE))
    column = np.cos(angle) * (width - 1)
    left = np.minimum(column.astype(int), width - 2)
    t = (column - left)[None, :, None]
    across = reflectance[:, left] * (1.0 - t) + reflectance[:, left + 1] * t
    rows = np.linspace(0.0, height - 1, SIZE).round().astype(int)
    return _with_alpha(encode(across[rows]))


def chip(rgb: tuple[float, float, float]) -> np.ndarray:
    """One display-referred colour."""
    picture = np.empty((CHIP, CHIP, 4), dtype=np.float32)
    picture[:] = (*rgb, 1.0)
    return picture


def spectrum(reflectance: np.ndarray, colour_matching: np.ndarray) -> np.ndarray:
    """`reflectance`: (471,) from 360 nm; `colour_matching`: (471, 3), linear Rec.709 of each
    wavelength. The area under the curve has the colours of the wavelengths; lines at every 100 nm
    and every quarter."""
    picture = np.full((SIZE, SIZE, 3), _BACKGROUND)
    wavelength = np.linspace(FIRST_NM, LAST_NM, SIZE)
    level = (np.arange(SIZE) + 0.5)[:, None] / SIZE
    grid = 360.0 + np.arange(471)
    value = np.interp(wavelength, grid, reflectance)[None, :]
    hue = np.stack([np.interp(wavelength, grid, channel) for channel in colour_matching.T], axis=-1)
    hue = np.clip(hue, 0.0, None)
    hue = 0.75 * encode(hue / hue.max())
    picture[(np.abs(level * 4 - np.round(level * 4)) < 2.0 / SIZE)[:, 0], :] = _GRID
    picture[:, np.abs(wavelength - 100.0 * np.round(wavelength / 100.0)) < 0.9] = _GRID
    picture = np.where((level < value)[..., None], hue[None], picture)
    # The curve is as thick where it is steep.
    slope = np.abs(np.gradient(value[0])) * SIZE
    near = np.abs(level - value) * SIZE < 1.2 * np.sqrt(1.0 + slope**2)
    picture[near] = _LINE
    return _with_alpha(picture)


def _with_alpha(picture: np.ndarray) -> np.ndarray:
    result = np.ones((SIZE, SIZE, 4), dtype=np.float32)
    result[..., :3] = picture
    return result
