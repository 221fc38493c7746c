# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wave materials as opaque surfaces that only feed passes, for a render aside.

Cycles writes no passes of materials while it renders with Open Shading Language, and adds up what
lies behind a clear film. So passes are rendered by themselves: without lights, in one bounce, by
nodes, and of the first surface that is met.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator, Mapping

import bpy

from ..materials.material import input_socket
from ..materials.script import has_osl
from . import field_nodes
from .fields import field
from .probe import ProbeError

POINT, BACK, ID = "point", "back", "id"
"""Passes besides the fields: place, 1 on back faces, and the material's number from 1."""

_NODE, _PREVIOUS = "Nacre Opaque", "nacre_previous_output"


def is_vector(name: str) -> bool:
    return name == POINT or (name not in (BACK, ID) and field(name).is_vector)


@contextlib.contextmanager
def materials_as_passes(aovs: Mapping[str, str]) -> Iterator[list[bpy.types.Material]]:
    """Yields the wave materials in the order of their numbers. `aovs`: by what they hold, fields or
    the above, the names of the passes."""
    materials = field_nodes.wave_materials()
    try:
        for number, material in enumerate(materials, start=1):
            _instrument(material, number, aovs)
        _refuse_scripts(materials)
        yield materials
    finally:
        for material in materials:
            _restore(material)


def set_up(aside: bpy.types.Scene, layer: bpy.types.ViewLayer, aovs: Mapping[str, str]) -> None:
    """The settings of such a render, which a scene aside is given."""
    aside.world = None
    render, cycles = aside.render, aside.cycles
    render.engine = "CYCLES"
    render.film_transparent = True
    render.use_persistent_data = False
    if has_osl():
        cycles.shading_system = False
    cycles.film_exposure = 1.0
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = 0
    layer.material_override = None
    for name, aov_name in aovs.items():
        aov = layer.aovs.add()
        aov.name, aov.type = aov_name, "COLOR" if is_vector(name) else "VALUE"


def _instrument(material: bpy.types.Material, number: int, aovs: Mapping[str, str]) -> None:
    tree = material.node_tree
    node = field_nodes.fields_node(material)
    geometry = _add(tree, "ShaderNodeNewGeometry")
    besides = {POINT: geometry.outputs["Position"], BACK: geometry.outputs["Backfacing"]}
    for name, aov_name in aovs.items():
        output = _add(tree, "ShaderNodeOutputAOV")
        output.aov_name = aov_name
        socket = output.inputs["Color" if is_vector(name) else "Value"]
        if name == ID:
            socket.default_value = float(number)
        else:
            source = besides.get(name) or node.outputs[field(name).name]
            tree.links.new(source, socket)
    _make_opaque(tree)


def _make_opaque(tree: bpy.types.ShaderNodeTree) -> None:
    before = tree.get_output_node("CYCLES")
    output = _add(tree, "ShaderNodeOutputMaterial")
    output[_PREVIOUS] = before.name if before else ""
    if before is not None:
        output.target = before.target
        for link in before.inputs["Displacement"].links:
            tree.links.new(link.from_socket, output.inputs["Displacement"])
    output.is_active_output = True
    tree.links.new(_add(tree, "ShaderNodeEmission").outputs[0], output.inputs["Surface"])


def _add(tree: bpy.types.ShaderNodeTree, node_type: str) -> bpy.types.Node:
    node = tree.nodes.new(node_type)
    node.name = _NODE
    return node


def _restore(material: bpy.types.Material) -> None:
    tree = material.node_tree
    previous = ""
    for node in [node for node in tree.nodes if node.name.startswith(_NODE)]:
        previous = node.get(_PREVIOUS, previous)
        tree.nodes.remove(node)
    if previous in tree.nodes:
        tree.nodes[previous].is_active_output = True
    field_nodes.drop_unused(material)


def _refuse_scripts(materials: Iterable[bpy.types.Material]) -> None:
    scripted = [material.name for material in materials if _is_scripted(material)]
    if scripted:
        raise ProbeError(
            f"{', '.join(scripted)}: a script node feeds the thickness or the normal, which cannot be "
            "read back; use ordinary nodes there"
        )


def _is_scripted(material: bpy.types.Material) -> bool:
    fed = (field_nodes.thickness_of(material).socket, input_socket(material, "normal"))
    pending = [link.from_node for socket in fed if socket is not None for link in socket.links]
    seen: set[bpy.types.Node] = set()
    while pending:
        node = pending.pop()
        if node.type == "SCRIPT":
            return True
        seen.add(node)
        feeds = {link.from_node for socket in node.inputs for link in socket.links}
        if node.type == "GROUP" and node.node_tree:
            feeds.update(node.node_tree.nodes)
        pending += feeds - seen
    return False
