# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of fields.py as nodes in wave materials: for passes of a render, for debug views and
for the probe. All of it is ordinary nodes, which EEVEE and every GPU run, and goes away again."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from ..blender.formula import Formula
from ..core.faults import RecipeError
from ..films.edited import stack_of
from ..materials.group import given_or_geometry
from ..materials.material import group_node, input_socket
from ..materials.thickness import thickness_range, thickness_socket
from ..materials.traits import traits
from . import lamp
from .fields import FIELDS, Field

GROUP = "nacre_fields"
"""Custom property of the group below."""

NODE = "Nacre Fields"
COLOUR = " Colour"
"""Ends the name of an output that is made for the eye."""

_PASSED_ON = "Given "
"""Starts the names of outputs that are added to materials' groups."""


@dataclass(frozen=True)
class Thickness:
    """How a material says how thick it is."""

    socket: bpy.types.NodeSocket | None  # in units of `unit_nm`; None: one thickness, `unit_nm`
    unit_nm: float
    span: tuple[float, float]  # of the socket; beyond it the tables hold their edge


def thickness_of(material: bpy.types.Material) -> Thickness:
    """Of the layer that varies, else of all layers in which light interferes; 0 where there are
    none."""
    socket = thickness_socket(material)
    if socket is not None and socket == input_socket(material, "thickness_nm"):
        return Thickness(socket, 1.0, thickness_range(socket))
    total = 0.0
    if traits(material).editable_stack:
        try:
            layers = stack_of(material).layers
        except (RecipeError, LookupError):  # made by an older version: its layers are not known
            layers = []
        total = sum(layer.thickness_nm for layer in layers if layer.coherent)
    span = (1.0, 1.0) if socket is None else thickness_range(socket)
    return Thickness(socket, total, span)


def wave_materials() -> list[bpy.types.Material]:
    """Those that can be given nodes."""
    return [
        material
        for material in bpy.data.materials
        if material.is_editable
        and (node := group_node(material)) is not None
        and node.node_tree.is_editable
    ]


# ---- The group -----------------------------------------------------------------------------------


def _group() -> bpy.types.ShaderNodeTree:
    for group in bpy.data.node_groups:
        if GROUP in group and group.library is None:
            return group
    group = bpy.data.node_groups.new(NODE, "ShaderNodeTree")
    group[GROUP] = 1
    for name, value in (("Thickness", 0.0), ("Unit (nm)", 1.0), ("Minimum", 0.0), ("Maximum", 1.0)):
        item = group.interface.new_socket(name=name, in_out="INPUT", socket_type="NodeSocketFloat")
        item.default_value = value
    normal = group.interface.new_socket(
        name="Normal", in_out="INPUT", socket_type="NodeSocketVector"
    )
    normal.hide_value = True
    formula = Formula(group)
    start = formula.node("NodeGroupInput")
    given = {socket.name: socket for socket in start.outputs}
    values = _values(formula, given)
    for item in FIELDS:
        for name in (item.name, item.name + COLOUR):
            is_vector = item.is_vector or name.endswith(COLOUR)
            group.interface.new_socket(
                name=name,
                in_out="OUTPUT",
                socket_type="NodeSocketVector" if is_vector else "NodeSocketFloat",
            )
    end = formula.node("NodeGroupOutput")
    for item in FIELDS:
        group.links.new(values[item.id], end.inputs[item.name])
        colour = _colour(formula, item, values, given)
        group.links.new(colour, end.inputs[item.name + COLOUR])
    return group


def _values(formula: Formula, given: dict) -> dict[str, bpy.types.NodeSocket]:
    normal = given_or_geometry(formula.tree, given["Normal"], "normal")
    incoming = formula.node("ShaderNodeNewGeometry").outputs["Incoming"]
    cosine = formula.number("ABSOLUTE", formula.vector("DOT_PRODUCT", incoming, normal))
    held = formula.number(
        "MINIMUM", formula.number("MAXIMUM", given["Thickness"], given["Minimum"]), given["Maximum"]
    )
    light = formula.node("ShaderNodeGroup")
    light.node_tree = lamp.group()
    return {
        "normal": normal,
        "uv": formula.node("ShaderNodeTexCoord").outputs["UV"],
        "to_camera": incoming,
        "to_light": light.outputs[0],
        "thickness": formula.number("MULTIPLY", held, given["Unit (nm)"]),
        "cos_theta": cosine,
    }


def _colour(formula: Formula, item: Field, values: dict, given: dict) -> bpy.types.NodeSocket:
    """For the eye: directions from −1 … 1 to 0 … 1, a thickness as its place in its range."""
    value = values[item.id]
    if item.id == "uv":
        return value
    if item.is_vector:
        return formula.vector("MULTIPLY_ADD", value, (0.5, 0.5, 0.5), (0.5, 0.5, 0.5))
    if item.id == "thickness":
        low, high = (
            formula.number("MULTIPLY", given[name], given["Unit (nm)"])
            for name in ("Minimum", "Maximum")
        )
        span = formula.number("MAXIMUM", formula.number("SUBTRACT", high, low), 1e-6)
        value = formula.number("DIVIDE", formula.number("SUBTRACT", value, low), span)
    grey = formula.node("ShaderNodeCombineXYZ")
    for socket in grey.inputs:
        formula.put(value, socket)
    return grey.outputs[0]


# ---- In a material -------------------------------------------------------------------------------


def fields_node(material: bpy.types.Material) -> bpy.types.ShaderNodeGroup:
    """The material's node with all fields as outputs, fed with what its group is fed with."""
    tree = material.node_tree
    node = tree.nodes.get(NODE)
    if node is None:
        node = tree.nodes.new("ShaderNodeGroup")
        node.name = node.label = NODE
        node.node_tree = _group()
        group = group_node(material)
        node.location = (group.location.x, group.location.y + 420.0)
    refresh(material)
    return node


def refresh(material: bpy.types.Material) -> None:
    """After the material's group was replaced; does nothing where no field is looked at."""
    node = material.node_tree.nodes.get(NODE)
    if node is None:
        return
    given = thickness_of(material)
    node.inputs["Unit (nm)"].default_value = given.unit_nm
    node.inputs["Minimum"].default_value, node.inputs["Maximum"].default_value = given.span
    node.inputs["Thickness"].default_value = 1.0
    normal = input_socket(material, "normal")
    for socket, name in ((given.socket, "Thickness"), (normal, "Normal")):
        if socket is not None:
            material.node_tree.links.new(_passed_on(socket), node.inputs[name])


def _passed_on(socket: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """An output of the material's group with what an input of it gets: value, link or animation."""
    node = socket.node
    group = node.node_tree
    name = _PASSED_ON + socket.name
    if name not in node.outputs:
        kind_of_socket = "NodeSocketVector" if socket.type == "VECTOR" else "NodeSocketFloat"
        group.interface.new_socket(name=name, in_out="OUTPUT", socket_type=kind_of_socket)
        start = next(inner for inner in group.nodes if inner.type == "GROUP_INPUT")
        end = next(inner for inner in group.nodes if inner.type == "GROUP_OUTPUT")
        source = next(out for out in start.outputs if out.identifier == socket.identifier)
        group.links.new(source, end.inputs[name])
    return node.outputs[name]


def drop_unused(material: bpy.types.Material) -> None:
    """Takes the node away when nothing looks at it, and what was made for it with the last one."""
    tree = material.node_tree
    node = tree.nodes.get(NODE)
    if node is None or any(output.is_linked for output in node.outputs):
        return
    tree.nodes.remove(node)
    groups_in_use = {
        group_node(other).node_tree for other in wave_materials() if NODE in other.node_tree.nodes
    }
    own = group_node(material)
    if own is not None and own.node_tree not in groups_in_use:
        interface = own.node_tree.interface
        for item in list(interface.items_tree):
            if item.item_type == "SOCKET" and item.name.startswith(_PASSED_ON):
                interface.remove(item)
    _drop_groups()


def _drop_groups() -> None:
    for tag in (GROUP, lamp.GROUP):
        for group in list(bpy.data.node_groups):
            if tag in group and group.users == 0:
                bpy.data.node_groups.remove(group)
