# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a surface is from a curve, as an attribute that geometry nodes keep up to date: shader nodes
know of no curves."""

from __future__ import annotations

from collections.abc import Iterable

import bpy

ATTRIBUTE = "Heat Distance"
"""A vector at each vertex, from the nearest point of the curve, in the object's own units."""

_GROUP, _CURVE = "nacre_heat_distance", "Curve"


def follow_curve(objects: Iterable[bpy.types.Object], curve: bpy.types.Object) -> None:
    """Gives each object the modifier, or its modifier this curve."""
    for obj in objects:
        modifier = modifier_of(obj)
        if modifier is None:
            modifier = obj.modifiers.new("Distance to Heat", "NODES")
            modifier.node_group = _group()
        holder, name = curve_property(modifier)
        if holder == modifier:
            modifier[_identifier(modifier.node_group)] = curve
        else:
            setattr(holder, name, curve)
        obj.update_tag()


def is_used() -> bool:
    """Whether anything in the file can follow a curve."""
    return any(_GROUP in group for group in bpy.data.node_groups)


def modifier_of(obj: bpy.types.Object) -> bpy.types.Modifier | None:
    found = (item for item in obj.modifiers if item.type == "NODES" and item.node_group)
    return next((item for item in found if _GROUP in item.node_group), None)


def curve_of(obj: bpy.types.Object) -> bpy.types.Object | None:
    modifier = modifier_of(obj)
    if modifier is None:
        return None
    holder, name = curve_property(modifier)
    return (
        modifier.get(_identifier(modifier.node_group))
        if holder == modifier
        else getattr(holder, name)
    )


def release(objects: Iterable[bpy.types.Object]) -> None:
    """Takes the modifier away."""
    for obj in objects:
        if modifier_of(obj) is not None:
            obj.modifiers.remove(modifier_of(obj))


def curve_property(modifier: bpy.types.Modifier) -> tuple[bpy.types.bpy_struct, str]:
    """What holds the modifier's curve, and its path from there, for panels."""
    identifier = _identifier(modifier.node_group)
    if hasattr(modifier, "properties"):  # since 5.2
        return getattr(modifier.properties.inputs, identifier), "value"
    return modifier, f'["{identifier}"]'


def _identifier(group: bpy.types.NodeTree) -> str:
    items = group.interface.items_tree
    return next(item.identifier for item in items if item.name == _CURVE)


def _group() -> bpy.types.NodeTree:
    for group in bpy.data.node_groups:
        if _GROUP in group and group.library is None:
            return group
    group = bpy.data.node_groups.new("Distance to Heat", "GeometryNodeTree")
    group[_GROUP] = True
    group.is_modifier = True
    interface = group.interface
    interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
    socket = interface.new_socket(_CURVE, in_out="INPUT", socket_type="NodeSocketObject")
    socket.description = "The surface is hottest beside this curve"
    nodes = {
        name: group.nodes.new(kind)
        for name, kind in (
            ("given", "NodeGroupInput"),
            ("object", "GeometryNodeObjectInfo"),
            ("mesh", "GeometryNodeCurveToMesh"),
            ("position", "GeometryNodeInputPosition"),
            ("nearest", "GeometryNodeProximity"),
            ("away", "ShaderNodeVectorMath"),
            ("store", "GeometryNodeStoreNamedAttribute"),
            ("result", "NodeGroupOutput"),
        )
    }
    for column, node in enumerate(nodes.values()):
        node.location = (column * 200.0, 0.0)
    nodes["object"].transform_space = "RELATIVE"
    nodes["nearest"].target_element = "EDGES"
    nodes["away"].operation = "SUBTRACT"
    nodes["store"].data_type, nodes["store"].domain = "FLOAT_VECTOR", "POINT"
    nodes["store"].inputs["Name"].default_value = ATTRIBUTE
    for source, out, target, into in (
        ("given", "Geometry", "store", "Geometry"),
        ("given", _CURVE, "object", "Object"),
        ("object", "Geometry", "mesh", 0),
        ("mesh", 0, "nearest", 0),
        ("position", "Position", "away", 0),
        ("nearest", "Position", "away", 1),
        ("away", "Vector", "store", "Value"),
        ("store", "Geometry", "result", "Geometry"),
    ):
        group.links.new(nodes[source].outputs[out], nodes[target].inputs[into])
    return group
