# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours of spectra, and spectra of colours."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi
from ._native import NacreError, check, doubles, lib, text

GRID_NM = np.arange(360.0, 831.0)


class Colour(NamedTuple):
    """Three arrays of shape (..., 3)."""

    XYZ: np.ndarray
    Lab: np.ndarray
    rgb: np.ndarray


class ColourTemperature(NamedTuple):
    """Two arrays of shape (...): kelvin, and the distance from the Planckian locus in CIE 1960 uv,
    positive above it. NaN where a colour has none."""

    cct_K: np.ndarray  # noqa: N815 the unit
    duv: np.ndarray


class RgbSpectrum(NamedTuple):
    """Spectra that have given colours."""

    wavelength_nm: np.ndarray
    """Shape (471,): 360-830 nm at 1 nm."""
    values: np.ndarray
    """Shape (..., 471)."""
    coefficients: np.ndarray | None
    """Shape (..., 3): of the polynomial of the wavelength in nm, highest power first."""
    error_dE00: np.ndarray  # noqa: N815 the letter of CIE 015
    """Shape (...): CIEDE2000 of the round trip under D65; for a light that of its filter."""


def _is_one_of(value: str, name: str, first: str, second: str) -> bool:
    if value not in (first, second):
        raise NacreError(f"{name}: must be {first!r} or {second!r} (got {value!r})")
    return value == first


def spectrum_to_colour(
    wavelength_nm: ArrayLike,
    values: ArrayLike,
    kind: str = "reflectance",
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
    *,
    adaptation: str = "bradford",
    gamut: str = "keep",
) -> Colour:
    """CIE XYZ, L*a*b* and scene-linear RGB of spectra.

    Parameters
    ----------
    wavelength_nm : float, shape (samples,)
    values : float, shape (..., samples)
        Ascending wavelengths in nm. In between Sprague's interpolation where six or more stand in
        equal steps, else linear; outside the nearest sample. Summed over 360-830 nm at 1 nm.
    kind : "reflectance" or "emission"
        Reflectance (or transmittance) is lit by `illuminant` and a perfect white is (1, 1, 1);
        an equal-energy emission of 1 has Y = 1.
    illuminant : "D65", "A", "E", ...
    observer : "cie1931" (2 degrees) or "cie1964" (10 degrees)
    space : "lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene" or "xyz_d65"
    adaptation : "bradford", "cat16" or "none"
        How the white of a reflectance comes to D65 for its rgb.
    gamut : "keep", "clip", "desaturate" or "scale"
        What happens to rgb outside [0, 1]: nothing; each channel cut; towards the grey of the same
        luminance; all channels by one factor.

    Returns
    -------
    Colour, arrays of shape (..., 3)

    Raises
    ------
    NacreError
        Unequal lengths, wavelengths that do not ascend, unknown names (the message lists them).

    Source: CIE 015:2018; Lam 1985 (Bradford); Li et al. 2017 (CAT16).
    """
    reflectance = _is_one_of(kind, "kind", "reflectance", "emission")
    wavelengths = doubles(wavelength_nm, "wavelength_nm")
    if wavelengths.ndim != 1:
        raise NacreError(f"wavelength_nm: must have one axis (got {wavelengths.ndim})")
    samples = doubles(values, "values")
    if samples.ndim == 0 or samples.shape[-1] != len(wavelengths):
        raise NacreError(
            f"values: must have {len(wavelengths)} samples on the last axis "
            f"(got shape {samples.shape})"
        )
    shape = samples.shape[:-1]
    options = _capi.ColourOptions(
        text(illuminant, "illuminant"),
        text(observer, "observer"),
        text(space, "space"),
        text(adaptation, "adaptation"),
        text(gamut, "gamut"),
        int(reflectance),
    )
    colours = np.empty((*shape, 3, 3))
    check(
        lib.nacre_spectra_to_colours(
            int(np.prod(shape)),
            len(wavelengths),
            wavelengths.ctypes.data,
            samples.ctypes.data,
            ctypes.byref(options),
            colours.ctypes.data,
        )
    )
    return Colour(*(np.ascontiguousarray(colours[..., part, :]) for part in range(3)))


def rgb_to_spectrum(
    rgb: ArrayLike,
    method: str = "jakob-hanika",
    kind: str = "reflectance",
    space: str = "lin_rec709_scene",
) -> RgbSpectrum:
    """Spectra that have given colours under D65 and the CIE 1931 observer.

    Parameters
    ----------
    rgb : float, shape (..., 3)
        Scene-linear. White is (1, 1, 1); a light may have any strength.
    method : "jakob-hanika" or "smits"
        Smooth, in [0, 1], exact for all of Rec.709 and most of Rec.2020 and ACEScg; or a sum of
        published spectra of ten bins, off by some hundredths, Rec.709 only.
    kind : "reflectance" or "emission"
        An emission is D65 of Y = 1 through a filter of the colour.
    space : "lin_rec709_scene", "lin_rec2020_scene" or "lin_ap1_scene"

    Returns
    -------
    RgbSpectrum
        `coefficients` is None with "smits".

    Raises
    ------
    NacreError
        A colour that no smooth reflectance has: says how close it comes and names the item.

    Source: Jakob, Hanika, Computer Graphics Forum 38(2), 2019; Smits, Journal of Graphics Tools
    4(4), 1999.
    """
    emission = _is_one_of(kind, "kind", "emission", "reflectance")
    colours = doubles(rgb, "rgb")
    if colours.ndim == 0 or colours.shape[-1] != 3:
        raise NacreError(f"rgb: must have 3 channels on the last axis (got shape {colours.shape})")
    shape = colours.shape[:-1]
    values, error = np.empty((*shape, _capi.WAVELENGTHS)), np.empty(shape)
    coefficients = None if method == "smits" else np.empty((*shape, 3))
    check(
        lib.nacre_rgb_to_spectrum(
            int(np.prod(shape)),
            colours.ctypes.data,
            text(space, "space"),
            text(method, "method"),
            int(emission),
            values.ctypes.data,
            None if coefficients is None else coefficients.ctypes.data,
            error.ctypes.data,
        )
    )
    return RgbSpectrum(GRID_NM.copy(), values, coefficients, error)


def rgb_basis() -> np.ndarray:
    """Reflectances of red, green and blue, float64 (471, 3) over 360-830 nm at 1 nm.

    Their sum is 1 everywhere, and `rgb_basis() @ rgb` has the colour `rgb` of Rec.709 under D65, within
    0 and 1 where the colour is. Linear in the colour, unlike `rgb_to_spectrum`, but less smooth.

    Source: after I. Mallett, C. Yuksel, Spectral Primary Decomposition for Rendering with sRGB
    Reflectance, Eurographics Symposium on Rendering 2019; computed anew.
    """
    values = np.empty((GRID_NM.size, 3))
    check(lib.nacre_rgb_basis(values.ctypes.data))
    return values


def map_range(rgb: ArrayLike, how: str = "normalise") -> np.ndarray:
    """All colours of an image, or of a list, brought into range together.

    Parameters
    ----------
    rgb : float, shape (..., 3)
    how : "none", "clamp" or "normalise"
        Nothing; each channel into [0, 1]; all divided by the largest channel of all, where that is
        > 0.

    Returns
    -------
    float, shape (..., 3), a new array

    Raises
    ------
    NacreError
        Another shape or `how`, and numbers that are not finite.
    """
    colours = np.array(doubles(rgb, "rgb"))
    if colours.ndim == 0 or colours.shape[-1] != 3:
        raise NacreError(f"rgb: must have 3 channels on the last axis (got shape {colours.shape})")
    check(lib.nacre_map_range(colours.size // 3, colours.ctypes.data, text(how, "how")))
    return colours


def colour_temperature(XYZ: ArrayLike) -> ColourTemperature:  # noqa: N803 the letters of the CIE
    """Correlated colour temperature and Duv of colours.

    Parameters
    ----------
    XYZ : float, shape (..., 3)
        Of the CIE 1931 observer, on any scale.

    Returns
    -------
    ColourTemperature, two arrays of shape (...)
        NaN where |duv| > 0.05 or nearest to a temperature outside 1000-100 000 K.

    Raises
    ------
    NacreError
        Another shape.

    Source: Ohno 2013, doi:10.1080/15502724.2014.839020; the nearest point is found by search.
    """
    colours = doubles(XYZ, "XYZ")
    if colours.ndim < 1 or colours.shape[-1] != 3:
        raise NacreError(f"XYZ: must have shape (..., 3) (got {colours.shape})")
    cct, duv = np.empty(colours.shape[:-1]), np.empty(colours.shape[:-1])
    check(
        lib.nacre_colour_temperature(
            cct.size, colours.ctypes.data, cct.ctypes.data, duv.ctypes.data
        )
    )
    return ColourTemperature(cct, duv)


def illuminant(name: str) -> np.ndarray:
    """Relative spectral power of a light, float64 (471,) over 360-830 nm at 1 nm.

    Parameters
    ----------
    name : str
        "D65", "A", ..., a light of the library ("lamp/hps"), "blackbody:3200", "daylight:5600", or
        lines with their powers, "line:435.8@1,546.1@0.8".

    Raises
    ------
    NacreError
        Another name (the message lists them), or a number out of range.

    Source: CIE 015:2018; Planck's law with c2 = 1.4388e-2 m K.
    """
    power = np.empty(GRID_NM.size)
    check(lib.nacre_illuminant(text(name, "name"), power.ctypes.data))
    return power


def colour_matching(observer: str = "cie1931") -> np.ndarray:
    """Colour-matching functions, float64 (471, 3): x, y and z over 360-830 nm at 1 nm.

    Parameters
    ----------
    observer : "cie1931" (2 degrees) or "cie1964" (10 degrees)

    Raises
    ------
    NacreError
        Another name; the message lists them.

    Source: CIE 018:2019.
    """
    xyz = np.empty((GRID_NM.size, 3))
    check(lib.nacre_colour_matching(text(observer, "observer"), xyz.ctypes.data))
    return xyz
