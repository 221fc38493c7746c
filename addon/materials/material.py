# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials around a material's node group."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import bpy

from ..blender import animation
from ..core.form import NODES, OSL
from ..core.manifest import CompiledMaterial
from ..core.traits import EMISSION, SURFACE, VOLUME, Traits
from . import group as groups
from . import schema
from .image import drop_unused, is_missing
from .problems import AssignedMaterial

AFTER_REBUILD: list[Callable[[bpy.types.Material], None]] = []
"""What looks at a material's group, and has to look at the new one."""
WHEN_MADE: list[Callable[[bpy.types.Material], None]] = []
"""What adds to a group that was just put in place."""

_PLACES = {SURFACE: "Surface", EMISSION: "Surface", VOLUME: "Volume"}
"""Inputs of a material's output, by the role of what leads there."""


def create_material(compiled: CompiledMaterial, form: str) -> bpy.types.Material:
    material = bpy.data.materials.new(compiled.name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    node = tree.nodes.new("ShaderNodeGroup")
    node.width = 220
    try:
        node.node_tree = groups.material_group(compiled, form)
    except Exception:
        bpy.data.materials.remove(material)
        raise
    node.name = node.label = compiled.name
    _connect(node, output, compiled.traits)
    material.surface_render_method = _render_method(compiled)
    material[groups.SCHEMA] = groups.SCHEMA_VERSION
    material[groups.MATERIAL] = compiled.id
    for add in WHEN_MADE:
        add(material)
    return material


def _connect(
    node: bpy.types.ShaderNodeGroup, output: bpy.types.ShaderNodeOutputMaterial, traits: Traits
) -> None:
    """By role, where nothing leads yet; what has the same place is added up."""
    tree = node.id_data
    fed: dict[str, list[bpy.types.NodeSocket]] = {}
    for closure in traits.closures:
        fed.setdefault(_PLACES[closure.role], []).append(node.outputs[closure.output])
    for place, (first, *others) in fed.items():
        if output.inputs[place].is_linked:
            continue
        total = first
        for other in others:
            both = tree.nodes.new("ShaderNodeAddShader")
            both.location = (output.location.x - 60.0, output.location.y - 180.0)
            tree.links.new(total, both.inputs[0])
            tree.links.new(other, both.inputs[1])
            total = both.outputs[0]
        tree.links.new(total, output.inputs[place])


def _render_method(compiled: CompiledMaterial) -> str:
    """Of EEVEE, which by itself draws lots between the closures of a pixel: the mirror image in a thin
    film, on top of what is seen through it, comes out as grain."""
    graph = compiled.graphs.get(NODES)
    return "BLENDED" if graph is not None and graph.lets_light_straight_through else "DITHERED"


def discard_material(material: bpy.types.Material, compiled: CompiledMaterial) -> None:
    """One that was just made, with its group and tables where nothing else has them."""
    group = group_node(material).node_tree
    bpy.data.materials.remove(material)
    if group.users == 0:
        bpy.data.node_groups.remove(group)
    drop_unused(compiled)


def rebuild_material(material: bpy.types.Material, compiled: CompiledMaterial, form: str) -> None:
    """Puts the group of another form, or a sound one, in place; keeps values and links."""
    node = group_node(material)
    old_group = node.node_tree
    old = groups.socket_identifiers(old_group) or groups.identifiers_in_order(old_group, compiled)
    places = {name: _index(node, identifier) for name, identifier in old.items()}
    values = {name: _value(node, identifier) for name, identifier in old.items()}
    feeds = {
        name: node.inputs[_index(node, identifier)].links[0].from_socket
        for name, identifier in old.items()
        if node.inputs[_index(node, identifier)].is_linked
    }
    is_same = old_group.get(groups.FORM) == form and old_group.get(groups.DIGEST) == compiled.digest
    if is_same and old_group.library is None:
        old_group[groups.DIGEST] = ""  # a damaged group is not to be found again
    node.node_tree = groups.material_group(compiled, form)
    names = groups.socket_identifiers(node.node_tree)
    set_values(material, {k: v for k, v in values.items() if k in names and v is not None})
    moved = {places[name]: _index(node, names[name]) for name in places if name in names}
    animation.move_inputs(material.node_tree, node, moved)
    for name, source in feeds.items():
        if name in names:
            material.node_tree.links.new(source, input_socket(material, name))
    output = next(n for n in material.node_tree.nodes if n.type == "OUTPUT_MATERIAL")
    _connect(node, output, compiled.traits)
    for follow in (*WHEN_MADE, *AFTER_REBUILD):
        follow(material)


def group_node(material: bpy.types.Material | None) -> bpy.types.ShaderNodeGroup | None:
    """The node that makes a material one of ours, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.type == "GROUP" and node.node_tree and groups.MATERIAL in node.node_tree:
            return node
    return None


def belongs_here(material: bpy.types.Material) -> bool:
    """Whether this file keeps what is changed: neither linked nor a library override, whose stack and
    values Blender takes from the library again when the file is opened."""
    return material.is_editable and material.override_library is None


def interface_item(socket: bpy.types.NodeSocket) -> bpy.types.NodeTreeInterfaceSocket:
    """What the group of a group node says of one of its inputs: limits and description."""
    items = socket.node.node_tree.interface.items_tree
    return next(item for item in items if item.identifier == socket.identifier)


def input_socket(material: bpy.types.Material, name: str) -> bpy.types.NodeSocket | None:
    """The material's input by its manifest name."""
    node = group_node(material)
    identifier = groups.socket_identifiers(node.node_tree).get(name)
    return None if identifier is None else node.inputs[_index(node, identifier)]


def set_values(material: bpy.types.Material, values: Mapping[str, Any]) -> None:
    for name, value in values.items():
        input_socket(material, name).default_value = value


def describe(material: bpy.types.Material) -> AssignedMaterial:
    tree = group_node(material).node_tree
    return AssignedMaterial(
        form=tree.get(groups.FORM, OSL),
        wavelength_per_path=bool(tree.get(groups.WAVELENGTHS, False)),
        refusal=schema.refusal(tree),
    )


def asked_form(material: bpy.types.Material) -> str:
    """The form that a material has, also while another one is in its place."""
    node = group_node(material)
    return (node.get(groups.FORMER) or node.node_tree).get(groups.FORM, OSL)


def notes(material: bpy.types.Material) -> list[str]:
    """What is worth knowing of how the material was compiled, one sentence each."""
    found = group_node(material).node_tree.get(groups.NOTES)
    return found.splitlines() if isinstance(found, str) else []


def kind(material: bpy.types.Material) -> str:
    """The word that its manifest has for it, to be shown and searched for; what is asked is in its traits."""
    node = group_node(material)
    found = node.node_tree.get(groups.KIND) if node else ""
    return found if isinstance(found, str) else ""


def missing_tables(material: bpy.types.Material) -> tuple[str, ...]:
    nodes = group_node(material).node_tree.nodes
    return tuple(n.label or n.name for n in nodes if n.type == "TEX_IMAGE" and is_missing(n.image))


def _index(node: bpy.types.Node, identifier: str) -> int:
    return next(i for i, socket in enumerate(node.inputs) if socket.identifier == identifier)


def _value(node: bpy.types.Node, identifier: str) -> Any:
    value = node.inputs[_index(node, identifier)].default_value
    return value if isinstance(value, (int, float)) else tuple(value)
