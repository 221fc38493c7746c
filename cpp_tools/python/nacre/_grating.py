# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Plane reflection gratings."""

from __future__ import annotations

import ctypes
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _capi
from ._native import NacreError, check, doubles, lib, text


class GratingOrders(NamedTuple):
    """order: int (orders,); direction: (orders, 3), NaN where evanescent; efficiency: (orders,)."""

    order: np.ndarray
    direction: np.ndarray
    efficiency: np.ndarray


def grating_orders(
    pitch_nm: float,
    grating_vector: ArrayLike,
    normal: ArrayLike,
    k_in: ArrayLike,
    wavelength_nm: float,
    orders: tuple[int, int] = (-3, 3),
    profile: str = "sinusoidal",
    phase_rad: float = math.pi,
    duty: float = 0.5,
) -> GratingOrders:
    """Directions and efficiencies of the diffraction orders, in any mounting.

    Parameters
    ----------
    pitch_nm, wavelength_nm : float
        Period, and wavelength in the medium of incidence, nm.
    grating_vector, normal, k_in : float, shape (3,)
        Across the grooves (its tangential part counts), out of the surface, along the light towards
        the surface; any length.
    orders : (first, last)
    profile : "sinusoidal", "rectangular" or "blazed"
    phase_rad : float
        Peak-to-valley phase of the profile.
    duty : float
        Raised fraction of the period, for "rectangular".

    Returns
    -------
    GratingOrders
        Efficiencies are shares of the reflected power; over all orders they sum to 1.

    Raises
    ------
    NacreError
        Names the field, e.g. `k_in: must point towards the surface`.

    Source: conical grating equation k_out = k_in + m (wavelength/pitch) g for the tangential parts;
    scalar efficiencies of thin phase gratings (Goodman, Introduction to Fourier Optics).
    """
    try:
        first, last = (int(order) for order in orders)
        grating = _capi.Grating(float(pitch_nm), float(wavelength_nm))
        grating.phase_rad, grating.duty = float(phase_rad), float(duty)
    except (TypeError, ValueError) as error:
        raise NacreError(f"orders, pitch_nm, wavelength_nm, phase_rad, duty: {error}") from error
    count = last - first + 1
    if not 1 <= count <= 200001:
        raise NacreError(f"orders: must ascend and stay within ±100000 (got {orders})")
    for name, value in (("grating_vector", grating_vector), ("normal", normal), ("k_in", k_in)):
        getattr(grating, name)[:] = doubles(value, name, (3,)).tolist()
    grating.profile = text(profile, "profile")
    direction, efficiency = np.empty((count, 3)), np.empty(count)
    check(
        lib.nacre_grating_orders(
            ctypes.byref(grating), first, last, direction.ctypes.data, efficiency.ctypes.data
        )
    )
    direction[~direction.any(axis=1)] = np.nan
    return GratingOrders(np.arange(first, last + 1), direction, efficiency)
