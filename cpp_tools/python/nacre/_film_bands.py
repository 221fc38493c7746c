# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films where a renderer's three channels are three bands of wavelengths."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from ctypes import c_void_p

import numpy as np
from numpy.typing import ArrayLike

from ._bands import Bands
from ._capi import WAVELENGTHS, TableSize
from ._native import NacreError, check, lib, number, numbers, take_tables
from ._native import text as encoded


def table_sizes(sizes: Mapping[str, tuple[int, int]]) -> ctypes.Array:
    """As C takes them, (height, width) by name of a table."""
    wanted = (TableSize * len(sizes))()
    for entry, (name, shape) in zip(wanted, sizes.items(), strict=True):
        height, width = numbers(shape, f"sizes[{name!r}]", int, 2)
        if not (0 < height < 2**31 and 0 < width < 2**31):
            raise NacreError(f"sizes[{name!r}]: must be above 0 (got {shape})")
        entry.name, entry.width, entry.height = encoded(name, "sizes"), width, height
    return wanted


def band_tables(
    template: str,
    bands: Bands,
    passes: ArrayLike,
    sizes: Mapping[str, tuple[int, int]],
    file: str = "template.toml",
) -> dict[str, np.ndarray]:
    """Tables of a compiled film with the reflectance in bands in place of colours.

    A band is what the film is at its wavelength; of a film with more fringes than bands can tell, its
    mean over the band to the eye.

    Parameters
    ----------
    template : str
        Text of the template.
    bands : Bands
    passes : int, shape (P, 3)
        Which band each channel of a pass is.
    sizes : mapping
        (height, width) by name of a table, as the compiled material has them. `R_schlick` and
        `lobe_...` are left out of the result.
    file : str
        What messages call the template.

    Returns
    -------
    dict
        float32 (P, height, width, 3) by name, exact to single precision at the texels.

    Raises
    ------
    NacreError
        Problems of the template, one a line; a band that is none; a table that such a film does not
        have, or not of that size.
    """
    indices = np.asarray(passes)
    if indices.ndim != 2 or indices.shape[1] != 3 or indices.dtype.kind not in "iu":
        raise NacreError(f"passes: must be whole numbers of shape (P, 3) (got {passes!r})")
    if indices.size and not 0 <= indices.min() <= indices.max() < len(bands):
        raise NacreError(f"passes: must be bands from 0 to {len(bands) - 1}")
    indices = np.ascontiguousarray(indices, dtype=np.uintp)
    handle = c_void_p()
    check(
        lib.nacre_band_tables(
            encoded(template, "template"),
            encoded(file, "file"),
            bands.handle,
            len(indices),
            indices.ctypes.data,
            len(sizes),
            table_sizes(sizes),
            ctypes.byref(handle),
        )
    )
    try:
        return {
            info.name.decode(): texels.reshape(len(indices), -1, *texels.shape[1:])
            for info, texels in take_tables(handle)
        }
    finally:
        lib.nacre_result_free(handle)


def film_fringes(
    template: str, count: int = 9, file: str = "template.toml", *, angle_deg: float = 0.0
) -> np.ndarray:
    """Reflectance of the film of a template for `choose_bands` as `film_reflectances`, `angle_deg` from its
    normal, 0 to below 90.

    Returns
    -------
    float, shape (count, 471)
        At 360 … 830 nm, of thicknesses from 0.9 times its thickest to that, evenly; of a film that does
        not vary all the same.

    Raises
    ------
    NacreError
        Problems of the template, one a line; a count that is not 2 or more, an angle.
    """
    (many,) = numbers((count,), "count", int, 1)
    angle = number(angle_deg, "angle_deg")
    if not 2 <= many <= 100_000:
        raise NacreError(f"count: must be 2 to 100000 (got {count})")
    reflectance = np.empty((many, WAVELENGTHS))
    check(
        lib.nacre_template_fringes(
            encoded(template, "template"),
            encoded(file, "file"),
            many,
            angle,
            reflectance.ctypes.data,
        )
    )
    return reflectance


def optical_thickness(template: str, file: str = "template.toml") -> float:
    """Of the film of a template at its thickest, in nm: index times thickness, summed over the layers
    in which light interferes. `choose_bands` takes it as one of `films_nm`.

    Raises
    ------
    NacreError
        Problems of the template, one a line.
    """
    thickness = ctypes.c_double()
    check(
        lib.nacre_template_optical_thickness(
            encoded(template, "template"), encoded(file, "file"), ctypes.byref(thickness)
        )
    )
    return thickness.value
