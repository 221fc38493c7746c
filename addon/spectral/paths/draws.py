# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which bands a path takes, by a uniform number that it has."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..attributes import LIVE, LIVE_NM, PASS, WAVELENGTHS, polynomial_variable
from ..plan import Plan

COUNT = 6144
"""Equal parts of [0, 1) that are told apart: a multiple of 3, and some for each of 300 bands."""
MASKS = ("mask of X", "mask of Y", "mask of Z")
"""Rows for films: 1 in the channel of the pass that has the band."""


@dataclass(frozen=True)
class Draws:
    """bands: int (COUNT, 3), of X, Y and Z, each with a density of its own from the same number, so that what is
    grey is hardly coloured; weights: float (COUNT, 3), what the light of that band counts for."""

    plan: Plan
    bands: np.ndarray
    weights: np.ndarray

    def rows(self) -> dict[str, np.ndarray]:
        """(COUNT, 3) of each property that nodes read, as `Plan.properties` has them of a pass: lights times
        the weights, once for every path."""
        plan, bands = self.plan, self.bands
        channels = np.arange(3)
        nm = np.asarray(plan.bands.wavelength_nm)[bands]
        live = np.arange(COUNT) % 3
        is_live = live[:, None] == channels
        rows = {
            WAVELENGTHS: polynomial_variable(nm),
            PASS: (bands % plan.triples).astype(float),
            LIVE: 3.0 * is_live,
            LIVE_NM: np.repeat((nm * is_live).sum(axis=1, keepdims=True), 3, axis=1),
        }
        for channel, name in enumerate(MASKS):
            rows[name] = (plan.channels(bands[:, [channel]]) == channels).astype(float)
        for name, values in plan.values.items():
            rows[name] = np.asarray(values)[bands]
            if name in plan.lights:
                rows[name] = rows[name] / plan.white[bands] * self.weights
        return rows


def draws(plan: Plan) -> Draws:
    """By how much of X, Y and Z the lights of the plan have in each band, on average."""
    mass = np.maximum(plan.bands.XYZ, 0.0)
    lights = [plan.values[name] / plan.white for name in plan.lights]
    power = np.mean(lights, axis=0) if lights else np.ones(len(mass))
    bands, weights = np.empty((COUNT, 3), int), np.empty((COUNT, 3))
    every, is_line = np.arange(len(mass)), plan.bands.is_line
    for channel in range(3):
        density = mass[:, channel] * power
        ends = np.rint(COUNT * np.cumsum(density) / density.sum()).astype(int)
        counts = np.diff(ends, prepend=0)
        forgotten = is_line & (counts == 0) & (density > 0.0)
        counts[forgotten] = 1
        counts[counts.argmax()] -= forgotten.sum()
        # What else has hardly any part is left out, and the nearest that is not stands for it.
        drawn = np.flatnonzero((counts > 0) & ~is_line)
        nearest = every
        if drawn.size > 0:  # not where all lights are lines
            near = drawn[np.abs(drawn - every[:, None]).argmin(axis=1)]
            nearest = np.where(is_line, every, near)
        stands_for = np.bincount(nearest, mass[:, channel], len(mass))
        bands[:, channel] = np.repeat(every, counts)
        weights[:, channel] = COUNT * np.repeat(stands_for / np.maximum(counts, 1), counts)
    return Draws(plan, bands, weights)
