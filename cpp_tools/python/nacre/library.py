# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Optical constants that come with Nacre."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._native import check, doubles, lib, text


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


def keys() -> list[str]:
    """Keys of all media, ascending."""
    return [lib.nacre_library_key(index).decode() for index in range(lib.nacre_library_count())]


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
