# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each pass of bands is: which three, and the values of every spectrum in them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import nacre

from ..core.faults import ForeseenError
from .attributes import BASIS, IS_SPECTRAL, PASS, WAVELENGTHS, Values, polynomial_variable
from .described import DAYLIGHT, EMISSION, Described


class PlanError(ForeseenError):
    """Bands cannot be rendered so."""


@dataclass(frozen=True)
class Plan:
    """N passes of three bands; `values`: of each property in each band, (3 N,)."""

    bands: nacre.Bands
    values: dict[str, np.ndarray]
    choice: nacre.BandChoice | None = None
    kept: dict[Any, Any] = field(default_factory=dict, repr=False, compare=False)
    """What is made for it once, of all frames."""

    @property
    def passes(self) -> int:
        return len(self.bands) // 3

    def indices(self, number: int) -> tuple[int, int, int]:
        """Bands of a pass, far from each other: colour noise of neighbours adds up, of others it
        cancels out."""
        return number, number + self.passes, number + 2 * self.passes

    def properties(self, number: int) -> Values:
        """What nodes are told in this pass."""
        indices = self.indices(number)
        variables = [polynomial_variable(self.bands.wavelength_nm[k]) for k in indices]
        return {
            IS_SPECTRAL: 1.0,
            PASS: float(number),
            WAVELENGTHS: variables,
            **{name: [float(of_all[k]) for k in indices] for name, of_all in self.values.items()},
        }


def make(
    spectra: Mapping[str, Described],
    passes: int | None = None,
    *,
    films_nm: tuple[float, ...] = (),
    observer: str = "cie1931",
) -> Plan:
    """passes: None for as many as lights and films need. Raises PlanError."""
    lights = [found.as_light for found in spectra.values() if found.kind == EMISSION] or [
        DAYLIGHT.as_light
    ]
    choice = None
    try:
        if passes is None:
            bands, choice = nacre.choose_bands(lights, films_nm=films_nm, observer=observer)
        else:
            bands = nacre.bands(3 * passes, lights, observer)
    except nacre.NacreError as error:
        raise PlanError(str(error)) from error
    values = {name: in_bands(bands, found) for name, found in spectra.items()}
    nm = np.arange(360.0, 831.0)
    for name, reflectance in zip(BASIS, nacre.rgb_basis().T, strict=True):
        values[name] = np.interp(bands.wavelength_nm, nm, reflectance)
    return Plan(bands, values, choice)


def in_bands(bands: nacre.Bands, spectrum: Described) -> np.ndarray:
    """A light is of Y = 1."""
    if spectrum.kind == EMISSION:
        power = bands.in_bands(spectrum.as_light)
        return power / bands.xyz(power)[1]
    return nacre.shapes.total(nacre.shapes.Scaled(spectrum.as_spectrum), bands.wavelength_nm)
