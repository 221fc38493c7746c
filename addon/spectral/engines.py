# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each render engine is told, so that its passes make one picture."""

from __future__ import annotations

import contextlib
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from typing import Any

import bpy
import numpy as np
from mathutils import Color

from ..blender.denoise import is_possible
from ..core.faults import ForeseenError
from .lamps import lamps_in_bands
from .light_tree import LightTree
from .marks import has_own_colour, is_drawing
from .plan import Plan

Setting = tuple[bpy.types.bpy_struct, str, Any]


class EngineError(ForeseenError):
    """It cannot render bands."""


def layer_of(scene: bpy.types.Scene) -> bpy.types.ViewLayer:
    """The one that is rendered."""
    return next((layer for layer in scene.view_layers if layer.use), scene.view_layers[0])


def settings_of(scene: bpy.types.Scene, *, denoise: bool) -> list[Setting]:
    """Of every engine. The compositor and drawings would take wavelengths for colours, and are left out."""
    render, layer = scene.render, layer_of(scene)
    return [
        (render, "use_compositing", False),
        (render, "use_sequencer", False),
        *((other, "use", other == layer) for other in scene.view_layers),
        *((item, "hide_render", True) for item in scene.objects if is_drawing(item)),
        (layer.cycles, "denoising_store_passes", denoise),
    ]


def white_lamps() -> list[Setting]:
    """Of Cycles: lamps have all of their colour in their nodes."""
    lamps = [light for light in bpy.data.lights if has_own_colour(light)]
    return [(light, "color", (1.0, 1.0, 1.0)) for light in lamps]


@contextlib.contextmanager
def having(settings: Sequence[Setting]) -> Iterator[None]:
    """They are as they were at the end."""
    before = [(owner, name, _copied(getattr(owner, name))) for owner, name, _ in settings]
    try:
        for owner, name, value in settings:
            setattr(owner, name, value)
        yield
    finally:
        for owner, name, value in reversed(before):
            setattr(owner, name, value)


def _copied(value: object) -> object:
    """A colour that is read is the property itself."""
    return tuple(value) if isinstance(value, Color) else value


class Engine(ABC):
    """Of a scene."""

    has_all_tables = True
    """Whether tables of all passes are there at once, and nothing is loaded anew from pass to pass."""
    live = 3.0
    """What a lobe that is refracted first has to be multiplied by, so that it is three times as bright."""

    def __init__(self, scene: bpy.types.Scene) -> None:
        self.scene = scene

    @property
    @abstractmethod
    def samples(self) -> int: ...

    @property
    def denoises(self) -> bool:
        return False

    @abstractmethod
    def settings(self, plan: Plan, samples: int) -> list[Setting]:
        """While passes are rendered."""

    @abstractmethod
    def begin(self, plan: Plan, number: int) -> None:
        """The pass of a number is next; `settings` are in force."""


class _Cycles(Engine):
    """Every pixel gets consecutive parts of one sequence of samples, the same for all passes: what they
    have in common, light and shade, is as smooth as if it were one render, and what is left is hardly
    coloured."""

    @property
    def samples(self) -> int:
        return self.scene.cycles.samples

    @property
    def denoises(self) -> bool:
        return self.scene.cycles.use_denoising and is_possible()

    def settings(self, plan: Plan, samples: int) -> list[Setting]:
        cycles, each = self.scene.cycles, samples_for(samples, plan.passes)
        self._light_tree = LightTree(plan)
        wanted = [
            *self._light_tree.settings(),
            (cycles, "use_adaptive_sampling", False),
            (cycles, "use_denoising", False),
            (cycles, "use_animated_seed", False),
            (cycles, "time_limit", 0.0),
            (cycles, "sample_offset", 0),
            *white_lamps(),
        ]
        if not _has_subsets(cycles):
            return [*wanted, (cycles, "samples", each)]
        return [
            *wanted,
            (cycles, "samples", each * plan.passes),
            (cycles, "use_sample_subset", True),
            (cycles, "sample_subset_length", each),
        ]

    def begin(self, plan: Plan, number: int) -> None:
        cycles = self.scene.cycles
        each = cycles.sample_subset_length if _has_subsets(cycles) else cycles.samples
        cycles.sample_offset = number * each
        self._light_tree.renew(plan.indices(number))


def _has_subsets(cycles: bpy.types.bpy_struct) -> bool:
    """From Blender 4.5 on; before, an offset alone says which part of the sequence it is."""
    return hasattr(cycles, "use_sample_subset")


class _Eevee(Engine):
    """It has no sequence to take parts of: each pass has all samples. Its textures are blurred where they
    are small, which would mix passes that lie in one picture. Of a lamp it takes the lamp's own colour, and
    no nodes."""

    has_all_tables = False
    live = 3.0**0.5
    """A body is two surfaces to it, of which it looks at the first and takes its colour twice."""

    def __init__(self, scene: bpy.types.Scene) -> None:
        super().__init__(scene)
        self._lamps: dict[bpy.types.Light, np.ndarray] = {}

    @property
    def samples(self) -> int:
        return self.scene.eevee.taa_render_samples

    def settings(self, plan: Plan, samples: int) -> list[Setting]:
        self._lamps = lamps_in_bands(plan)
        lamps = [(light, "color", tuple(light.color)) for light in self._lamps]
        return [(self.scene.eevee, "taa_render_samples", samples), *lamps]

    def begin(self, plan: Plan, number: int) -> None:
        for light, values in self._lamps.items():
            light.color = [float(values[k]) for k in plan.indices(number)]


def samples_for(samples: int, passes: int) -> int:
    """Of each pass, so that all passes together have `samples`, or a few more."""
    return max(1, -(-samples // passes))


def engine_of(scene: bpy.types.Scene) -> Engine:
    """Raises EngineError."""
    name = scene.render.engine
    if name == "CYCLES":
        return _Cycles(scene)
    if name.startswith("BLENDER_EEVEE"):
        return _Eevee(scene)
    raise EngineError(f"{name} has no bands: render with Cycles or EEVEE")
