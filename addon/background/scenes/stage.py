# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a stage is, and the list of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import bpy

from ...core.faults import ForeseenError

STAGES = (
    "furnace",
    "sphere",
    "plane",
    "bubble",
    "shaderball",
    "disc",
    "prism",
    "gem",
    "portrait",
)


class StageError(ForeseenError):
    """There is no such stage."""


@dataclass
class Stage:
    """A lit scene that waits for its material."""

    scene: bpy.types.Scene
    place: Callable[[bpy.types.Material], None]
    dress: Callable[[bpy.types.Material], None] | None = None  # drives sockets, such as thickness
    size: tuple[int, int] = (640, 480)
    samples: int = 128


def build_stage(name: str, object_name: str = "") -> Stage:
    """Replaces the open file by the stage; preferences and extensions stay. `object_name`: what stands
    on the stage `portrait`, if not its usual object."""
    if name not in STAGES:
        raise StageError(f"unknown stage {name!r}; there are: {', '.join(STAGES)}")
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    build = import_module(f".{name}", __package__).build
    return build(scene, object_name) if name == "portrait" and object_name else build(scene)


def place_on(*objects: bpy.types.Object) -> Callable[[bpy.types.Material], None]:
    """Gives the material to meshes."""

    def place(material: bpy.types.Material) -> None:
        for obj in objects:
            obj.data.materials.clear()
            obj.data.materials.append(material)

    return place
