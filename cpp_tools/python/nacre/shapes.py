# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectra made by hand, as sums of simple shapes: `nacre.shapes.define()`."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi, _native, library
from ._native import NacreError, check, doubles, lib, text


class Constant(NamedTuple):
    """The same value everywhere."""

    value: float


class Box(NamedTuple):
    """A value from one wavelength to another, both included, and 0 elsewhere. With an edge it rises
    over so many nm around the first along half a cosine and falls likewise around the last."""

    first_nm: float
    last_nm: float
    value: float
    edge_nm: float = 0.0


class Gaussian(NamedTuple):
    """peak · exp(-4 ln 2 ((λ - centre) / fwhm)²)"""

    centre_nm: float
    fwhm_nm: float
    peak: float


class Points(NamedTuple):
    """Through control points, wavelengths ascending: straight, or smooth along a cubic that is
    monotone wherever they are (Fritsch and Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300).
    Beyond them the value of the nearest one."""

    wavelength_nm: ArrayLike
    values: ArrayLike
    smooth: bool = False


class Scaled(NamedTuple):
    """A spectrum of the library by its key, or any other one, times a factor."""

    spectrum: str | library.Spectrum
    factor: float = 1.0


Shape = Constant | Box | Gaussian | Points | Scaled

#: 300 … 850 nm at 1 nm: where a spectrum is sampled unless told otherwise.
WAVELENGTH_NM = np.arange(300.0, 851.0)

_NUMBERS = {Constant: 0, Box: 1, Gaussian: 2}
_LINEAR, _SMOOTH, _SCALED = 3, 4, 5


def total(shapes: Shape | Iterable[Shape], wavelength_nm: ArrayLike = WAVELENGTH_NM) -> np.ndarray:
    """The sum of shapes, of which some may be negative.

    Parameters
    ----------
    shapes : one or several
    wavelength_nm : float, shape (N,)
        Two or more, ascending, nm.

    Returns
    -------
    float64, shape (N,)

    Raises NacreError for a shape with wrong numbers, and for a box or a Gaussian so narrow that it
    falls between the wavelengths.
    """
    return _sum(shapes, wavelength_nm, None)


def define(
    shapes: Shape | Iterable[Shape],
    kind: str,
    *,
    key: str = "",
    name: str = "",
    wavelength_nm: ArrayLike = WAVELENGTH_NM,
    references: str = "",
    licence: str = "",
    tags: Iterable[str] = (),
) -> library.Spectrum:
    """A spectrum of one's own, which `nacre.library.add()` keeps where it has a key.

    Parameters
    ----------
    shapes : one or several
        Whose sum it is: `Constant`, `Box`, `Gaussian`, `Points`, `Scaled`.
    kind : "reflectance" or "emission"
    wavelength_nm : float, shape (N,)
        Where it is sampled, ascending, nm.
    key, name, references, licence, tags
        As in `nacre.library.Spectrum`.

    Raises NacreError as `total()`, and where the sum does not suit its kind: a reflectance has to be
    in [0, 2], an emission ≥ 0 and somewhere > 0.
    """
    given = [shapes] if isinstance(shapes, Shape) else list(shapes)
    values = _sum(given, wavelength_nm, text(kind, "kind"))
    wavelengths = np.array(wavelength_nm, dtype=np.float64)
    words = " + ".join(map(_words, given))
    return library.Spectrum(
        key, name, kind, references, licence, words, wavelengths, values, tuple(tags)
    )


def _sum(
    shapes: Shape | Iterable[Shape], wavelength_nm: ArrayLike, kind: bytes | None
) -> np.ndarray:
    wavelengths = doubles(wavelength_nm, "wavelength_nm")
    if wavelengths.ndim != 1:
        raise NacreError(f"wavelength_nm: must have shape (N,) (got {wavelengths.shape})")
    given = [shapes] if isinstance(shapes, Shape) else list(shapes)
    records = (_capi.Shape * len(given))()
    kept = [_fill(record, shape) for record, shape in zip(records, given, strict=True)]
    sums = np.empty(wavelengths.shape)
    pointers = wavelengths.ctypes.data, sums.ctypes.data
    check(lib.nacre_sum_of_shapes(len(given), records, kind, wavelengths.size, *pointers))
    del kept  # the records point into it
    return sums


def _fill(record: _capi.Shape, shape: Shape) -> object:
    """Writes the shape into the record. @return what the record points to"""
    if type(shape) in _NUMBERS:
        record.kind = _NUMBERS[type(shape)]
        given = _native.numbers(tuple(shape), type(shape).__name__, float, len(shape))
        record.numbers = (ctypes.c_double * 4)(*given)
        return None
    if isinstance(shape, Points):
        record.kind = _SMOOTH if shape.smooth else _LINEAR
        return _point(record, shape.wavelength_nm, shape.values)
    if not isinstance(shape, Scaled):
        raise NacreError(
            "shapes: must be Constant, Box, Gaussian, Points or Scaled "
            f"(got {type(shape).__name__})"
        )
    record.kind = _SCALED
    (record.numbers[0],) = _native.numbers((shape.factor,), "factor", float, 1)
    if isinstance(shape.spectrum, library.Spectrum):
        record.of_kind = text(shape.spectrum.kind, "kind")
        return _point(record, shape.spectrum.wavelength_nm, shape.spectrum.values)
    record.key = text(shape.spectrum, "spectrum")
    return None


def _point(record: _capi.Shape, wavelength_nm: ArrayLike, values: ArrayLike) -> object:
    wavelengths = doubles(wavelength_nm, "wavelength_nm")
    if wavelengths.ndim != 1:
        raise NacreError(f"wavelength_nm: must have shape (N,) (got {wavelengths.shape})")
    array = doubles(values, "values", wavelengths.shape)
    record.count = wavelengths.size
    record.wavelength_nm, record.values = wavelengths.ctypes.data, array.ctypes.data
    return wavelengths, array


def _words(shape: Shape) -> str:
    """As the tool puts it into the comments of an entry."""
    if isinstance(shape, Points):
        pairs = zip(np.ravel(shape.wavelength_nm), np.ravel(shape.values), strict=True)
        curve = ",".join(f"{nm:g}:{value:g}" for nm, value in pairs)
        return f"{'smooth ' if shape.smooth else ''}points {curve}"
    if isinstance(shape, Scaled):
        spectrum = shape.spectrum
        key = spectrum.key or spectrum.name if isinstance(spectrum, library.Spectrum) else spectrum
        return f"from {key}:{shape.factor:g}"
    given = shape[:3] if isinstance(shape, Box) and not shape.edge_nm else shape
    return f"{type(shape).__name__.lower()} " + ":".join(f"{number:g}" for number in given)
