# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The common part of stages: camera, world, lamps, placing the material."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from importlib import import_module

import bpy

_MODULES = {
    "furnace": "furnace",
}


class StageError(Exception):
    """There is no such stage."""


@dataclass
class Stage:
    """A lit scene that waits for its material."""

    scene: bpy.types.Scene
    place: Callable[[bpy.types.Material], None]
    dress: Callable[[bpy.types.Material], None] | None = None
    size: tuple[int, int] = (640, 480)
    samples: int = 128
    denoise: bool = True
    notes: list[str] = field(default_factory=list)


def stage_names() -> tuple[str, ...]:
    return tuple(_MODULES)


def build_stage(name: str) -> Stage:
    """Replaces the open file by the stage; preferences and extensions stay."""
    if name not in _MODULES:
        raise StageError(f"unknown stage {name!r}; there are: {', '.join(_MODULES)}")
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    module = import_module(f".{_MODULES[name]}", __package__)
    return module.build(scene)
