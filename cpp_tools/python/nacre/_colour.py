# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours of spectra."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._native import NacreError, check, doubles, lib, text


class Colour(NamedTuple):
    """Three arrays of shape (3,)."""

    XYZ: np.ndarray
    Lab: np.ndarray
    rgb: np.ndarray


def spectrum_to_colour(
    wavelength_nm: ArrayLike,
    values: ArrayLike,
    kind: str = "reflectance",
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
) -> Colour:
    """CIE XYZ, L*a*b* and scene-linear RGB of one spectrum.

    Parameters
    ----------
    wavelength_nm, values : float, shape (samples,)
        Ascending wavelengths in nm. In between Sprague's interpolation where six or more stand in
        equal steps, else linear; outside the nearest sample. Summed over 360-830 nm at 1 nm.
    kind : "reflectance" or "emission"
        Reflectance (or transmittance) is lit by `illuminant` and a perfect white is (1, 1, 1);
        an equal-energy emission of 1 has Y = 1.
    illuminant : "D65", "A", "E", ...
    observer : "cie1931" (2 degrees) or "cie1964" (10 degrees)
    space : "lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene" or "xyz_d65"

    Raises
    ------
    NacreError
        Unequal lengths, wavelengths that do not ascend, unknown names (the message lists them).

    Source: CIE 015:2018.
    """
    if kind not in ("reflectance", "emission"):
        raise NacreError(f"kind: must be 'reflectance' or 'emission' (got {kind!r})")
    wavelengths = doubles(wavelength_nm, "wavelength_nm")
    if wavelengths.ndim != 1:
        raise NacreError(f"wavelength_nm: must have one axis (got {wavelengths.ndim})")
    samples = doubles(values, "values", wavelengths.shape)
    colour = _native.Colour()
    check(
        lib.nacre_spectrum_to_colour(
            len(wavelengths),
            wavelengths.ctypes.data,
            samples.ctypes.data,
            int(kind == "reflectance"),
            text(illuminant, "illuminant"),
            text(observer, "observer"),
            text(space, "space"),
            ctypes.byref(colour),
        )
    )
    return Colour(np.array(colour.XYZ), np.array(colour.Lab), np.array(colour.rgb))
