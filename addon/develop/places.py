# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is at a place of a spectral picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..blender.space import of_file
from ..core.light import FIRST_NM, LAST_NM
from ..core.space import REC709, conversion, converted, srgb


@dataclass(frozen=True)
class Place:
    """pixel: from the top left; radiance: (N,) per nm in each band; rgb: in the file's space, of a raw camera
    its channels."""

    pixel: tuple[int, int]
    radiance: np.ndarray
    rgb: tuple[float, float, float]

    @property
    def label(self) -> str:
        return f"{self.pixel[0]}, {self.pixel[1]}"

    @property
    def chip(self) -> tuple[float, float, float]:
        """As a screen shows it; what is brighter than white keeps its hue."""
        linear = converted(conversion(of_file(), REC709), self.rgb)
        brightest = max(1.0, *linear)
        return tuple(srgb(channel / brightest) for channel in linear)

    def curve(self, wavelength_nm: np.ndarray) -> tuple[float, ...]:
        """471 values from 360 nm, the brightest 0.95."""
        seen = np.maximum(self.radiance, 0.0)
        most = float(seen.max())
        grid = np.arange(FIRST_NM, LAST_NM + 1.0)
        values = np.interp(grid, wavelength_nm, seen * (0.95 / most if most > 0.0 else 0.0))
        return tuple(float(value) for value in values)


def spectra_csv(wavelength_nm: np.ndarray, places: list[Place]) -> str:
    """As `nacre develop --spectra` writes them."""
    names = [f"{place.pixel[0]} {place.pixel[1]}" for place in places]
    lines = [",".join(["wavelength_nm", *names])]
    for number, nm in enumerate(wavelength_nm):
        values = [nm, *(place.radiance[number] for place in places)]
        lines.append(",".join(repr(float(value)) for value in values))
    return "\n".join(lines) + "\n"
