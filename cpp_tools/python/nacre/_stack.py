# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Reflection and transmission of film stacks."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import c_size_t
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._native import GridArray, NacreError, check, complexes, doubles, lib

_POLARISATIONS = {"s": 0, "p": 1, "u": 2}


class StackResult(NamedTuple):
    """Arrays of the broadcast shape; `r` and `t` are None where no amplitude exists."""

    R: np.ndarray
    T: np.ndarray
    A: np.ndarray
    r: np.ndarray | None
    t: np.ndarray | None


def _grid_array(array: np.ndarray, shape: tuple[int, ...], tail: int) -> GridArray:
    """A contiguous array, whose last `tail` axes are one element, along the axes of `shape`."""
    lengths = array.shape[: array.ndim - tail]
    steps, elements = [0] * len(shape), 1
    for axis in range(1, len(lengths) + 1):
        if lengths[-axis] != 1:
            steps[-axis] = elements
            elements *= lengths[-axis]
    return GridArray(array.ctypes.data, (c_size_t * len(shape))(*steps))


def stack(
    n: ArrayLike,
    d_nm: ArrayLike,
    angle_deg: ArrayLike,
    wavelength_nm: ArrayLike,
    pol: str = "u",
    coherent: Sequence[bool] | None = None,
) -> StackResult:
    """Reflectance, transmittance and absorptance of stacks of plane layers.

    Parameters
    ----------
    n : complex, shape (..., layers + 2)
        Indices n + ik from the ambient (real) to the substrate; n > 0, k >= 0.
    d_nm : float, shape (..., layers)
        Thicknesses in nm, >= 0; at most 64 layers.
    angle_deg, wavelength_nm : float, shape (...)
        Angle of incidence in the ambient, [0, 90); wavelength in vacuum, nm.
    pol : "s", "p" or "u"
        Perpendicular, parallel, or the mean of both (unpolarised).
    coherent : sequence of bool, length layers, optional
        False: intensities, not amplitudes, are added across that layer. Default: all coherent.

    The leading shapes broadcast against each other by numpy's rules; nothing is copied that many
    items share. Several threads work on large arrays; the bits do not depend on how many.

    Returns
    -------
    StackResult
        R, T, A: float64; r, t: complex128 ratios of E at the outer faces, for "s" or "p" with
        coherent layers only. Opaque stacks have T = 0.

    Raises
    ------
    NacreError
        Shapes that do not fit, or a value outside its range: names field and item.

    Source: Macleod, Thin-Film Optical Filters (characteristic matrix, scaled so that it cannot
    overflow); incoherent layers: Byrnes 2016, arXiv:1603.02720, section 6.
    """
    n_array, d_array = complexes(n, "n"), doubles(d_nm, "d_nm")
    angle, wavelength = doubles(angle_deg, "angle_deg"), doubles(wavelength_nm, "wavelength_nm")
    if pol not in _POLARISATIONS:
        raise NacreError(f"pol: must be 's', 'p' or 'u' (got {pol!r})")
    if n_array.ndim == 0 or d_array.ndim == 0:
        raise NacreError("n, d_nm: must have an axis of media and one of layers")
    layers = d_array.shape[-1]
    if n_array.shape[-1] != layers + 2:
        raise NacreError(
            f"n: must list {layers + 2} media for {layers} layers (got {n_array.shape[-1]})"
        )
    flags = None
    if coherent is not None:
        flags = np.array(coherent, dtype=np.uint8)
        if flags.shape != (layers,):
            raise NacreError(f"coherent: must have {layers} flags (got {flags.shape})")
    try:
        shape = np.broadcast_shapes(
            n_array.shape[:-1], d_array.shape[:-1], angle.shape, wavelength.shape
        )
    except ValueError as error:
        raise NacreError(f"n, d_nm, angle_deg, wavelength_nm: {error}") from error

    has_amplitudes = pol != "u" and (flags is None or bool(flags.all()))
    power = np.empty((*shape, 3))
    amplitudes = np.empty((*shape, 2), dtype=np.complex128) if has_amplitudes else None
    check(
        lib.nacre_stack_grid(
            len(shape),
            (c_size_t * len(shape))(*shape),
            layers,
            _grid_array(n_array, shape, 1),
            _grid_array(d_array, shape, 1),
            _grid_array(angle, shape, 0),
            _grid_array(wavelength, shape, 0),
            None if flags is None else flags.ctypes.data,
            _POLARISATIONS[pol],
            power.ctypes.data,
            None if amplitudes is None else amplitudes.ctypes.data,
        )
    )
    r, t = (None, None) if amplitudes is None else (amplitudes[..., 0], amplitudes[..., 1])
    return StackResult(power[..., 0], power[..., 1], power[..., 2], r, t)
