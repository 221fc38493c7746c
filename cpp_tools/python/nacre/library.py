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
    """key: `book/page`; references: citation; range_nm: closed range of the data; formula: chemical,
    e.g. `TiO2`, or empty; tags: kind of matter, e.g. `metal`."""

    key: str
    name: str
    references: str
    comments: str
    range_nm: tuple[float, float]
    formula: str = ""
    tags: tuple[str, ...] = ()

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
    citation; wavelength_nm (ascending, vacuum) and values: float64 (N,), copies; tags: e.g. `led`."""

    key: str
    name: str
    kind: str
    references: str
    licence: str
    comments: str
    wavelength_nm: np.ndarray
    values: np.ndarray
    tags: tuple[str, ...] = ()


_KINDS = {"media": 0, "spectra": 1}


def keys(kind: str = "media", search: str = "", tag: str = "") -> list[str]:
    """Keys of `media` or `spectra`, ascending.

    search: part of a key, a name, a chemical formula, a tag or a citation, whatever its case; tag:
    one whole tag, e.g. `metal`. Both together want both. A file of the user's own that cannot be
    read is found by its key alone. Raises NacreError for another kind.
    """
    if kind not in _KINDS:
        raise NacreError(f"kind: must be media or spectra (got {kind!r})")
    count = ctypes.c_size_t()
    words = text(search, "search"), text(tag, "tag")
    check(lib.nacre_library_search(_KINDS[kind], *words, ctypes.byref(count)))
    return [lib.nacre_library_found(index).decode() for index in range(count.value)]


def _words(kind: str, key: str) -> tuple[str, tuple[str, ...]]:
    """Formula and tags."""
    found = _native.LibraryWords()
    check(lib.nacre_library_words_of(_KINDS[kind], text(key, "key"), ctypes.byref(found)))
    return found.formula.decode(), tuple(found.tags.decode().splitlines())


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
        *_words("media", key),
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
        _words("spectra", key)[1],
    )
