# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light groups of a view layer in bands, and what their lamps are: a lamp can be exchanged after the render
where all that a group has is of one light."""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from .described import DAYLIGHT, EMISSION, Described
from .groups import LIGHT_OF_COLOUR, LIGHT_OF_MIXTURE
from .marks import SPECTRUM, UPSAMPLING
from .plan import Plan

WHOLE = ""
"""The name of all groups together, and of what is in none."""


def names_of(scene: bpy.types.Scene, layer: bpy.types.ViewLayer) -> list[str]:
    """EEVEE has none."""
    return [group.name for group in layer.lightgroups] if scene.render.engine == "CYCLES" else []


def pass_of(name: str) -> str:
    """What Cycles calls the pass of a group."""
    return f"Combined_{name}"


def lights_of(scene: bpy.types.Scene, names: list[str], plan: Plan) -> list[dict]:
    """By layer of a picture: of which light it is, and that light in each band, of Y = 1. Layers of several
    lights are left out."""
    found = []
    for name in (WHOLE, *names):
        lights = {light.text: light for light in _lights(scene, name)}
        if len(lights) == 1:
            (light,) = lights.values()
            power = [float(value) for value in plan.values[light.attribute] / plan.white]
            found.append({"layer": name, "light": light.name, "power": power})
    return found


def _lights(scene: bpy.types.Scene, name: str) -> Iterator[Described]:
    for tree in _shining(scene, name):
        yield from _in_tree(tree, set())


def _shining(scene: bpy.types.Scene, name: str) -> Iterator[bpy.types.NodeTree]:
    """Trees of what is in a group, lamps, world and objects that may glow."""
    if scene.world is not None and name in (WHOLE, scene.world.lightgroup):
        yield scene.world.node_tree
    for item in scene.objects:
        if name not in (WHOLE, item.lightgroup):
            continue
        if item.type == "LIGHT":
            yield item.data.node_tree
        for slot in item.material_slots:
            if slot.material is not None:
                yield slot.material.node_tree


def _in_tree(tree: bpy.types.NodeTree | None, seen: set[bpy.types.NodeTree]) -> Iterator[Described]:
    if tree is None or tree in seen:
        return
    seen.add(tree)
    for node in tree.nodes:
        group = node.node_tree if node.type == "GROUP" else None
        if group is None or not any(output.is_linked for output in node.outputs):
            continue
        if SPECTRUM in group:
            described = Described.parse(group[SPECTRUM])
            if described.kind == EMISSION:
                yield described
        elif group.get(UPSAMPLING) in (LIGHT_OF_COLOUR, LIGHT_OF_MIXTURE):
            yield DAYLIGHT
        else:
            yield from _in_tree(group, seen)
