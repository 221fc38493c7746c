# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectra, materials and lights in textures, and FTXT, a texture as text.

Textures are float32 arrays of shape (height, width, channels), top row first. Layouts and files:
cpp_tools/doc/textures.md.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._capi import Texture
from ._native import NacreError, check, copied, doubles, lib, text

WAVELENGTH_NM = np.arange(324.0, 836.0)
"""Of the 512 samples that a texture holds of a spectrum."""
_TEXELS = {"packed": (128, 4), "single": (512, 1)}
_MATERIAL_WIDTH = 516


class Materials(NamedTuple):
    """Of n materials: intensity, n and k of shape (n, 512), colours (n, 3)."""

    intensity: np.ndarray
    n: np.ndarray
    k: np.ndarray
    colours: np.ndarray


class Lights(NamedTuple):
    """Of n lights: power of shape (n, 512), colours (n, 3)."""

    power: np.ndarray
    colours: np.ndarray


class Ftxt(NamedTuple):
    """texels: float32 (height, width, 4); comments: what `# KEY: value` lines say."""

    texels: np.ndarray
    comments: dict[str, str]


def samples(wavelength_nm: ArrayLike, values: ArrayLike, kind: str = "reflectance") -> np.ndarray:
    """Spectra at the wavelengths of a texture; outside their data the value at their end.

    A reflectance of six or more equal steps is interpolated by Sprague's polynomials (CIE 167:2005),
    anything else linearly.

    Parameters
    ----------
    wavelength_nm : float, shape (N,)
        Two or more, ascending, nm.
    values : float, shape (..., N)
    kind : "reflectance" or "emission"

    Returns
    -------
    float64, shape (..., 512), at `WAVELENGTH_NM`.

    Raises NacreError for values that are not finite and where the data do not overlap 324-835 nm.
    """
    if kind not in ("reflectance", "emission"):
        raise NacreError(f"kind: must be 'reflectance' or 'emission' (got {kind!r})")
    wavelengths = doubles(wavelength_nm, "wavelength_nm")
    given = doubles(values, "values")
    if wavelengths.ndim != 1 or given.shape[-1:] != wavelengths.shape:
        raise NacreError(
            f"values: must have shape (..., N) for wavelength_nm of shape (N,) "
            f"(got {given.shape} and {wavelengths.shape})"
        )
    result = np.empty((*given.shape[:-1], WAVELENGTH_NM.size))
    for index in np.ndindex(given.shape[:-1]):
        check(
            lib.nacre_texture_samples(
                wavelengths.size,
                wavelengths.ctypes.data,
                given[index].ctypes.data,
                int(kind == "reflectance"),
                result[index].ctypes.data,
            )
        )
    return result


def pack_spectra(values: ArrayLike, layout: str = "packed", columns: int = 1) -> np.ndarray:
    """Spectra in one texture.

    Parameters
    ----------
    values : float, shape (count, 512)
        At `WAVELENGTH_NM`.
    layout : "packed" or "single"
        RGBA, texel i of 128 holds 324 + 4 i nm and the three wavelengths after it; or one channel,
        texel i of 512 holds 324 + i nm.
    columns : int
        Spectra side by side; spectrum s stands in column s mod columns of row s // columns.

    Returns
    -------
    float32, shape (rows, columns * 128, 4) or (rows, columns * 512, 1); 0 where there is none.

    Raises NacreError for other shapes, values beyond float32, and where a side would exceed 65536.
    """
    spectra = _spectra(values, "values")
    width, channels = _texels(layout)
    columns = _count(columns, "columns")
    rows = -(-len(spectra) // columns)
    if columns * width > 65536:
        raise NacreError(f"columns: must be in [1, {65536 // width}] (got {columns})")
    texels = np.empty((rows, columns * width, channels), np.float32)
    check(
        lib.nacre_pack_spectra(
            len(spectra), spectra.ctypes.data, layout.encode(), columns, texels.ctypes.data
        )
    )
    return texels


def unpack_spectra(
    texels: ArrayLike, layout: str = "packed", columns: int = 1, count: int | None = None
) -> np.ndarray:
    """The spectra of a texture, float64 of shape (count, 512); `count`: by default all there is room
    for. Raises NacreError for a texture that is too small."""
    _texels(layout)
    columns = _count(columns, "columns")
    texture, array = _texture(texels)
    count = _count(array.shape[0] * columns if count is None else count, "count")
    values = np.empty((count, WAVELENGTH_NM.size))
    check(
        lib.nacre_unpack_spectra(
            ctypes.byref(texture), layout.encode(), columns, count, values.ctypes.data
        )
    )
    return values


def pack_materials(
    intensity: ArrayLike, n: ArrayLike, k: ArrayLike, colours: ArrayLike, *, normalise: bool = True
) -> np.ndarray:
    """All that a wavelength needs of a material in one fetch.

    Parameters
    ----------
    intensity, n, k : float, shape (count, 512)
    colours : float, shape (count, 3)
        What the intensity comes to, linear.
    normalise : bool
        n and k as (v - min) / (max - min), for bytes.

    Returns
    -------
    float32, shape (count, 516, 4)
        Texel i < 512: intensity, n, k, 1. 512: colour, 1. 513: n min, n max, k min, k max. 514 and
        515: 0.

    Raises NacreError for other shapes and for values beyond float32.
    """
    spectra = [
        _spectra(array, name) for array, name in ((intensity, "intensity"), (n, "n"), (k, "k"))
    ]
    rgb = doubles(colours, "colours", (len(spectra[0]), 3))
    for array, name in zip(spectra[1:], "nk", strict=True):
        if array.shape != spectra[0].shape:
            raise NacreError(f"{name}: must have shape {spectra[0].shape} (got {array.shape})")
    texels = np.empty((len(rgb), _MATERIAL_WIDTH, 4), np.float32)
    check(
        lib.nacre_pack_materials(
            len(rgb),
            *(array.ctypes.data for array in spectra),
            rgb.ctypes.data,
            int(normalise),
            texels.ctypes.data,
        )
    )
    return texels


def unpack_materials(texels: ArrayLike) -> Materials:
    """What `pack_materials` made, of shape (count, 516, 4). Raises NacreError for another width."""
    texture, array = _texture(texels)
    intensity, n, k = (np.empty((array.shape[0], WAVELENGTH_NM.size)) for _ in range(3))
    result = Materials(intensity, n, k, np.empty((array.shape[0], 3)))
    check(lib.nacre_unpack_materials(ctypes.byref(texture), *(part.ctypes.data for part in result)))
    return result


def pack_lights(power: ArrayLike, colours: ArrayLike) -> np.ndarray:
    """Lights, four a row: power of shape (count, 512), colours (count, 3).

    Returns float32 of shape (rows, 516, 4): channel j of texel i < 512 holds the power of light j of
    the row at 324 + i nm, texel 512 + j its colour and 1; 0 where there is none. Raises NacreError
    for other shapes and for values beyond float32.
    """
    spectra = _spectra(power, "power")
    rgb = doubles(colours, "colours", (len(spectra), 3))
    texels = np.empty((-(-len(spectra) // 4), _MATERIAL_WIDTH, 4), np.float32)
    check(
        lib.nacre_pack_lights(
            len(spectra), spectra.ctypes.data, rgb.ctypes.data, texels.ctypes.data
        )
    )
    return texels


def unpack_lights(texels: ArrayLike, count: int | None = None) -> Lights:
    """What `pack_lights` made, of shape (rows, 516, 4); `count`: by default four a row. Raises
    NacreError for a texture of another width and for more lights than it has room for."""
    texture, array = _texture(texels)
    count = _count(4 * array.shape[0] if count is None else count, "count")
    lights = Lights(np.empty((count, WAVELENGTH_NM.size)), np.empty((count, 3)))
    check(
        lib.nacre_unpack_lights(
            ctypes.byref(texture), count, lights.power.ctypes.data, lights.colours.ctypes.data
        )
    )
    return lights


def read_ftxt(path: str | os.PathLike[str]) -> Ftxt:
    """A texture from its text form. Raises NacreError with all that is wrong, each with its line,
    and OSError where the file cannot be read."""
    content = Path(path).read_bytes()
    handle = ctypes.c_void_p()
    name = text(os.fspath(path), "path")
    check(lib.nacre_read_ftxt(content, len(content), name, ctypes.byref(handle)))
    try:
        texture = Texture()
        check(lib.nacre_ftxt_texture(handle, ctypes.byref(texture)))
        shape = (texture.height, texture.width, texture.channels)
        comments = {
            lib.nacre_ftxt_key(handle, i).decode(): lib.nacre_ftxt_value(handle, i).decode()
            for i in range(lib.nacre_ftxt_comments(handle))
        }
        return Ftxt(copied(texture.texels, ctypes.c_float, shape), comments)
    finally:
        lib.nacre_ftxt_free(handle)


def ftxt(texels: ArrayLike, comments: Mapping[str, str] | None = None) -> str:
    """The text form of a texture of one to four channels: `width;height`, then `r;g;b;a` a line, in
    the shortest form that reads back as the same float32. Comments become `# KEY: value` lines.
    Raises NacreError for other shapes, numbers that are not finite, and comments of several lines."""
    texture, _array = _texture(texels)
    pairs = {
        text(key, "comments"): text(value, "comments") for key, value in (comments or {}).items()
    }
    keys, values = (
        (ctypes.c_char_p * len(pairs))(*part) for part in (pairs.keys(), pairs.values())
    )
    handle = ctypes.c_void_p()
    check(
        lib.nacre_write_ftxt(ctypes.byref(texture), len(pairs), keys, values, ctypes.byref(handle))
    )
    try:
        return str(lib.nacre_ftxt_text(handle).decode())
    finally:
        lib.nacre_ftxt_free(handle)


def _spectra(values: ArrayLike, name: str) -> np.ndarray:
    array = doubles(values, name)
    if array.ndim != 2 or array.shape[1] != WAVELENGTH_NM.size or not len(array):
        raise NacreError(f"{name}: must have shape (count, 512) (got {array.shape})")
    return array


def _texels(layout: str) -> tuple[int, int]:
    if layout not in _TEXELS:
        raise NacreError(f"layout: must be 'packed' or 'single' (got {layout!r})")
    return _TEXELS[layout]


def _count(value: object, name: str) -> int:
    number: int = _native.numbers((value,), name, int, 1)[0]
    if not 1 <= number <= 10_000_000:
        raise NacreError(f"{name}: must be in [1, 10000000] (got {number})")
    return number


def _texture(texels: ArrayLike) -> tuple[Texture, np.ndarray]:
    """The array has to live as long as the texture that points into it."""
    try:
        array = np.asarray(texels, dtype=np.float32, order="C")
    except (TypeError, ValueError) as error:
        raise NacreError(f"texels: must be real numbers ({error})") from error
    if array.ndim != 3:
        raise NacreError(f"texels: must have shape (height, width, channels) (got {array.shape})")
    height, width, channels = array.shape
    return Texture(width, height, channels, array.ctypes.data), array
