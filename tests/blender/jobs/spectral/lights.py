# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Light groups in bands, inside Blender."""

from __future__ import annotations

from pathlib import Path

import bpy

from .. import extension
from ..pictures import empty_scene
from .scenes import matt, patch, rendered, seen_from_above


def groups(*, reflectances: list[str], light: str, other: str, folder: str, samples: int) -> dict:
    """A row of matt patches, the last one white, under a lamp of the group Key and a sky of the group Fill
    (before.exr), and under another lamp (after.exr); bands are those of both."""
    convert, give = extension.module("spectral.convert"), extension.module("spectral.give")
    named = extension.module("spectral.described").Described.named
    scene = empty_scene()
    for column, reflectance in enumerate([*reflectances, ""]):
        patch(scene, column, 0, matt(reflectance))
    lamp = bpy.data.lights.new("lamp", "SUN")
    lamp.angle, lamp.energy = 0.0, 2.0
    key = bpy.data.objects.new("lamp", lamp)
    scene.collection.objects.link(key)
    waiting = bpy.data.lights.new("waiting", "SUN")  # in no scene: it asks for bands
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    layer = scene.view_layers[0]
    for name in ("Key", "Fill"):
        layer.lightgroups.add(name=name)
    key.lightgroup, scene.world.lightgroup = "Key", "Fill"
    seen_from_above(scene, len(reflectances) + 1, 1, 4)
    convert.make_spectral()
    give.to_lamp(lamp, named(light))
    give.to_lamp(waiting, named(other))
    rendered(scene, str(Path(folder) / "before.exr"), samples, 16)
    give.to_lamp(lamp, named(other))
    give.to_lamp(waiting, named(light))
    return rendered(scene, str(Path(folder) / "after.exr"), samples, 16)
