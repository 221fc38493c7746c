# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Loads the shared library, whose functions _capi.py declares."""

from __future__ import annotations

import ctypes
import operator
import os
import re
from ctypes import POINTER, c_float, c_void_p
from pathlib import Path
from typing import Any

import numpy as np

from ._capi import API_VERSION, SIGNATURES, Table


class NacreError(ValueError):
    """Wrong input; the message names the field and what is allowed."""


POLARISATIONS = {"s": 0, "p": 1, "u": 2}


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
    for name, (result, arguments) in SIGNATURES.items():
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


def copied(address: int, kind: Any, shape: tuple[int, ...]) -> np.ndarray:
    """An array of what the library has at an address."""
    return np.ctypeslib.as_array(ctypes.cast(address, POINTER(kind)), shape).copy()


def take_tables(handle: c_void_p) -> list[tuple[Table, np.ndarray]]:
    """Copies the tables of a result: float32 (height, width, channels), row 0 = y_min. The strings
    of the infos live as long as the result."""
    tables = []
    for index in range(lib.nacre_result_tables(handle)):
        info = Table()
        check(lib.nacre_result_table(handle, index, ctypes.byref(info)))
        shape = (info.height, info.width, info.channels)
        tables.append((info, copied(info.texels, c_float, shape)))
    return tables
