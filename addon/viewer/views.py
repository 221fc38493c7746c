# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wave materials that show a field in place of their surface, for a while.

A material keeps all of its nodes: a second output is added and made the active one. What is shown is
read back from these nodes, so that undo and files always agree with it. Files are saved without it.
"""

from __future__ import annotations

import bpy
from bpy.app.handlers import persistent

from ..gems import cut_stone
from ..materials.material import AFTER_REBUILD, group_node
from . import field_nodes, lamp
from .fields import SHADED, field

EMISSION, OUTPUT = "Nacre View", "Nacre View Output"
_PREVIOUS, _SHOWN = "nacre_previous_output", "nacre_view"

_TARGETS = {"CYCLES": "CYCLES"}

_while_saving: list[str] = []  # one at most: what is shown again afterwards


def shown() -> str:
    """The id of the field that is shown, or SHADED."""
    for material in bpy.data.materials:
        node = material.node_tree and material.node_tree.nodes.get(OUTPUT)
        if node:
            return node.get(_SHOWN, SHADED)
    return SHADED


def show(scene: bpy.types.Scene, field_id: str) -> None:
    """Of every wave material of the file."""
    if field_id == SHADED:
        for material in bpy.data.materials:
            if material.is_editable and material.node_tree:
                _take_back(material)
        return
    lamp.rebuild(scene)
    for material in field_nodes.wave_materials():
        _put(material, field_id, _TARGETS.get(scene.render.engine, "EEVEE"))


def choose_lamp(scene: bpy.types.Scene, chosen: bpy.types.Object | None) -> None:
    """None: the nearest."""
    if chosen is not None:
        scene[lamp.CHOSEN] = chosen
    else:
        scene.pop(lamp.CHOSEN, None)
    if any(lamp.GROUP in group for group in bpy.data.node_groups):
        lamp.rebuild(scene)


def _put(material: bpy.types.Material, field_id: str, engine: str) -> None:
    tree = material.node_tree
    output = tree.nodes.get(OUTPUT)
    stone = tree.nodes.get(cut_stone.SHADER)
    if output is None:
        previous = tree.get_output_node(engine)
        if stone is not None and previous == stone:
            previous = tree.get_output_node("ALL")
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        output.name = output.label = OUTPUT
        # An output for one engine goes before one for all.
        output.target = previous.target if previous else "ALL"
        output[_PREVIOUS] = previous.name if previous else ""
        emission = tree.nodes.new("ShaderNodeEmission")
        emission.name = emission.label = EMISSION
        tree.links.new(emission.outputs[0], output.inputs["Surface"])
    output[_SHOWN] = field_id
    output.is_active_output = True
    node = field_nodes.fields_node(material)
    emission = tree.nodes[EMISSION]
    emission.location = (node.location.x + 240.0, node.location.y + 160.0)
    output.location = (emission.location.x + 200.0, emission.location.y)
    colour = node.outputs[field(field_id).name + field_nodes.COLOUR]
    tree.links.new(colour, emission.inputs["Color"])
    if stone is not None:  # for EEVEE alone, it goes before one for all
        tree.links.new(emission.outputs[0], stone.inputs["Surface"])


def _take_back(material: bpy.types.Material) -> None:
    tree = material.node_tree
    output = tree.nodes.get(OUTPUT)
    if output is None:
        return
    previous = tree.nodes.get(output.get(_PREVIOUS, ""))
    tree.nodes.remove(output)
    emission = tree.nodes.get(EMISSION)
    if emission is not None:
        tree.nodes.remove(emission)
    if previous is not None:
        previous.is_active_output = True
    cut_stone.show(material, group_node(material))
    field_nodes.drop_unused(material)


@persistent
def _before_save(*_arguments) -> None:
    _while_saving[:] = [shown()]
    show(bpy.context.scene, SHADED)


@persistent
def _after_save(*_arguments) -> None:
    while _while_saving:
        show(bpy.context.scene, _while_saving.pop())


_HANDLERS = (
    ("save_pre", _before_save),
    ("save_post", _after_save),
    ("save_post_fail", _after_save),
)


def register() -> None:
    AFTER_REBUILD.append(field_nodes.refresh)
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister() -> None:
    AFTER_REBUILD.remove(field_nodes.refresh)
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    if hasattr(bpy.data, "materials"):  # not while Blender starts or ends
        show(bpy.context.scene, SHADED)
