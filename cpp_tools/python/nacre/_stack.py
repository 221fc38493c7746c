# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Reflection and transmission of film stacks."""

from __future__ import annotations

from collections.abc import Sequence
from ctypes import byref, c_size_t
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._capi import Coherence, GridArray
from ._native import NacreError, check, complexes, doubles, lib, polarisation


class StackResult(NamedTuple):
    """Arrays of the broadcast shape; `r` and `t` are None where no amplitude exists."""

    R: np.ndarray
    T: np.ndarray
    A: np.ndarray
    r: np.ndarray | None
    t: np.ndarray | None
    A_layers: np.ndarray | None = None


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
    *,
    spread_nm: Sequence[float] | None = None,
    bandwidth_nm: float = 0.0,
    absorption: bool = False,
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
    spread_nm : sequence of float, length layers, optional
        Standard deviation of each thickness within what is looked at, nm; R and T are then means
        over the phases of these layers.
    bandwidth_nm : float
        Gaussian band of the light, full width at half maximum in nm. Each coherent layer is damped
        by itself, at the indices of the wavelength asked for.
    absorption : bool
        Also return what each layer absorbs; only without spread and bandwidth.

    The leading shapes broadcast against each other by numpy's rules; nothing is copied that many
    items share. Several threads work on large arrays; the bits do not depend on how many.

    Returns
    -------
    StackResult
        R, T, A: float64; r, t: complex128 ratios of E at the outer faces, for "s" or "p" with
        coherent layers only, without spread and bandwidth. Opaque stacks have T = 0.
        A_layers: float64, shape (..., layers), where asked for.

    Raises
    ------
    NacreError
        Shapes that do not fit, or a value outside its range: names field and item.

    Source: Macleod, Thin-Film Optical Filters (characteristic matrix, scaled so that it cannot
    overflow); incoherent layers: Byrnes 2016, arXiv:1603.02720, section 6;
    spread and bandwidth: Airy series with damped terms (Katsidis, Siapkas 2002), for several layers
    by moments of the reflection coefficient.
    """
    n_array, d_array = complexes(n, "n"), doubles(d_nm, "d_nm")
    angle, wavelength = doubles(angle_deg, "angle_deg"), doubles(wavelength_nm, "wavelength_nm")
    which = polarisation(pol)
    if n_array.ndim == 0 or d_array.ndim == 0:
        raise NacreError("n, d_nm: must have an axis of media and one of layers")
    layers = d_array.shape[-1]
    if n_array.shape[-1] != layers + 2:
        raise NacreError(
            f"n: must list {layers + 2} media for {layers} layers (got {n_array.shape[-1]})"
        )
    flags = spreads = None
    if coherent is not None:
        flags = np.array(coherent, dtype=np.uint8)
        if flags.shape != (layers,):
            raise NacreError(f"coherent: must have {layers} flags (got {flags.shape})")
    if spread_nm is not None:
        spreads = doubles(spread_nm, "spread_nm")
        if spreads.shape != (layers,):
            raise NacreError(f"spread_nm: must have {layers} values (got {spreads.shape})")
    try:
        shape = np.broadcast_shapes(
            n_array.shape[:-1], d_array.shape[:-1], angle.shape, wavelength.shape
        )
    except ValueError as error:
        raise NacreError(f"n, d_nm, angle_deg, wavelength_nm: {error}") from error

    coherence = Coherence(
        None if flags is None else flags.ctypes.data,
        None if spreads is None else spreads.ctypes.data,
        bandwidth_nm,
    )
    fully_coherent = (
        (flags is None or bool(flags.all()))
        and (spreads is None or not spreads.any())
        and bandwidth_nm == 0.0
    )
    has_amplitudes = pol != "u" and fully_coherent
    power = np.empty((*shape, 3))
    amplitudes = np.empty((*shape, 2), dtype=np.complex128) if has_amplitudes else None
    absorbed = np.empty((*shape, layers)) if absorption else None
    check(
        lib.nacre_stack_grid(
            len(shape),
            (c_size_t * len(shape))(*shape),
            layers,
            _grid_array(n_array, shape, 1),
            _grid_array(d_array, shape, 1),
            _grid_array(angle, shape, 0),
            _grid_array(wavelength, shape, 0),
            byref(coherence),
            which,
            power.ctypes.data,
            None if amplitudes is None else amplitudes.ctypes.data,
            None if absorbed is None else absorbed.ctypes.data,
        )
    )
    r, t = (None, None) if amplitudes is None else (amplitudes[..., 0], amplitudes[..., 1])
    return StackResult(power[..., 0], power[..., 1], power[..., 2], r, t, absorbed)
