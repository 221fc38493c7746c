# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Observer, lights and surfaces at 0.1 nm, by colour-science."""

from __future__ import annotations

import colour
import numpy as np
import OpenImageIO as oiio

from nacre import library

from .colours import delta_e as of_rgb

OBSERVERS = {
    "cie1931": "CIE 1931 2 Degree Standard Observer",
    "cie1964": "CIE 1964 10 Degree Standard Observer",
}
FINE = 360.05 + 0.1 * np.arange(4700)


def observer_at(nm, observer="cie1931"):
    cmfs = colour.MSDS_CMFS[OBSERVERS[observer]]
    cmfs = cmfs.copy().align(colour.SpectralShape(360, 830, 1))
    return np.stack([np.interp(nm, cmfs.wavelengths, cmfs.values[:, c]) for c in range(3)], -1)


def light_at(name):
    """Wavelengths and power of each."""
    if name.startswith("line:"):
        pairs = [part.split("@") for part in name.removeprefix("line:").split(",")]
        return tuple(np.array(column, dtype=float) for column in zip(*pairs, strict=True))
    if name.startswith("lamp/"):
        lamp = library.spectrum(name)
        return FINE, np.interp(FINE, lamp.wavelength_nm, lamp.values)
    name = f"FL{name[1:]}" if name.startswith("F") else name
    lamp = colour.SDS_ILLUMINANTS[name]
    return FINE, np.interp(FINE, lamp.wavelengths, lamp.values)


def reflectance_at(key, nm):
    patch = library.spectrum(key)
    samples = colour.SpectralDistribution(patch.values, patch.wavelength_nm)
    fine = samples.align(colour.SpectralShape(360, 830, 1)).values
    return np.interp(nm, np.arange(360, 831), fine)


def delta_e(a, b, white):
    """CIEDE2000 of XYZ, relative to a white of Y = 1."""
    xy = colour.XYZ_to_xy(white)
    return colour.delta_E(colour.XYZ_to_Lab(a, xy), colour.XYZ_to_Lab(b, xy))


def delta_e_of_parts(found, expected):
    """Mean CIEDE2000 of two square pictures in linear Rec.709 by parts of 4 x 4 pixels, noise being what it
    is, as if the mean of the one that is expected were 30 % grey."""

    def parts(picture):
        size = len(picture) // 4
        return picture.reshape(size, 4, size, 4, 3).mean(axis=(1, 3)) * 0.3 / expected.mean()

    return of_rgb(parts(found), parts(expected)).mean()


def read_spectral(file):
    """XYZ of RGB, and how many bands there are."""
    buffer = oiio.ImageBuf(str(file))
    names = buffer.spec().channelnames
    pixels = buffer.get_pixels(oiio.FLOAT)
    rgb = pixels[..., [names.index(name) for name in "RGB"]]
    xyz = rgb @ colour.RGB_COLOURSPACES["sRGB"].matrix_RGB_to_XYZ.T
    return xyz, sum(name.startswith("S0.") for name in names)
