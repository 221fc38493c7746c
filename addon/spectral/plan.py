# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each pass of bands is: which three, and the values of every spectrum in them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import nacre

from ..core.faults import ForeseenError
from ..core.wavelengths import Wavelengths
from .attributes import (
    BASIS,
    IS_SPECTRAL,
    LIVE,
    LIVE_NM,
    PASS,
    WAVELENGTHS,
    Values,
    polynomial_variable,
)
from .described import CONSTANT, DAYLIGHT, EMISSION, Described

_EVERY_NM = np.arange(360.0, 831.0)
_LINE_F_NM, _LINE_C_NM = 486.1327, 656.2725


class PlanError(ForeseenError):
    """Bands cannot be rendered so."""


@dataclass(frozen=True)
class Plan:
    """3 N bands, three a pass; `values`: of each property in each band, (3 N,).

    Lights are rendered times `white`, so that a pass is as bright as a picture in RGB: what engines hold
    against a number, clamping, the threshold of small lights, and lights that stay RGB mean the same then.

    Where something disperses light each three are rendered thrice, as only one of them at a time goes
    through it.
    """

    bands: nacre.Bands
    values: dict[str, np.ndarray]
    choice: nacre.BandChoice | None = None
    disperses: bool = False
    lights: frozenset[str] = frozenset()
    """Names of properties that are lights."""
    kept: dict[Any, Any] = field(default_factory=dict, repr=False, compare=False)
    """What is made for it once, of all frames."""

    @property
    def white(self) -> np.ndarray:
        """(3 N,): the inverse of what each band has of a light of 1 to the eye that is the same everywhere, or
        is that line alone: a line has hardly a band's width, and would be a hundred times as bright."""
        return white_of(self.bands)

    @property
    def triples(self) -> int:
        return len(self.bands) // 3

    @property
    def turns(self) -> int:
        """How often each band is rendered."""
        return 3 if self.disperses else 1

    @property
    def passes(self) -> int:
        return self.triples * self.turns

    def triple(self, number: int) -> int:
        """Which three a pass renders."""
        return number % self.triples

    def indices(self, number: int) -> tuple[int, int, int]:
        """Bands of a pass, far from each other: colour noise of neighbours adds up, of others it
        cancels out. A long wave is in the red channel, a short one in the blue, so that what stays RGB
        looks much as in RGB."""
        first = self.triple(number)
        return first + 2 * self.triples, first + self.triples, first

    def channels(self, bands: np.ndarray) -> np.ndarray:
        """Which channel of its pass each band is in: the inverse of `indices`."""
        return 2 - bands // self.triples

    def properties(self, number: int, live: float = 3.0) -> Values:
        """What nodes are told in this pass; `live`: see engines."""
        indices = self.indices(number)
        variables = [polynomial_variable(self.bands.wavelength_nm[k]) for k in indices]
        values = {name: [float(of_all[k]) for k in indices] for name, of_all in self.values.items()}
        told = {
            IS_SPECTRAL: 1.0,
            PASS: float(self.triple(number)),
            WAVELENGTHS: variables,
            **values,
        }
        if self.disperses:
            turn = number // self.triples
            told[LIVE] = [live if channel == turn else 0.0 for channel in range(3)]
            told[LIVE_NM] = float(self.bands.wavelength_nm[indices[turn]])
        return told


def make(
    spectra: Mapping[str, Described],
    triples: int | None = None,
    *,
    wavelengths: Wavelengths | None = None,
    films: tuple[Sequence[float], np.ndarray] = ((), np.empty((0, 471))),
    spread_px: float | None = None,
    observer: str = "cie1931",
) -> Plan:
    """Of as many bands as are needed where neither the number of triples nor wavelengths are given.

    films: optical thicknesses in nm and reflectances (N, 471), those of one thickness together; spread_px: how
    far from each other what disperses sends the lines F and C, None where nothing does. Raises PlanError."""
    lights = [found.as_light for found in spectra.values() if found.kind == EMISSION] or [
        DAYLIGHT.as_light
    ]
    choice = None
    try:
        if wavelengths is not None:
            bands = nacre.develop.bands_of(wavelengths.bands, wavelengths.edges, observer=observer)
        elif triples is None:
            bands, choice = nacre.choose_bands(
                lights,
                wavelength_nm=_EVERY_NM,
                films_nm=films[0],
                film_reflectances=films[1] if len(films[0]) > 0 else None,
                observer=observer,
                **_spread(spread_px),
            )
        else:
            bands = nacre.bands(3 * triples, lights, observer)
    except nacre.NacreError as error:
        raise PlanError(str(error)) from error
    white = white_of(bands)
    values = {
        name: in_bands(bands, found) * (white if found.kind == EMISSION else 1.0)
        for name, found in spectra.items()
    }
    for name, reflectance in zip(BASIS, nacre.rgb_basis().T, strict=True):
        values[name] = np.interp(bands.wavelength_nm, _EVERY_NM, reflectance)
    shining = frozenset(name for name, found in spectra.items() if found.kind == EMISSION)
    return Plan(bands, values, choice, spread_px is not None, shining)


def white_of(bands: nacre.Bands) -> np.ndarray:
    lines, all_else = bands.XYZ.max(axis=1), bands.XYZ[~bands.is_line].sum(axis=0)
    return np.where(bands.is_line, lines, all_else.mean())


def _spread(spread_px: float | None) -> dict[str, Any]:
    """By Cauchy's formula of two terms."""
    if spread_px is None:
        return {}
    of_f, of_c = _LINE_F_NM**-2, _LINE_C_NM**-2
    return {"spreads_px": [spread_px * (_EVERY_NM**-2 - of_c) / (of_f - of_c)]}


def in_bands(bands: nacre.Bands, spectrum: Described) -> np.ndarray:
    """A light is of Y = 1."""
    if spectrum.kind == EMISSION:
        power = bands.in_bands(spectrum.as_light)
        return power / bands.xyz(power)[1]
    if spectrum.kind == CONSTANT:
        return spectrum.at(bands.wavelength_nm)
    return nacre.shapes.total(nacre.shapes.Scaled(spectrum.as_spectrum), bands.wavelength_nm)
