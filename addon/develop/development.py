# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A spectral picture and what is made of it: colours for an eye or a camera, under other lamps, and what is at
its places."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import nacre

from ..core import spectral_image
from ..core.exr import ExrError
from ..core.faults import ForeseenError
from ..core.space import Matrix, conversion_from_xyz

WHOLE = ""
"""The layer that has the light of all lamps."""


class DevelopError(ForeseenError):
    """A picture cannot be developed so."""


Lamp = tuple[str, nacre.LightSamples | str]
"""What it is called, and the light."""


@dataclass(frozen=True)
class Wish:
    """camera: of nacre.develop.cameras, in place of an eye; white: a light, or white_at: a pixel; lamps and
    strengths: by layer, what is changed."""

    observer: str = ""
    camera: str = ""
    raw: bool = False
    white: nacre.LightSamples | str | None = None
    white_at: tuple[int, int] | None = None
    exposure: float = 0.0
    lamps: Mapping[str, Lamp] = field(default_factory=dict)
    strengths: Mapping[str, float] = field(default_factory=dict)


class SpectralPicture:
    """One that is open. Raises ForeseenError that names the file, OSError."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.image = spectral_image.read(path)
        table = self.image.table
        try:
            if table is None:
                self.bands = nacre.develop.bands_of(self.image.wavelength_nm)
            else:
                self.bands = nacre.develop.bands_of(
                    table.wavelength_nm, table.edges_nm, table.is_line, table.observer
                )
        except nacre.NacreError as error:
            raise ExrError(f"{path}: {error}") from error


class Development:
    """A picture as it is wished. factors: (N,) of each layer that counts, what it is multiplied by before all is
    summed; a group is in the whole already, so that its factor is what it changes by. colours: (N, 3) of an
    emission of 1 per nm in each band, in the space. Raises DevelopError."""

    def __init__(self, picture: SpectralPicture, wish: Wish, space: Matrix) -> None:
        self._picture = picture
        self.factors = self._factors(wish)
        self.colours = self._colours(wish, space)

    def _factors(self, wish: Wish) -> dict[str, np.ndarray]:
        changed = {name: self._factor(name, wish) for name in self._picture.image.layers}
        groups = {
            name: factor - 1.0
            for name, factor in changed.items()
            if name != WHOLE and np.any(factor != 1.0)
        }
        if groups and np.any(changed[WHOLE] != 1.0):
            raise DevelopError("One lamp for all of the picture, or one for each group: not both")
        return {WHOLE: changed[WHOLE], **groups}

    def _factor(self, layer: str, wish: Wish) -> np.ndarray:
        picture = self._picture
        factor = np.full(len(picture.bands), wish.strengths.get(layer, 1.0))
        if layer not in wish.lamps:
            return factor
        name, light = wish.lamps[layer]
        before = picture.image.lamps.get(layer)
        if before is None:
            what = f"of the group {layer}" if layer else "of the picture"
            raise DevelopError(f"The lamps {what} are of several lights, or not known: not {name}")
        try:
            return factor * nacre.develop.exchange(picture.bands, before.power, light, before.light)
        except nacre.NacreError as error:
            raise DevelopError(f"{name}: {error}") from error

    def _colours(self, wish: Wish, space: Matrix) -> np.ndarray:
        bands, white = self._picture.bands, None
        try:
            if wish.white_at is not None:
                white = self.radiance(wish.white_at)
            elif wish.white is not None:
                white = bands.in_bands(wish.white)
            found = nacre.develop.colours(
                bands,
                observer=wish.observer or None,
                camera=wish.camera or None,
                raw=wish.raw,
                white=white,
                exposure=wish.exposure,
            )
        except nacre.NacreError as error:
            raise DevelopError(str(error)) from error
        return found if wish.raw else found @ np.asarray(conversion_from_xyz(space)).T

    def pixels(self) -> np.ndarray:
        """float32 (height, width, 3), row 0 on top."""
        result = np.float32(0.0)
        for layer, factor in self.factors.items():
            matrix = (factor[:, None] * self.colours).astype(np.float32)
            result = result + self._picture.image.layers[layer] @ matrix
        return result

    def radiance(self, pixel: tuple[int, int], side: int = 1) -> np.ndarray:
        """(N,) per nm, the mean of a square around a pixel from the top left, as much of it as is within."""
        x, y = pixel
        before, after = (side - 1) // 2, side // 2 + 1
        place = (slice(max(0, y - before), y + after), slice(max(0, x - before), x + after))
        return sum(
            factor * self._picture.image.layers[layer][place].mean((0, 1), dtype=float)
            for layer, factor in self.factors.items()
        )

    def metamerism(
        self, first: np.ndarray, second: np.ndarray, lamp: Lamp
    ) -> nacre.develop.Metamerism:
        """How far two radiances are apart under a lamp. Raises DevelopError."""
        name, light = lamp
        before = self._picture.image.lamps.get(WHOLE)
        if before is None or len(self.factors) > 1:
            raise DevelopError(
                "Lamps are of several lights: places are compared where all are of one"
            )
        power = before.power * self.factors[WHOLE]
        try:
            return nacre.develop.metamerism(
                self._picture.bands, first, second, power, light, before.light
            )
        except nacre.NacreError as error:
            raise DevelopError(f"{name}: {error}") from error
