# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral pictures: a channel for each wavelength, and the colour that they are to the eye, in one EXR.

Channels are those of A. Fichet, R. Pacanowski, A. Wilkie, "An OpenEXR Layout for Spectral Images",
Journal of Computer Graphics Techniques 10(3), 2021, which other programs read; `nacre:bands` has besides
what the colour is summed with, so that it can be summed anew for another light or eye.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .exr import LINES_OF_ZIP
from .exr_write import ExrWriter
from .space import Matrix, conversion_from_xyz

VERSION = 1
"""Of `nacre:bands`."""


@dataclass(frozen=True)
class BandTable:
    """Of N bands: N + 1 edges, what each is looked up at (nm), its colour, and whether it is a line."""

    observer: str
    edges_nm: Sequence[float]
    wavelength_nm: Sequence[float]
    xyz: Sequence[Sequence[float]]  # of an emission of 1 per nm; all together have Y = 1
    is_line: Sequence[bool]

    @property
    def channels(self) -> list[str]:
        return [channel(nm) for nm in self.wavelength_nm]

    def text(self) -> str:
        return json.dumps(
            {
                "version": VERSION,
                "observer": self.observer,
                "edges_nm": [round(float(nm), 4) for nm in self.edges_nm],
                "wavelength_nm": [float(nm) for nm in self.wavelength_nm],
                "xyz": [[float(value) for value in row] for row in self.xyz],
                "is_line": [bool(line) for line in self.is_line],
            },
            separators=(",", ":"),
        )


def channel(nm: float) -> str:
    """Of unpolarised emission: `S0.589,294nm`."""
    return f"S0.{nm:.3f}nm".replace(".", ",").replace("S0,", "S0.", 1)


def write(
    path: Path,
    bands: BandTable,
    space: Matrix,
    radiance: np.ndarray,
    *,
    rgb: np.ndarray | None = None,
    alpha: np.ndarray | None = None,
    groups: Mapping[str, np.ndarray] | None = None,
    lights: Sequence[Mapping[str, object]] = (),
) -> None:
    """A picture of `radiance`, float32 (height, width, N), per nm in each band, row 0 on top.

    groups: the same of some of the lamps, by the name of their light group; lights: for those layers whose
    lamps are of one light, `layer` (empty for the whole), `light`, its name, and its `power` in each band, of
    Y = 1.

    rgb: (height, width, 3), what the colour is to be instead of the sum over bands, as after
    denoising; alpha: (height, width). space: of the colour, the matrix to XYZ with white D65.
    Raises OSError that names the path.
    """
    height, width = radiance.shape[:2]
    attributes = {
        "spectralLayoutVersion": "1.0",
        "emissiveUnits": "relative",
        "chromaticities": chromaticities(space),
        "nacre:bands": bands.text(),
        **({"nacre:lights": json.dumps(list(lights), separators=(",", ":"))} if lights else {}),
    }
    layers = {} if groups is None else groups
    names = ["R", "G", "B", *([] if alpha is None else ["A"]), *bands.channels]
    names += [f"{group}.{name}" for group in layers for name in bands.channels]
    with ExrWriter(path, width, height, names, attributes) as writer:
        for row in range(0, height, LINES_OF_ZIP):
            lines = slice(row, row + LINES_OF_ZIP)
            seen = colour(radiance[lines], bands, space) if rgb is None else rgb[lines]
            parts = [seen, *([] if alpha is None else [alpha[lines, :, None]]), radiance[lines]]
            parts += [of_group[lines] for of_group in layers.values()]
            writer.append(np.concatenate(parts, axis=-1, dtype=np.float32))


def colour(radiance: np.ndarray, bands: BandTable, space: Matrix) -> np.ndarray:
    """(..., 3) in a space of (..., N)."""
    return radiance @ (np.asarray(bands.xyz) @ np.asarray(conversion_from_xyz(space)).T)


def chromaticities(space: Matrix) -> list[float]:
    """xy of red, green, blue and white."""
    primaries = np.asarray(space, dtype=float)
    columns = [*primaries.T, primaries.sum(axis=1)]
    return [float(value) for xyz in columns for value in (xyz / xyz.sum())[:2]]
