# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colour tables of film stacks."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from ctypes import c_void_p
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi, library
from ._capi import WAVELENGTHS
from ._native import (
    NacreError,
    check,
    complexes,
    doubles,
    lib,
    number,
    numbers,
    take_tables,
    text,
)

MAX_TEXELS = 16384  # per axis


class Table(NamedTuple):
    """texels: float32 (height, width, 3), row 0 at the minimum of y; x and y: name, min, max."""

    texels: np.ndarray
    x: tuple[str, float, float]
    y: tuple[str, float, float]
    error_max: float
    error_mean: float


class FilmLut(NamedTuple):
    reflectance: Table
    transmittance: Table | None


def _index(medium: Any, strict_range: bool) -> np.ndarray:
    if isinstance(medium, str):
        return library.medium(medium).index_on_grid(strict_range=strict_range)
    values = complexes(medium, "media")
    if values.shape not in ((), (WAVELENGTHS,)):
        raise NacreError(
            f"media: must be a library key, a number or {WAVELENGTHS} numbers for 360-830 nm "
            f"(got shape {values.shape})"
        )
    return np.broadcast_to(values, (WAVELENGTHS,))


def _variation(varying: int | str | None, layers: int) -> int:
    """As `nacre_film.varying` of capi/films.h."""
    if varying is None:
        return -2
    if isinstance(varying, str) and varying == "scale":
        return -1
    if not isinstance(varying, (int, np.integer)) or not 0 <= varying < layers:
        raise NacreError(f"varying: must be a layer, 'scale' or None (got {varying!r})")
    return int(varying)


def _table(info: _capi.Table, texels: np.ndarray) -> Table:
    return Table(
        texels,
        (info.x_name.decode(), info.x_min, info.x_max),
        (info.y_name.decode(), info.y_min, info.y_max),
        info.error_max,
        info.error_mean,
    )


def film_lut(
    media: Sequence[Any],
    d_nm: ArrayLike,
    varying: int | str | None = None,
    range_: tuple[float, float] = (0.0, 1.0),
    *,
    coherent: Sequence[bool] | None = None,
    transmittance: bool = False,
    tolerance: float | None = 0.1,
    size: tuple[int, int] | None = None,
    precision: str = "double",
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
    adaptation: str = "bradford",
    strict_range: bool = False,
) -> FilmLut:
    """Colour of a stack over the cosine of the angle and a thickness, as a table for a renderer.

    Parameters
    ----------
    media : sequence, length layers + 2
        Ambient to substrate; each a library key ("SiO2/Malitson"), a number n + ik, or 471 numbers
        for 360-830 nm.
    d_nm : float, shape (layers,)
    varying : int, "scale" or None
        Layer whose thickness is the second axis; "scale": a factor on all coherent layers.
    range_ : (min, max)
        Of the second axis: nm, or a factor.
    coherent : bool, length layers, optional
        Whether light interferes within each layer; by default in all.
    transmittance : bool
        Whether there is a second table, of what is let through.
    tolerance : float
        Largest CIEDE2000 difference allowed between the table, read bilinearly, and the exact
        colour, for angles up to 87 degrees; decides the size. None, together with a size: errors
        are not measured but NaN, which takes a fifth of the time.
    size : (width, height), optional
        Takes this size instead.
    precision : "double" or "single"
        Single: for previews, with a size and without a tolerance; colours good to 1e-5. Stacks with
        incoherent layers are baked in double all the same.
    illuminant, observer, space : str
        A light by name (`nacre.illuminant`), "cie1931" or "cie1964", and "lin_rec709_scene",
        "lin_rec2020_scene", "lin_ap1_scene" or "xyz_d65".
    adaptation : "bradford", "cat16" or "none"
        Of the light's white to the space's. None: the table has the colour of the light in it.
    strict_range : bool
        Whether keys of media whose data end within 360-830 nm are refused; else their ends are held
        (`library.Medium.index_on_grid`).

    Returns
    -------
    FilmLut
        Each table states its measured error. Values are not clipped: colours may be out of gamut.

    Raises
    ------
    NacreError
        Names the field; also when no table of 4096 texels per axis meets the tolerance.
    """
    thickness = doubles(d_nm, "d_nm")
    layers = thickness.size
    if len(media) != layers + 2:
        raise NacreError(f"media: must list {layers + 2} for {layers} layers (got {len(media)})")
    low, high = numbers(range_, "range_", float, 2)
    width, height = (0, 0) if size is None else numbers(size, "size", int, 2)
    if tolerance is None and size is None:
        raise NacreError("size: must be given where the tolerance is None")
    if size is not None and not (1 <= width <= MAX_TEXELS and 1 <= height <= MAX_TEXELS):
        raise NacreError(f"size: must be two numbers in 1…{MAX_TEXELS} (got {size!r})")
    if precision not in ("double", "single"):
        raise NacreError(f"precision: must be 'double' or 'single' (got {precision!r})")
    n = np.ascontiguousarray(
        [_index(medium, strict_range) for medium in media], dtype=np.complex128
    )
    flags = np.array([True] * layers if coherent is None else coherent, dtype=np.uint8)
    if flags.shape != (layers,):
        raise NacreError(f"coherent: must have {layers} flags (got {flags.shape})")
    film = _capi.Film(
        layers=layers,
        n=n.ctypes.data,
        d_nm=thickness.ctypes.data,
        coherent=flags.ctypes.data,
        varying=_variation(varying, layers),
        min=low,
        max=high,
        illuminant=text(illuminant, "illuminant"),
        observer=text(observer, "observer"),
        space=text(space, "space"),
        adaptation=text(adaptation, "adaptation"),
        tolerance=0.0 if tolerance is None else number(tolerance, "tolerance"),
        width=width,
        height=height,
        transmittance=int(transmittance),
        single_precision=int(precision == "single"),
    )
    handle = c_void_p()
    check(lib.nacre_film_lut(ctypes.byref(film), ctypes.byref(handle)))
    try:
        tables = [_table(*table) for table in take_tables(handle)]
    finally:
        lib.nacre_result_free(handle)
    return FilmLut(tables[0], tables[1] if transmittance else None)
