# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours of many multilayers of the same media."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi, library
from ._capi import WAVELENGTHS
from ._colour import Colour
from ._native import (
    NacreError,
    check,
    complexes,
    doubles,
    lib,
    polarisation,
    text,
)


class StackColour(NamedTuple):
    """Colours of shape (...) and, of the same shape, at how many wavelengths each was computed."""

    reflectance: Colour
    transmittance: Colour
    wavelengths: np.ndarray


def _medium(medium: Any, number: int, strict_range: bool) -> tuple[_capi.MediumIndex, Any]:
    """And what has to live as long."""
    if isinstance(medium, str):
        key = text(medium, f"media[{number}]")
        if strict_range:
            library.medium(medium).index_on_grid(strict_range=True)
        return _capi.MediumIndex(key=key), None
    values = complexes(medium, f"media[{number}]")
    if values.shape not in ((), (WAVELENGTHS,)):
        raise NacreError(
            f"media[{number}]: must be a library key, a number or {WAVELENGTHS} numbers for "
            f"360-830 nm (got shape {values.shape})"
        )
    return _capi.MediumIndex(n=values.ctypes.data, count=values.size), values


def _colour(colours: np.ndarray) -> Colour:
    return Colour(*(np.ascontiguousarray(colours[..., part, :]) for part in range(3)))


def stack_colour(
    media: Sequence[Any],
    d_nm: ArrayLike,
    angle_deg: ArrayLike = 0.0,
    *,
    pol: str = "u",
    coherent: Sequence[bool] | None = None,
    sampling: str = "adaptive",
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
    adaptation: str = "bradford",
    gamut: str = "keep",
    strict_range: bool = False,
) -> StackColour:
    """Colours of multilayers that differ in thickness and angle.

    Parameters
    ----------
    media : sequence, length layers + 2
        Ambient, which is clear, to substrate; each a library key ("SiO2/Malitson"), a number
        n + ik, or 471 numbers for 360-830 nm, linear in between.
    d_nm : float, shape (..., layers)
        Thicknesses, >= 0.
    angle_deg : float, shape (...)
        In the ambient, in [0, 90); broadcast against `d_nm` without its last axis.
    pol : "s", "p" or "u"
    coherent : sequence of bool, length layers
    sampling : str
        "adaptive": as few wavelengths as it takes, within 0.001 of "reference" (every 0.05 nm);
        "full": every nanometre; "steps:N", "hierarchical:LEVEL".
    illuminant, observer, space, adaptation, gamut
        As of `spectrum_to_colour`.
    strict_range : bool
        As of `film_lut`.

    Returns
    -------
    StackColour

    Raises
    ------
    NacreError
        Names the argument and the item.

    Source: cpp_tools/doc/sampling.md.
    """
    thickness, angle = doubles(d_nm, "d_nm"), doubles(angle_deg, "angle_deg")
    layers = len(media) - 2
    if layers < 0 or thickness.ndim == 0 or thickness.shape[-1] != layers:
        raise NacreError(
            f"d_nm: must have one thickness for each of the {max(layers, 0)} layers on its last "
            f"axis (got shape {thickness.shape})"
        )
    try:
        shape = np.broadcast_shapes(thickness.shape[:-1], angle.shape)
    except ValueError as error:
        raise NacreError(f"angle_deg: {error}") from None
    thickness = np.ascontiguousarray(np.broadcast_to(thickness, (*shape, layers)))
    angle = np.ascontiguousarray(np.broadcast_to(angle, shape))
    flags = np.array([True] * layers if coherent is None else coherent, dtype=np.uint8)
    if flags.shape != (layers,):
        raise NacreError(f"coherent: must have {layers} flags (got {flags.shape})")
    indices, kept = zip(
        *(_medium(medium, i, strict_range) for i, medium in enumerate(media)), strict=True
    )
    stacks = _capi.ColourStacks(
        layers=layers,
        media=(_capi.MediumIndex * len(indices))(*indices),
        coherent=flags.ctypes.data,
        count=angle.size,
        d_nm=thickness.ctypes.data,
        angle_deg=angle.ctypes.data,
        polarisation=polarisation(pol),
        sampling=text(sampling, "sampling"),
    )
    options = _capi.ColourOptions(
        text(illuminant, "illuminant"),
        text(observer, "observer"),
        text(space, "space"),
        text(adaptation, "adaptation"),
        text(gamut, "gamut"),
        1,
    )
    reflectance, transmittance = np.empty((*shape, 3, 3)), np.empty((*shape, 3, 3))
    wavelengths = np.empty(shape, dtype=np.uintp)
    check(
        lib.nacre_stack_colours(
            ctypes.byref(stacks),
            ctypes.byref(options),
            reflectance.ctypes.data,
            transmittance.ctypes.data,
            wavelengths.ctypes.data,
        )
    )
    del kept
    return StackColour(_colour(reflectance), _colour(transmittance), wavelengths.astype(int))
