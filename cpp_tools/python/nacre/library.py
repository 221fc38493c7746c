# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Optical constants and spectra that come with Nacre, and the user's own ($XDG_DATA_HOME/nacre)."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._native import NacreError, check, doubles, lib, text


class Medium(NamedTuple):
    """key: `book/page`; references: citation; range_nm: closed range of the data."""

    key: str
    name: str
    references: str
    comments: str
    range_nm: tuple[float, float]

    def index(self, wavelength_nm: ArrayLike) -> np.ndarray:
        """n + ik, complex128 of the shape of `wavelength_nm` (vacuum, nm).

        Raises NacreError outside the range of the data; the message names it.
        """
        wavelengths = doubles(wavelength_nm, "wavelength_nm")
        n = np.empty(wavelengths.shape, dtype=np.complex128)
        key = text(self.key, "key")
        check(
            lib.nacre_library_index(key, wavelengths.size, wavelengths.ctypes.data, n.ctypes.data)
        )
        return n


class Spectrum(NamedTuple):
    """kind: `emission` (relative power) or `reflectance` (ratio, also of transmittance); references:
    citation; wavelength_nm (ascending, vacuum) and values: float64 (N,), copies."""

    key: str
    name: str
    kind: str
    references: str
    licence: str
    comments: str
    wavelength_nm: np.ndarray
    values: np.ndarray


_KEYS = {
    "media": (lib.nacre_library_count, lib.nacre_library_key),
    "spectra": (lib.nacre_library_spectrum_count, lib.nacre_library_spectrum_key),
}


def keys(kind: str = "media") -> list[str]:
    """Keys of all `media` or `spectra`, ascending. Raises NacreError for another kind."""
    if kind not in _KEYS:
        raise NacreError(f"kind: must be media or spectra (got {kind!r})")
    count, key = _KEYS[kind]
    return [key(index).decode() for index in range(count())]


def medium(key: str) -> Medium:
    """One medium by its key. Raises NacreError for an unknown one; the message names near ones."""
    found = _native.Medium()
    check(lib.nacre_library_medium(text(key, "key"), ctypes.byref(found)))
    return Medium(
        found.key.decode(),
        found.name.decode(),
        found.references.decode(),
        found.comments.decode(),
        (found.first_nm, found.last_nm),
    )


def spectrum(key: str) -> Spectrum:
    """One spectrum by its key, e.g. `colorchecker/dark-skin`. Raises NacreError for an unknown one;
    the message names near ones."""
    found = _native.Spectrum()
    check(lib.nacre_library_spectrum(text(key, "key"), ctypes.byref(found)))
    wavelengths, values = (
        np.ctypeslib.as_array(pointer, (found.count,)).copy()
        for pointer in (found.wavelength_nm, found.values)
    )
    return Spectrum(
        found.key.decode(),
        found.name.decode(),
        found.kind.decode(),
        found.references.decode(),
        found.licence.decode(),
        found.comments.decode(),
        wavelengths,
        values,
    )
