# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Loads the shared library and declares the functions of `capi.h`."""

from __future__ import annotations

import ctypes
import operator
import os
import re
from ctypes import POINTER, Structure, c_char_p, c_double, c_float, c_int, c_size_t, c_void_p
from pathlib import Path
from typing import Any

import numpy as np

API_VERSION = 1
WAVELENGTHS = 471


class NacreError(ValueError):
    """Wrong input; the message names the field and what is allowed."""


class GridArray(Structure):
    _fields_ = [("values", c_void_p), ("steps", POINTER(c_size_t))]


class ColourOptions(Structure):
    _fields_ = [
        *[(name, c_char_p) for name in ("illuminant", "observer", "space", "adaptation", "gamut")],
        ("reflectance", c_int),
    ]


class Grating(Structure):
    _fields_ = [
        ("pitch_nm", c_double),
        ("wavelength_nm", c_double),
        ("grating_vector", c_double * 3),
        ("normal", c_double * 3),
        ("k_in", c_double * 3),
        ("profile", c_char_p),
        ("phase_rad", c_double),
        ("duty", c_double),
    ]


class TableInfo(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("quantity", c_char_p),
        ("x_name", c_char_p),
        ("y_name", c_char_p),
        ("x_min", c_double),
        ("x_max", c_double),
        ("y_min", c_double),
        ("y_max", c_double),
        ("width", c_int),
        ("height", c_int),
        ("channels", c_int),
        ("error_max", c_double),
        ("error_mean", c_double),
        ("texels", POINTER(c_float)),
    ]


class TableSize(Structure):
    _fields_ = [("name", c_char_p), ("width", c_int), ("height", c_int)]


class Coherence(Structure):
    _fields_ = [("coherent", c_void_p), ("spread_nm", c_void_p), ("bandwidth_nm", c_double)]


class Film(Structure):
    _fields_ = [
        ("layers", c_size_t),
        ("n", c_void_p),
        ("d_nm", c_void_p),
        ("coherent", c_void_p),
        ("varying", c_int),
        ("min", c_double),
        ("max", c_double),
        ("illuminant", c_char_p),
        ("observer", c_char_p),
        ("space", c_char_p),
        ("adaptation", c_char_p),
        ("tolerance", c_double),
        ("width", c_int),
        ("height", c_int),
        ("transmittance", c_int),
        ("single_precision", c_int),
    ]


class Medium(Structure):
    _fields_ = [
        ("key", c_char_p),
        ("name", c_char_p),
        ("references", c_char_p),
        ("comments", c_char_p),
        ("first_nm", c_double),
        ("last_nm", c_double),
    ]


class Spectrum(Structure):
    _fields_ = [
        ("key", c_char_p),
        ("name", c_char_p),
        ("kind", c_char_p),
        ("references", c_char_p),
        ("licence", c_char_p),
        ("comments", c_char_p),
        ("count", c_size_t),
        ("wavelength_nm", POINTER(c_double)),
        ("values", POINTER(c_double)),
    ]


class Shape(Structure):
    _fields_ = [
        ("kind", c_int),
        ("numbers", c_double * 4),
        ("count", c_size_t),
        ("wavelength_nm", c_void_p),
        ("values", c_void_p),
        ("key", c_char_p),
        ("of_kind", c_char_p),
    ]


class LibraryWords(Structure):
    _fields_ = [("formula", c_char_p), ("tags", c_char_p), ("changes", c_char_p)]


class MediumIndex(Structure):
    _fields_ = [("key", c_char_p), ("n", c_void_p), ("count", c_size_t)]


class ColourStacks(Structure):
    _fields_ = [
        ("layers", c_size_t),
        ("media", POINTER(MediumIndex)),
        ("coherent", c_void_p),
        ("count", c_size_t),
        ("d_nm", c_void_p),
        ("angle_deg", c_void_p),
        ("polarisation", c_int),
        ("sampling", c_char_p),
    ]


class Texture(Structure):
    _fields_ = [("width", c_int), ("height", c_int), ("channels", c_int), ("texels", c_void_p)]


POLARISATIONS = {"s": 0, "p": 1, "u": 2}

_SIGNATURES = {
    "nacre_api_version": (c_int, []),
    "nacre_version": (c_char_p, []),
    "nacre_last_error": (c_char_p, []),
    "nacre_stack": (
        c_int,
        [c_size_t, c_size_t, *[c_void_p] * 4, POINTER(Coherence), c_int, *[c_void_p] * 3],
    ),
    "nacre_stack_grid": (
        c_int,
        [
            *[c_size_t, POINTER(c_size_t), c_size_t, *[GridArray] * 4],
            *[POINTER(Coherence), c_int, *[c_void_p] * 3],
        ],
    ),
    "nacre_film_reflectance": (c_int, [c_char_p, c_size_t, c_void_p, c_int, c_void_p]),
    "nacre_slit_intensity": (c_int, [c_size_t, c_void_p, c_void_p]),
    "nacre_spectra_to_colours": (
        c_int,
        [c_size_t, c_size_t, c_void_p, c_void_p, POINTER(ColourOptions), c_void_p],
    ),
    "nacre_stack_colours": (
        c_int,
        [POINTER(ColourStacks), POINTER(ColourOptions), *[c_void_p] * 3],
    ),
    "nacre_map_range": (c_int, [c_size_t, c_void_p, c_char_p]),
    "nacre_rgb_to_spectrum": (
        c_int,
        [c_size_t, c_void_p, c_char_p, c_char_p, c_int, *[c_void_p] * 3],
    ),
    "nacre_grating_orders": (c_int, [POINTER(Grating), c_int, c_int, c_void_p, c_void_p]),
    "nacre_film_lut": (c_int, [POINTER(Film), POINTER(c_void_p)]),
    "nacre_compile_template": (c_int, [*[c_char_p] * 6, c_double, POINTER(c_void_p)]),
    "nacre_preview_template": (
        c_int,
        [*[c_char_p] * 6, c_size_t, POINTER(TableSize), POINTER(c_void_p)],
    ),
    "nacre_template_spectrum": (c_int, [*[c_char_p] * 6, *[c_double] * 2, *[c_void_p] * 3]),
    "nacre_result_tables": (c_size_t, [c_void_p]),
    "nacre_result_table": (c_int, [c_void_p, c_size_t, POINTER(TableInfo)]),
    "nacre_result_text": (c_char_p, [c_void_p, c_char_p]),
    "nacre_result_free": (None, [c_void_p]),
    "nacre_library_count": (c_size_t, []),
    "nacre_library_key": (c_char_p, [c_size_t]),
    "nacre_library_search": (c_int, [c_int, c_char_p, c_char_p, POINTER(c_size_t)]),
    "nacre_library_found": (c_char_p, [c_size_t]),
    "nacre_library_words_of": (c_int, [c_int, c_char_p, POINTER(LibraryWords)]),
    "nacre_library_medium": (c_int, [c_char_p, POINTER(Medium)]),
    "nacre_library_index": (c_int, [c_char_p, c_size_t, c_void_p, c_void_p]),
    "nacre_library_index_on_grid": (c_int, [c_char_p, c_int, c_void_p]),
    "nacre_library_held_ends": (
        c_int,
        [*[c_char_p] * 3, c_int, POINTER(c_double), POINTER(c_char_p)],
    ),
    "nacre_template_held_ends": (c_int, [*[c_char_p] * 4, c_int, POINTER(c_char_p)]),
    "nacre_library_spectrum_count": (c_size_t, []),
    "nacre_library_spectrum_key": (c_char_p, [c_size_t]),
    "nacre_library_spectrum": (c_int, [c_char_p, POINTER(Spectrum)]),
    "nacre_illuminant": (c_int, [c_char_p, c_void_p]),
    "nacre_colour_matching": (c_int, [c_char_p, c_void_p]),
    "nacre_colour_temperature": (c_int, [c_size_t, *[c_void_p] * 3]),
    "nacre_read_spectra": (
        c_int,
        [c_char_p, c_size_t, c_char_p, c_char_p, c_double, POINTER(c_void_p)],
    ),
    "nacre_spectra_count": (c_size_t, [c_void_p]),
    "nacre_spectra_at": (c_int, [c_void_p, c_size_t, POINTER(Spectrum), POINTER(c_char_p)]),
    "nacre_spectra_free": (None, [c_void_p]),
    "nacre_library_add_spectra": (
        c_int,
        [c_size_t, POINTER(Spectrum), POINTER(c_char_p), c_int],
    ),
    "nacre_library_add_medium": (c_int, [c_char_p, c_char_p, c_size_t, c_char_p, c_char_p, c_int]),
    "nacre_sum_of_shapes": (
        c_int,
        [c_size_t, POINTER(Shape), c_char_p, c_size_t, c_void_p, c_void_p],
    ),
    "nacre_texture_samples": (c_int, [c_size_t, c_void_p, c_void_p, c_int, c_void_p]),
    "nacre_pack_spectra": (c_int, [c_size_t, c_void_p, c_char_p, c_size_t, c_void_p]),
    "nacre_unpack_spectra": (
        c_int,
        [POINTER(Texture), c_char_p, c_size_t, c_size_t, c_void_p],
    ),
    "nacre_pack_materials": (c_int, [c_size_t, *[c_void_p] * 4, c_int, c_void_p]),
    "nacre_unpack_materials": (c_int, [POINTER(Texture), *[c_void_p] * 4]),
    "nacre_pack_lights": (c_int, [c_size_t, *[c_void_p] * 3]),
    "nacre_unpack_lights": (c_int, [POINTER(Texture), c_size_t, *[c_void_p] * 2]),
    "nacre_read_ftxt": (c_int, [c_char_p, c_size_t, c_char_p, POINTER(c_void_p)]),
    "nacre_write_ftxt": (
        c_int,
        [POINTER(Texture), c_size_t, POINTER(c_char_p), POINTER(c_char_p), POINTER(c_void_p)],
    ),
    "nacre_ftxt_texture": (c_int, [c_void_p, POINTER(Texture)]),
    "nacre_ftxt_comments": (c_size_t, [c_void_p]),
    "nacre_ftxt_key": (c_char_p, [c_void_p, c_size_t]),
    "nacre_ftxt_value": (c_char_p, [c_void_p, c_size_t]),
    "nacre_ftxt_text": (c_char_p, [c_void_p]),
    "nacre_ftxt_free": (None, [c_void_p]),
}


def _system_glibc() -> str:
    try:
        return os.confstr("CS_GNU_LIBC_VERSION") or "no glibc"
    except (AttributeError, ValueError, OSError):  # Windows; musl
        return "no glibc"


def _too_old(loader: str) -> str:
    """What the loader says of versions of symbols, in those of systems; else nothing.

    It stops at the first that is missing, so the newest is looked up in the file itself.
    """
    found = re.search(
        r"version .(GLIBC|GLIBCXX|CXXABI)_([\d.]+). not found \(required by (.+)\)", loader
    )
    if not found:
        return ""
    family, missing, file = found.groups()
    try:
        names = re.findall(
            rb"\0%b_(\d+(?:\.\d+)+)(?=\0)" % family.encode(), Path(file).read_bytes()
        )
    except OSError:
        names = []
    needed = max(
        (missing, *(name.decode() for name in names)),
        key=lambda version: [int(part) for part in version.split(".")],
    )
    if family == "GLIBC":
        return f"needs glibc {needed} or newer, and this system has {_system_glibc()}; "
    return f"needs a libstdc++ with {family}_{needed}, which is newer than this system's; "


def _load() -> ctypes.CDLL:
    """`NACRE_LIBRARY` names the file; otherwise it lies beside this module, as in the wheel."""
    path = os.environ.get("NACRE_LIBRARY") or str(Path(__file__).with_name("libnacre.so"))
    try:
        loaded = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"nacre: cannot load {path}: {_too_old(str(error))}{error}") from error
    for name, (result, arguments) in _SIGNATURES.items():
        function = getattr(loaded, name)
        function.restype, function.argtypes = result, arguments
    found = loaded.nacre_api_version()
    if found != API_VERSION:
        raise ImportError(f"nacre: {path} has interface {found}, this package needs {API_VERSION}")
    return loaded


lib = _load()


def version() -> str:
    """Of the library that was loaded, e.g. `0.1.0`."""
    return str(lib.nacre_version().decode())


def check(status: int) -> None:
    """Raises what the library reported about the last call of this thread."""
    if status == 0:
        return
    message = lib.nacre_last_error().decode()
    if status == 1:
        raise NacreError(message)
    if status == 2:
        raise MemoryError(message)
    raise RuntimeError(message)


def doubles(values: object, name: str, shape: tuple[int, ...] | None = None) -> np.ndarray:
    """A contiguous array of float64: the array itself where it is one."""
    try:
        given = np.asarray(values)
        if np.iscomplexobj(given):  # numpy would drop the imaginary parts with a warning
            raise TypeError("complex numbers")
        array = np.asarray(given, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise NacreError(f"{name}: must be real numbers ({error})") from error
    if shape is not None and array.shape != shape:
        raise NacreError(f"{name}: must have shape {shape} (got {array.shape})")
    return array


def polarisation(word: str) -> int:
    if word not in POLARISATIONS:
        raise NacreError(f"pol: must be 's', 'p' or 'u' (got {word!r})")
    return POLARISATIONS[word]


def complexes(values: object, name: str) -> np.ndarray:
    """A contiguous array of complex128: the array itself where it is one."""
    try:
        return np.asarray(values, dtype=np.complex128, order="C")
    except (TypeError, ValueError) as error:
        raise NacreError(f"{name}: must be numbers ({error})") from error


def numbers(values: object, name: str, kind: type, count: int) -> tuple[Any, ...]:
    """`count` numbers of one kind, int or float; 2.5 and 2.0 are no int."""
    convert = operator.index if kind is int else kind
    try:
        converted = tuple(convert(value) for value in values)  # type: ignore[attr-defined]
    except (TypeError, ValueError, OverflowError) as error:
        raise NacreError(f"{name}: must be {count} numbers ({error})") from error
    if len(converted) != count:
        raise NacreError(f"{name}: must be {count} numbers (got {len(converted)})")
    return converted


def number(value: object, name: str) -> float:
    return float(numbers((value,), name, float, 1)[0])


def text(value: object, name: str) -> bytes:
    if not isinstance(value, str) or "\0" in value:
        raise NacreError(f"{name}: must be text without null characters (got {value!r})")
    return value.encode()


def take_tables(handle: c_void_p) -> list[tuple[TableInfo, np.ndarray]]:
    """Copies the tables of a result: float32 (height, width, channels), row 0 = y_min. The strings
    of the infos live as long as the result."""
    tables = []
    for index in range(lib.nacre_result_tables(handle)):
        info = TableInfo()
        check(lib.nacre_result_table(handle, index, ctypes.byref(info)))
        shape = (info.height, info.width, info.channels)
        tables.append((info, np.ctypeslib.as_array(info.texels, shape).copy()))
    return tables
