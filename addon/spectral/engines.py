# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each render engine is told, so that its passes make one picture."""

from __future__ import annotations

from typing import Any, Protocol

import bpy

from ..blender.denoise import is_possible
from ..core.faults import ForeseenError
from .lamps import lamps_in_bands
from .plan import Plan

Setting = tuple[bpy.types.bpy_struct, str, Any]


class EngineError(ForeseenError):
    """It cannot render bands."""


class Engine(Protocol):
    has_all_tables: bool
    """Whether tables of all passes are there at once, and nothing is loaded anew from pass to pass."""

    def samples(self, scene: bpy.types.Scene) -> int: ...
    def denoises(self, scene: bpy.types.Scene) -> bool: ...
    def settings(
        self,
        scene: bpy.types.Scene,
        layer: bpy.types.ViewLayer,
        plan: Plan,
        samples: int,
        denoise: bool,
    ) -> list[Setting]:
        """While passes are rendered."""

    def begin(self, scene: bpy.types.Scene, plan: Plan, number: int) -> None: ...


class _Cycles:
    """Every pixel gets consecutive parts of one sequence of samples, the same for all passes: what they
    have in common, light and shade, is as smooth as if it were one render, and what is left is hardly
    coloured."""

    has_all_tables = True

    def samples(self, scene: bpy.types.Scene) -> int:
        return scene.cycles.samples

    def denoises(self, scene: bpy.types.Scene) -> bool:
        return scene.cycles.use_denoising and is_possible()

    def settings(
        self,
        scene: bpy.types.Scene,
        layer: bpy.types.ViewLayer,
        plan: Plan,
        samples: int,
        denoise: bool,
    ) -> list[Setting]:
        cycles, each = scene.cycles, samples_for(samples, plan.passes)
        wanted = [
            (layer.cycles, "denoising_store_passes", denoise),
            (cycles, "use_adaptive_sampling", False),
            (cycles, "use_denoising", False),
            (cycles, "use_animated_seed", False),
            (cycles, "time_limit", 0.0),
            (cycles, "sample_offset", 0),
        ]
        if not _has_subsets(cycles):
            return [*wanted, (cycles, "samples", each)]
        return [
            *wanted,
            (cycles, "samples", each * plan.passes),
            (cycles, "use_sample_subset", True),
            (cycles, "sample_subset_length", each),
        ]

    def begin(self, scene: bpy.types.Scene, plan: Plan, number: int) -> None:
        cycles = scene.cycles
        each = cycles.sample_subset_length if _has_subsets(cycles) else cycles.samples
        cycles.sample_offset = number * each


def _has_subsets(cycles: bpy.types.bpy_struct) -> bool:
    """From Blender 4.5 on; before, an offset alone says which part of the sequence it is."""
    return hasattr(cycles, "use_sample_subset")


class _Eevee:
    """It has no sequence to take parts of: each pass has all samples. Its textures are blurred where they
    are small, which would mix passes that lie in one picture. Of a lamp it takes the lamp's own colour, and
    no nodes."""

    has_all_tables = False

    def samples(self, scene: bpy.types.Scene) -> int:
        return scene.eevee.taa_render_samples

    def denoises(self, scene: bpy.types.Scene) -> bool:
        return False

    def settings(
        self,
        scene: bpy.types.Scene,
        layer: bpy.types.ViewLayer,
        plan: Plan,
        samples: int,
        denoise: bool,
    ) -> list[Setting]:
        lamps = [(light, "color", tuple(light.color)) for light in lamps_in_bands(plan)]
        return [(scene.eevee, "taa_render_samples", samples), *lamps]

    def begin(self, scene: bpy.types.Scene, plan: Plan, number: int) -> None:
        for light, values in lamps_in_bands(plan).items():
            light.color = [float(values[k]) for k in plan.indices(number)]


def samples_for(samples: int, passes: int) -> int:
    """Of each pass, so that all passes together have `samples`, or a few more."""
    return max(1, -(-samples // passes))


def engine_of(scene: bpy.types.Scene) -> Engine:
    """Raises EngineError."""
    name = scene.render.engine
    if name == "CYCLES":
        return _Cycles()
    if name.startswith("BLENDER_EEVEE"):
        return _Eevee()
    raise EngineError(f"{name} has no bands: render with Cycles or EEVEE")
