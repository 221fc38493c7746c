# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Cycles keeps of lamps from pass to pass, where data is persistent."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from .lamps import lamps_in_bands
from .plan import Plan

_BRIGHT = 0.5
"""Sum of three channels above which Cycles takes nodes for bright. It looks anew at all lamps where those of
one cross it, and not else: a lamp that was dark then, as of a line in the pass of another, stays dark."""
_OUTDATED = 4.0
"""How many times brighter or darker a lamp may be than when it was looked at."""
_MOST_BOUNCES = 1024


class LightTree:
    """Of the scene whose bands are rendered; `renew` before each pass."""

    def __init__(self, plan: Plan) -> None:
        self._lamps = lamps_in_bands(plan)
        self._known: dict[bpy.types.Light, float] = {}
        self._last: dict[bpy.types.Light, float] = {}
        lights = sorted(self._lamps, key=lambda light: -light.cycles.max_bounces)
        self._touched = lights[0] if lights else None

    def settings(self) -> list[tuple[bpy.types.bpy_struct, str, int]]:
        """What `renew` changes, as it is."""
        return [(light.cycles, "max_bounces", light.cycles.max_bounces) for light in self._some()]

    def _some(self) -> list[bpy.types.Light]:
        return [self._touched] if self._touched is not None else []

    def renew(self, indices: Sequence[int]) -> None:
        now = {light: float(values[list(indices)].sum()) for light, values in self._lamps.items()}
        looks_anew = any(
            (bright > _BRIGHT) != (self._last.get(light, 0.0) > _BRIGHT)
            for light, bright in now.items()
        )
        if any(_is_outdated(bright, self._known.get(light, 0.0)) for light, bright in now.items()):
            if not looks_anew:
                self._touch()
            looks_anew = True
        if looks_anew:
            self._known = now
        self._last = now

    def _touch(self) -> None:
        """A change that nobody sees: any of a lamp makes Cycles look at all."""
        for light in self._some():
            most = light.cycles.max_bounces
            light.cycles.max_bounces = most - 1 if most == _MOST_BOUNCES else most + 1
            light.update_tag()


def _is_outdated(bright: float, known: float) -> bool:
    return max(bright, known) > _OUTDATED * min(bright, known)
