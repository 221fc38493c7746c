# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The spectral picture that is open, and what is shown of it: of this session, so that undo leaves it alone."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import bpy
import numpy as np

from ..blender.float_image import as_image
from ..blender.space import of_file
from ..blender.windows import redraw_panels
from ..core.faults import ForeseenError

if TYPE_CHECKING:
    import nacre

    from .development import Development, Lamp, SpectralPicture, Wish
    from .places import Place

FILE, KEEP, NONE, PLACE = "FILE", "KEEP", "NONE", "PLACE"
"""In lists: the observer of the file, the lamps as they are, no adaptation, the first place."""
_EYES = ("cie1931", "cie1964")


@dataclass
class Shown:
    """problem: why what is wished is not shown; apart: of the first two places."""

    picture: SpectralPicture
    problem: str = ""
    places: list[Place] = field(default_factory=list)
    apart: nacre.develop.Metamerism | None = None
    why_not_compared: str = ""

    @property
    def image_name(self) -> str:
        return f"{self.picture.path.stem[:48]} developed"


_shown: list[Shown] = []  # one at most


def shown() -> Shown | None:
    return _shown[0] if _shown else None


def forget() -> None:
    _shown.clear()


def is_camera(viewer: str) -> bool:
    return viewer != FILE and viewer not in _EYES


def open_file(path: Path, settings) -> bpy.types.Image:
    """As it was rendered. Raises ForeseenError, OSError; what was open stays then."""
    from .development import SpectralPicture

    opened = SpectralPicture(path)
    _shown[:] = [Shown(opened)]
    settings.begin(opened)
    _renew(shown(), settings)
    return bpy.data.images[shown().image_name]


def renew(settings, *, with_picture: bool = True) -> None:
    """What is shown, as it is wished now; the picture as it is, where that cannot have changed."""
    current = shown()
    if current is None:
        return
    try:
        _renew(current, settings, with_picture=with_picture)
        current.problem = ""
    except ForeseenError as error:
        current.problem = str(error)
    redraw_panels()


def renew_places(settings) -> None:
    """After others are measured; the first of them may be white."""
    renew(settings, with_picture=settings.white == PLACE)


def _renew(current: Shown, settings, *, with_picture: bool = True) -> None:
    from .development import Development

    made = Development(current.picture, _wish(settings), of_file())
    if with_picture:
        rgb, alpha = made.pixels(), current.picture.image.alpha
        if alpha is None:
            alpha = np.ones(rgb.shape[:2], np.float32)
        as_image(rgb, alpha, current.image_name)
    _measure(current, settings, made)


def _measure(current: Shown, settings, made: Development) -> None:
    from .places import Place

    current.places = []
    for item in settings.places:
        radiance = made.radiance(tuple(item.pixel), settings.side)
        rgb = tuple(float(channel) for channel in radiance @ made.colours)
        current.places.append(Place(tuple(item.pixel), radiance, rgb))
    current.apart, current.why_not_compared = None, ""
    if len(current.places) < 2:
        return
    first, second = (place.radiance for place in current.places[:2])
    try:
        current.apart = made.metamerism(first, second, _lamp(settings.under))
    except ForeseenError as error:
        current.why_not_compared = str(error)


def _lamp(identifier: str) -> Lamp:
    from ..spectral.described import EMISSION, Described

    found = Described.named(identifier, EMISSION)
    return found.name, found.as_light


def _wish(settings) -> Wish:
    """Raises ForeseenError."""
    from .development import DevelopError, Wish

    viewer, white = settings.viewer, settings.white
    if white == PLACE and not settings.places:
        raise DevelopError("Measure what is white first: it is the first place")
    return Wish(
        observer=viewer if viewer in _EYES else "",
        camera=viewer if is_camera(viewer) else "",
        raw=is_camera(viewer) and settings.raw,
        white=None if white in (NONE, PLACE) else _lamp(white)[1],
        white_at=tuple(settings.places[0].pixel) if white == PLACE else None,
        exposure=settings.exposure,
        lamps={lamp.layer: _lamp(lamp.light) for lamp in settings.lamps if lamp.light != KEEP},
        strengths={lamp.layer: lamp.strength for lamp in settings.lamps},
    )
