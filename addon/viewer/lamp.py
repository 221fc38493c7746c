# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The direction to a scene's lamp as a node group: of the chosen one, or at each point of the nearest."""

from __future__ import annotations

import bpy

from ..blender.formula import Formula

GROUP = "nacre_to_light"
"""Custom property of the group."""

CHOSEN = "nacre_lamp"
"""Custom property of a scene: the lamp that its fields point to."""


def group() -> bpy.types.ShaderNodeTree:
    """The file's group; without a lamp, and until `rebuild`, its vector is 0."""
    for found in bpy.data.node_groups:
        if GROUP in found and found.library is None:
            return found
    made = bpy.data.node_groups.new("Nacre To Light", "ShaderNodeTree")
    made[GROUP] = 1
    made.interface.new_socket(name="To Light", in_out="OUTPUT", socket_type="NodeSocketVector")
    made.nodes.new("NodeGroupOutput")
    return made


def rebuild(scene: bpy.types.Scene) -> None:
    """Fills the group from the scene's lamps; drivers follow where they move."""
    tree = group()
    tree.animation_data_clear()
    tree.nodes.clear()
    formula = Formula(tree)
    end_value = _direction(formula, lamps(scene))
    formula.put(end_value, formula.node("NodeGroupOutput").inputs[0])


def lamps(scene: bpy.types.Scene) -> list[bpy.types.Object]:
    """The chosen lamp alone; else the lamps that have a place; else the first sun, since all suns are
    equally far."""
    chosen = scene.get(CHOSEN)
    if chosen is not None and chosen.type == "LIGHT" and chosen.name in scene.objects:
        return [chosen]
    found = [obj for obj in scene.objects if obj.type == "LIGHT" and not obj.hide_render]
    placed = [obj for obj in found if obj.data.type != "SUN"]
    return placed or sorted(found, key=lambda obj: obj.name)[:1]


def _direction(formula: Formula, found: list[bpy.types.Object]):
    if not found:
        return (0.0, 0.0, 0.0)
    if found[0].data.type == "SUN":
        # A sun shines along its own −z.
        return _driven(formula, found[0], [f"matrix_world[2][{axis}]" for axis in range(3)])
    place = formula.node("ShaderNodeNewGeometry").outputs["Position"]
    nearest = distance = None
    for lamp in found:
        paths = [f"matrix_world[3][{axis}]" for axis in range(3)]
        away = formula.vector("SUBTRACT", _driven(formula, lamp, paths), place)
        length = formula.vector("LENGTH", away)
        if nearest is None:
            nearest, distance = away, length
            continue
        closer = formula.number("LESS_THAN", length, distance)
        change = formula.scaled(formula.vector("SUBTRACT", away, nearest), closer)
        nearest = formula.vector("ADD", nearest, change)
        distance = formula.number("MINIMUM", distance, length)
    return formula.vector("NORMALIZE", nearest)


def _driven(formula: Formula, lamp: bpy.types.Object, paths: list[str]) -> bpy.types.NodeSocket:
    node = formula.node("ShaderNodeCombineXYZ", label=lamp.name)
    for socket, path in zip(node.inputs, paths, strict=True):
        driver = socket.driver_add("default_value").driver
        driver.type = "SUM"
        target = driver.variables.new().targets[0]
        target.id = lamp
        target.data_path = path
    return node.outputs[0]
