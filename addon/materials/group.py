# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Node groups from the graphs of compiled materials."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import bpy

from ..blender import space
from ..core import presets
from ..core.form import OSL
from ..core.graph import GROUP_INPUT, GROUP_OUTPUT, Endpoint, Graph, Node
from ..core.manifest import DIRECTIONS, CompiledMaterial, ManifestError, Socket
from ..core.space import Matrix, converted
from .image import TABLE_CONTENT, drop_unused, is_missing, table_image
from .script import fill_script_node

SCHEMA_VERSION = 2
"""Of the custom properties below; they live in saved files. What changed is in schema.py."""

(
    MATERIAL,
    KIND,
    FORM,
    SCHEMA,
    DIGEST,
    SOCKETS,
    TEMPLATE,
    TEMPLATE_TEXT,
    RECIPE,
    WAVELENGTHS,
    NOTES,
    CONDITIONS,
    TRAITS,
    PRESETS,
) = (
    "nacre_material",
    "nacre_kind",
    "nacre_form",
    "nacre_schema",
    "nacre_digest",
    "nacre_sockets",
    "nacre_template_sha256",
    "nacre_template",
    "nacre_recipe",
    "nacre_wavelength_per_path",
    "nacre_notes",
    "nacre_conditions",
    "nacre_traits",
    "nacre_presets",
)


@dataclass(frozen=True)
class Addition:
    """What a feature adds to groups besides their graph."""

    suits: Callable[[CompiledMaterial, str], bool]  # whether it belongs to a material of a form
    is_in: Callable[[bpy.types.ShaderNodeTree], bool]
    add: Callable[[bpy.types.ShaderNodeTree], None]


ADDITIONS: list[Addition] = []

Blocks = Mapping[str, Callable[[], bpy.types.ShaderNodeTree]]
"""What makes the groups that graphs have as nodes of a type of ours, by that type."""

FORMER = "nacre_former"
"""Custom property of a node with a group of ours: the group of the form that is asked for, while one of another
form is in its place."""

_SOCKET_TYPES = {
    "float": "NodeSocketFloat",
    "int": "NodeSocketInt",
    "color": "NodeSocketColor",
    "normal": "NodeSocketVector",
    "tangent": "NodeSocketVector",
}
_COLUMN, _ROW = 220.0, 190.0


def material_group(
    material: CompiledMaterial, form: str, blocks: Blocks | None = None
) -> bpy.types.ShaderNodeTree:
    """The material's group; one of the same template and shader in the file is used again, unless
    it is linked: that one may change with its own file. Nor is one whose tables are gone."""
    additions = [addition for addition in ADDITIONS if addition.suits(material, form)]
    for group in bpy.data.node_groups:
        if group.library is not None or group.get(DIGEST) != material.digest:
            continue
        if group.get(FORM) != form or group.get(SCHEMA) != SCHEMA_VERSION:
            continue
        if not all(addition.is_in(group) for addition in additions):
            continue
        images = (node.image for node in group.nodes if node.type == "TEX_IMAGE")
        if space.is_right(group) and not any(map(is_missing, images)):
            return group
    group = bpy.data.node_groups.new(material.name, "ShaderNodeTree")
    try:
        _fill(group, material, material.graphs[form], blocks or {})
        for addition in additions:
            addition.add(group)
    except Exception:
        bpy.data.node_groups.remove(group)
        drop_unused(material)
        raise
    _tag(group, material, form)
    return group


def remove(group: bpy.types.NodeTree) -> None:
    """With the tables that nothing else has."""
    images = {node.image for node in group.nodes if node.type == "TEX_IMAGE"} - {None}
    bpy.data.node_groups.remove(group)
    for image in images:
        if image.users == 0:
            bpy.data.images.remove(image)


def socket_identifiers(group: bpy.types.NodeTree) -> dict[str, str]:
    """From manifest names to identifiers on the group's interface; empty where that is damaged."""
    try:
        found = json.loads(group.get(SOCKETS, "{}"))
    except (TypeError, ValueError):
        return {}
    inputs = {item.identifier for item in _inputs(group)}
    whole = isinstance(found, dict) and all(value in inputs for value in found.values())
    return found if whole else {}


def identifiers_in_order(group: bpy.types.NodeTree, material: CompiledMaterial) -> dict[str, str]:
    """The same from the order of the inputs, which is that of the manifest."""
    names = (socket.name for socket in material.sockets)
    return dict(zip(names, (item.identifier for item in _inputs(group)), strict=False))


def _inputs(group: bpy.types.NodeTree) -> list[bpy.types.NodeTreeInterfaceSocket]:
    return [i for i in group.interface.items_tree if getattr(i, "in_out", "") == "INPUT"]


def _tag(group: bpy.types.NodeTree, material: CompiledMaterial, form: str) -> None:
    group[SCHEMA] = SCHEMA_VERSION
    group[MATERIAL] = material.id
    group[KIND] = material.kind
    group[FORM] = form
    group[DIGEST] = material.digest
    group[TEMPLATE] = material.template_sha256
    group[TEMPLATE_TEXT] = material.template
    group[WAVELENGTHS] = material.wavelength_per_path and form == OSL
    group[NOTES] = "\n".join(material.notes)
    group[CONDITIONS] = json.dumps(material.conditions)
    group[TRAITS] = material.traits.text()
    if material.presets:
        group[PRESETS] = presets.text(material.presets)
    group[SOCKETS] = json.dumps(identifiers_in_order(group, material))
    space.state(group)


def _fill(
    group: bpy.types.NodeTree, material: CompiledMaterial, graph: Graph, blocks: Blocks
) -> None:
    matrix = space.to_file(material.to_xyz_d65)
    for socket in material.sockets:
        _add_interface_socket(group, socket, matrix)
    for name in graph.outputs:
        group.interface.new_socket(name=name, in_out="OUTPUT", socket_type="NodeSocketShader")
    nodes = {
        GROUP_INPUT: group.nodes.new("NodeGroupInput"),
        GROUP_OUTPUT: group.nodes.new("NodeGroupOutput"),
    }
    for item in graph.nodes:
        nodes[item.id] = _add_node(group, material, item, blocks)
    for source, target in graph.links:
        group.links.new(
            _source_socket(group, nodes, source, material), _find(nodes, target, "inputs")
        )
    _arrange(nodes, graph)


def _add_interface_socket(group: bpy.types.NodeTree, socket: Socket, matrix: Matrix | None) -> None:
    item = group.interface.new_socket(
        name=socket.label, in_out="INPUT", socket_type=_SOCKET_TYPES[socket.type]
    )
    item.description = socket.description
    if socket.type in DIRECTIONS:
        item.hide_value = True
    elif socket.type == "color":
        item.default_value = (*converted(matrix, socket.default), 1.0)
    else:
        number = int if socket.type == "int" else float
        item.min_value, item.max_value = number(socket.minimum), number(socket.maximum)
        item.default_value = number(socket.default)
        if (socket.minimum, socket.maximum) == (0, 1):
            item.subtype = "FACTOR"


def _add_node(
    group: bpy.types.NodeTree, material: CompiledMaterial, item: Node, blocks: Blocks
) -> bpy.types.Node:
    try:
        node = group.nodes.new("ShaderNodeGroup" if item.type in blocks else item.type)
    except RuntimeError as error:
        raise ManifestError(f"{material.id}: node {item.id}: unknown type {item.type!r}") from error
    if item.type in blocks:
        node.node_tree = blocks[item.type]()
    node.name = node.label = item.id
    for name, value in item.properties.items():
        setattr(node, name, value)
    if item.type == "ShaderNodeScript":
        fill_script_node(node, material)
    if item.table:
        table = next(table for table in material.tables if table.name == item.table)
        node.image = table_image(material, table)
        node[TABLE_CONTENT] = table.content
        node.interpolation = "Linear"
        node.extension = "EXTEND"
    for name, value in item.values.items():
        _set_default(_find({item.id: node}, Endpoint(item.id, str(name)), "inputs"), value)
    return node


def _set_default(socket: bpy.types.NodeSocket, value: Any) -> None:
    if isinstance(value, list) and socket.type == "RGBA" and len(value) == 3:
        value = [*value, 1.0]
    socket.default_value = value


def _find(nodes: dict[str, bpy.types.Node], endpoint: Endpoint, side: str) -> bpy.types.NodeSocket:
    """By identifier, then by name among the sockets in use, then by index."""
    sockets = getattr(nodes[endpoint.node], side)
    for socket in sockets:
        if socket.identifier == endpoint.socket:
            return socket
    for socket in sockets:
        if socket.name == endpoint.socket and socket.enabled:
            return socket
    if endpoint.socket.isdecimal() and int(endpoint.socket) < len(sockets):
        return sockets[int(endpoint.socket)]
    known = ", ".join(socket.identifier for socket in sockets)
    raise ManifestError(f"{endpoint}: no such socket; there are: {known}")


def _source_socket(
    group: bpy.types.NodeTree,
    nodes: dict[str, bpy.types.Node],
    source: Endpoint,
    material: CompiledMaterial,
) -> bpy.types.NodeSocket:
    if source.node != GROUP_INPUT:
        return _find(nodes, source, "outputs")
    names = [socket.name for socket in material.sockets]
    index = names.index(source.socket)
    socket = nodes[GROUP_INPUT].outputs[index]
    kind = material.sockets[index].type
    return given_or_geometry(group, socket, kind) if kind in DIRECTIONS else socket


def given_or_geometry(
    group: bpy.types.NodeTree, given: bpy.types.NodeSocket, kind: str
) -> bpy.types.NodeSocket:
    """The given direction, or the geometry's where nothing is plugged in (a zero vector).

    Inside a group an unlinked vector is the constant 0, not "no value"; Cycles folds the choice.
    """
    name = f"{kind} or geometry"
    existing = group.nodes.get(name)
    if existing:
        return existing.outputs[1]
    length = group.nodes.new("ShaderNodeVectorMath")
    length.operation = "LENGTH"
    is_given = group.nodes.new("ShaderNodeMath")
    is_given.operation = "GREATER_THAN"
    is_given.inputs[1].default_value = 0.5
    if kind == "normal":
        geometry = group.nodes.new("ShaderNodeNewGeometry")
    else:
        geometry = group.nodes.new("ShaderNodeTangent")
        geometry.direction_type, geometry.axis = "RADIAL", "Z"
    choice = group.nodes.new("ShaderNodeMix")
    choice.name = choice.label = name
    choice.data_type = "VECTOR"
    vectors = [socket for socket in choice.inputs if socket.type == "VECTOR" and socket.enabled]
    factor = next(socket for socket in choice.inputs if socket.type == "VALUE" and socket.enabled)
    group.links.new(given, length.inputs[0])
    group.links.new(length.outputs["Value"], is_given.inputs[0])
    group.links.new(is_given.outputs[0], factor)
    group.links.new(geometry.outputs[kind.capitalize()], vectors[0])
    group.links.new(given, vectors[1])
    row = 2 if kind == "normal" else 4
    for column, node in enumerate((length, is_given, geometry, choice)):
        node.location = (column * _COLUMN, row * _ROW)
    return choice.outputs[1]


def _arrange(nodes: dict[str, bpy.types.Node], graph: Graph) -> None:
    depths = graph.depths()
    rightmost = max(depths.values()) + 1
    depths[GROUP_INPUT] = rightmost
    rows: dict[int, int] = {}
    for name, node in nodes.items():
        depth = depths.get(name, rightmost)
        row = rows.get(depth, 0)
        rows[depth] = row + 1
        node.location = ((rightmost - depth) * _COLUMN, -row * _ROW)
