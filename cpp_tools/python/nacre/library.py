# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Optical constants and spectra that come with Nacre, and the user's own ($XDG_DATA_HOME/nacre)."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi, _native
from ._capi import WAVELENGTHS
from ._native import NacreError, check, copied, doubles, lib, text


class HeldEnds(NamedTuple):
    """percent: of the luminous weight, beyond the data of a medium; note: a sentence that says so,
    empty where nothing is held."""

    percent: float
    note: str


class Medium(NamedTuple):
    """key: `book/page`; references: citation; range_nm: closed range of the data; formula: chemical,
    e.g. `TiO2`, or empty; tags: kind of matter, e.g. `metal`; changes: what was put right when the
    file was read, such as rows out of order."""

    key: str
    name: str
    references: str
    comments: str
    range_nm: tuple[float, float]
    formula: str = ""
    tags: tuple[str, ...] = ()
    changes: tuple[str, ...] = ()

    # Not that of a tuple, whose values nobody looks for.
    def index(self, wavelength_nm: ArrayLike) -> np.ndarray:  # type: ignore[override]
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

    def index_on_grid(self, *, strict_range: bool = False) -> np.ndarray:
        """n + ik, complex128 (471,) over 360 ... 830 nm, the range of colours.

        Data of 400 ... 700 nm are enough: where they end within the range, n and k are held as they
        are at the end, as in every stack that names the medium by its key; `held_ends` says how much
        that is. Raises NacreError for shorter data and, with `strict_range`, for such.
        """
        n = np.empty(WAVELENGTHS, dtype=np.complex128)
        key = text(self.key, "key")
        check(lib.nacre_library_index_on_grid(key, int(strict_range), n.ctypes.data))
        return n

    def held_ends(
        self, *, illuminant: str = "D65", observer: str = "cie1931", strict_range: bool = False
    ) -> HeldEnds:
        """How much of the luminous weight `index_on_grid` holds. Raises NacreError as it does."""
        percent, note = ctypes.c_double(), ctypes.c_char_p()
        check(
            lib.nacre_library_held_ends(
                text(self.key, "key"),
                text(illuminant, "illuminant"),
                text(observer, "observer"),
                int(strict_range),
                ctypes.byref(percent),
                ctypes.byref(note),
            )
        )
        return HeldEnds(percent.value, (note.value or b"").decode())


class Spectrum(NamedTuple):
    """kind: `emission` (relative power) or `reflectance` (ratio, also of transmittance), or empty
    where a file does not tell; references: citation; wavelength_nm (ascending, vacuum) and values:
    float64 (N,), copies; tags: e.g. `led`."""

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


def _words(kind: str, key: str) -> tuple[str, tuple[str, ...], tuple[str, ...]]:
    """Formula, tags and changes."""
    found = _capi.LibraryWords()
    check(lib.nacre_library_words_of(_KINDS[kind], text(key, "key"), ctypes.byref(found)))
    tags, changes = (tuple(lines.decode().splitlines()) for lines in (found.tags, found.changes))
    return found.formula.decode(), tags, changes


def medium(key: str) -> Medium:
    """One medium by its key. Raises NacreError for an unknown one; the message names near ones."""
    found = _capi.Medium()
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
    found = _capi.Spectrum()
    check(lib.nacre_library_spectrum(text(key, "key"), ctypes.byref(found)))
    return _spectrum_from(found, _words("spectra", key)[1])


def _spectrum_from(found: _capi.Spectrum, tags: tuple[str, ...]) -> Spectrum:
    wavelengths, values = (
        copied(address, ctypes.c_double, (found.count,))
        for address in (found.wavelength_nm, found.values)
    )
    fields = (found.key, found.name, found.kind, found.references, found.licence, found.comments)
    key, name, kind, references, licence, comments = (field.decode() for field in fields)
    return Spectrum(key, name, kind, references, licence, comments, wavelengths, values, tags)


def read(
    path: str | os.PathLike[str], *, kind: str = "", scale: float | None = None
) -> list[Spectrum]:
    """Spectra of a file: `.csv`, `.spd` of Mitsuba and pbrt, `.spdx` (IES TM-27-14) or CGATS.

    kind: what the values are, whatever the file says. scale: multiplies them, by 0.01 for per cent,
    by 1 for ratios; by default as the file says, and a reflectance above 1 of which it does not say
    whether it is a ratio or per cent is refused. Raises NacreError with all that is wrong, each with
    its line; OSError where there is no file.
    """
    if scale is not None and not 0.0 < scale < float("inf"):
        raise NacreError(f"scale: must be finite and > 0 (got {scale!r})")
    content = Path(path).read_bytes()
    handle = ctypes.c_void_p()
    check(
        lib.nacre_read_spectra(
            content,
            len(content),
            os.fsencode(path),
            text(kind, "kind"),
            scale or 0.0,
            ctypes.byref(handle),
        )
    )
    try:
        spectra = []
        for index in range(lib.nacre_spectra_count(handle)):
            found, tags = _capi.Spectrum(), ctypes.c_char_p()
            check(lib.nacre_spectra_at(handle, index, ctypes.byref(found), ctypes.byref(tags)))
            spectra.append(_spectrum_from(found, tuple((tags.value or b"").decode().splitlines())))
        return spectra
    finally:
        lib.nacre_spectra_free(handle)


def add(spectra: Spectrum | Iterable[Spectrum], *, replace: bool = False) -> None:
    """Puts spectra into the user's own library, $XDG_DATA_HOME/nacre: all or, when one is refused,
    none. Each needs its `key` and `kind`; `spectrum._replace(key="lamp/mine")` sets them.

    replace: in place of the user's entries of these keys; what was looked up before stays as it was
    until Python ends. Raises NacreError for a text that is no key, a key that comes with Nacre or
    exists, wavelengths that do not ascend, and values that do not suit the kind.
    """
    entries = [spectra] if isinstance(spectra, Spectrum) else list(spectra)
    records = (_capi.Spectrum * len(entries))()
    tags = (ctypes.c_char_p * len(entries))()
    arrays = []  # what the records point to
    for index, entry in enumerate(entries):
        wavelengths = doubles(entry.wavelength_nm, "wavelength_nm")
        values = doubles(entry.values, "values", wavelengths.shape)
        arrays.append((wavelengths, values))
        for field in ("key", "name", "kind", "references", "licence", "comments"):
            setattr(records[index], field, text(getattr(entry, field), field))
        records[index].count = wavelengths.size
        records[index].wavelength_nm = wavelengths.ctypes.data
        records[index].values = values.ctypes.data
        tags[index] = text("\n".join(entry.tags), "tags")
    check(lib.nacre_library_add_spectra(len(entries), records, tags, int(replace)))


def add_medium(
    key: str,
    source: str | os.PathLike[str] | tuple[ArrayLike, ArrayLike],
    *,
    references: str = "",
    replace: bool = False,
) -> Medium:
    """Puts optical constants into the user's own library, and returns them.

    source: a file of refractiveindex.info (`.yml`), a `.csv` with columns `wavelength_nm`, `n` and
    perhaps `k`, or a pair of arrays (N,): wavelengths in nm, ascending, and n + ik. references:
    citation, where the file has none. replace: as in add(). What is put right in a file is in
    `changes` and, of a table, in `comments`. Raises NacreError as add() does, and with
    all that is wrong with a file, each with its line; OSError where there is no file.
    """
    if isinstance(source, tuple):
        file, content = "samples", _table(*source)
    else:
        file, content = os.fsdecode(source), Path(source).read_bytes()
    words = text(references, "references")
    check(
        lib.nacre_library_add_medium(
            text(key, "key"), content, len(content), os.fsencode(file), words, int(replace)
        )
    )
    return medium(key)


def _table(wavelength_nm: ArrayLike, n: ArrayLike) -> bytes:
    """Samples of a medium as the text of a table."""
    wavelengths = doubles(wavelength_nm, "wavelength_nm")
    index = _native.complexes(n, "n")
    if wavelengths.ndim != 1 or index.shape != wavelengths.shape:
        raise NacreError(
            f"source: must be two arrays of shape (N,) (got {wavelengths.shape}, {index.shape})"
        )
    rows = [
        f"{float(nm)!r},{float(value.real)!r},{float(value.imag)!r}"
        for nm, value in zip(wavelengths, index, strict=True)
    ]
    return "\n".join(["wavelength_nm,n,k", *rows, ""]).encode()
