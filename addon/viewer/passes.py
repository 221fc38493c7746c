# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of wave materials as passes of a render (AOVs)."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator

import bpy

from . import field_nodes, lamp, opaque
from .camera import scene_aside
from .fields import FIELDS, Field

NODE = "Nacre Pass "
"""Starts the names of our output nodes."""

NOT_WITH_OSL = "Cycles leaves passes empty while it renders with Open Shading Language"

_THRESHOLD = "nacre_pass_alpha_threshold"


def add(scene: bpy.types.Scene, ids: Iterable[str]) -> int:
    """One render then has these fields of all wave materials, in every engine. Returns how many
    materials that are."""
    chosen = set(ids)
    wanted = [item for item in FIELDS if item.id in chosen]
    for layer in scene.view_layers:
        for item in wanted:
            _declare(layer, item)
        # Cycles adds up what lies behind a clear film until a surface is this opaque.
        if _THRESHOLD not in layer:
            layer[_THRESHOLD] = layer.pass_alpha_threshold
        layer.pass_alpha_threshold = 0.0
    materials = field_nodes.wave_materials()
    lamp.rebuild(scene)
    for material in materials:
        node = field_nodes.fields_node(material)
        for item in wanted:
            _output(material, item, node.outputs[item.name])
    return len(materials)


def remove(scene: bpy.types.Scene) -> None:
    """Everything as it was before `add`."""
    names = {item.aov for item in FIELDS}
    for layer in scene.view_layers:
        for aov in [aov for aov in layer.aovs if aov.name in names]:
            layer.aovs.remove(aov)
        if _THRESHOLD in layer:
            layer.pass_alpha_threshold = layer[_THRESHOLD]
            del layer[_THRESHOLD]
    for material in field_nodes.wave_materials():
        tree = material.node_tree
        for node in [node for node in tree.nodes if node.name.startswith(NODE)]:
            tree.nodes.remove(node)
        field_nodes.drop_unused(material)


@contextlib.contextmanager
def rendered(
    scene: bpy.types.Scene, layer: bpy.types.ViewLayer, ids: Iterable[str]
) -> Iterator[bpy.types.Scene]:
    """A scene aside whose render result has these fields, with the picture's samples, in any form of
    the materials."""
    aovs = {item.id: item.aov for item in FIELDS if item.id in set(ids)}
    lamp.rebuild(scene)
    with opaque.materials_as_passes(aovs), scene_aside(scene, layer) as aside:
        opaque.set_up(aside, next(layer for layer in aside.view_layers if layer.use), aovs)
        bpy.ops.render.render(scene=aside.name)
        yield aside


def present(scene: bpy.types.Scene) -> list[Field]:
    declared = {aov.name for layer in scene.view_layers for aov in layer.aovs}
    return [item for item in FIELDS if item.aov in declared]


def _declare(layer: bpy.types.ViewLayer, item: Field) -> None:
    aov = next((aov for aov in layer.aovs if aov.name == item.aov), None) or layer.aovs.add()
    aov.name = item.aov
    aov.type = "COLOR" if item.is_vector else "VALUE"


def _output(material: bpy.types.Material, item: Field, socket: bpy.types.NodeSocket) -> None:
    tree = material.node_tree
    name = NODE + item.id
    node = tree.nodes.get(name) or tree.nodes.new("ShaderNodeOutputAOV")
    node.name, node.label = name, item.name
    node.aov_name = item.aov
    node.location = (
        socket.node.location.x + 240.0,
        socket.node.location.y - 90.0 * FIELDS.index(item),
    )
    tree.links.new(socket, node.inputs["Color" if item.is_vector else "Value"])
