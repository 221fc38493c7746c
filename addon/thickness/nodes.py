# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stack of sources that gives a material its thickness: node groups in a row, each with what lies
below it. They work in every engine and need no add-on."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from ..materials import group as groups
from ..materials.image import hold_as_data
from ..materials.material import group_node
from ..materials.thickness import thickness_range, thickness_socket
from . import heat
from .groups import SOURCE, source_group
from .sources import (
    BELOW,
    CURVE,
    ON,
    POINT,
    POSITION,
    STRENGTH,
    UPON,
    Source,
    default_thickness,
    source,
)

MADE_HERE = "nacre_followed"
"""Custom property of objects that were made for a source to follow, and go with it."""

_FEEDS = ("TEX_COORD", "NEW_GEOMETRY", "ATTRIBUTE", "TEX_IMAGE", "VALTORGB")
"""Types of the nodes that come with a source."""


def sources_of(material: bpy.types.Material) -> list[bpy.types.ShaderNodeGroup]:
    """Our groups that lead to the thickness, the uppermost first."""
    found: list[bpy.types.ShaderNodeGroup] = []
    socket = thickness_socket(material)
    while socket is not None and socket.is_linked:
        node = socket.links[0].from_node
        if node.type != "GROUP" or not node.node_tree or SOURCE not in node.node_tree:
            break
        found.append(node)
        socket = below(node)
    return found


def timed_sources(material: bpy.types.Material) -> list[bpy.types.ShaderNodeGroup]:
    return [node for node in sources_of(material) if "Time" in node.inputs]


def spec_of(node: bpy.types.ShaderNodeGroup) -> Source:
    return source(node.node_tree[SOURCE])


def below(node: bpy.types.ShaderNodeGroup) -> bpy.types.NodeSocket | None:
    """Where what lies below a source comes in; None of those that earlier versions made, which lie
    at the bottom."""
    name = spec_of(node).below
    return node.inputs.get(name) if name == BELOW or name in node.inputs else None


def add_source(
    material: bpy.types.Material, source_id: str, around: bpy.types.Object | None = None
) -> bpy.types.ShaderNodeGroup:
    """Puts a source upon those that there are, so that they can be seen: heat adds to heat, and what
    would cover them starts at half its strength. `around`: the object of a source that follows one."""
    socket = thickness_socket(material)
    spec = source(source_id)
    under = sources_of(material)
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree = source_group(spec)
    node.name = node.label = spec.name
    node.width = 180.0
    _set_defaults(node, spec, thickness_range(socket), socket.default_value)
    _feed_vector(node, spec, around)
    if under and spec.is_heat and spec_of(under[0]).is_heat:
        node.inputs[UPON].default_value = True
    elif under and spec.stands_alone and not spec.changes_what_is_below:
        node.inputs[STRENGTH].default_value = 0.5
    _connect(material, [node, *under])
    _lay_out(material)
    return node


def covered(nodes: Sequence[bpy.types.ShaderNodeGroup]) -> set[int]:
    """Which sources of a stack, the uppermost first, nothing is seen of."""
    lid = next((index for index, node in enumerate(nodes) if _covers(node)), len(nodes))
    return set(range(lid + 1, len(nodes)))


def _covers(node: bpy.types.ShaderNodeGroup) -> bool:
    """As far as constants tell."""
    if spec_of(node).changes_what_is_below or below(node) is None:
        return False
    wanted = ((STRENGTH, 1.0), (ON, True), (UPON, False))
    found = [(node.inputs[name], value) for name, value in wanted if name in node.inputs]
    return all(not socket.is_linked and socket.default_value == value for socket, value in found)


def move_source(material: bpy.types.Material, node: bpy.types.ShaderNodeGroup, places: int) -> bool:
    """Upwards by a number of places; returns whether it went."""
    nodes = sources_of(material)
    now = nodes.index(node)
    new = now - places
    order = [other for other in nodes if other != node]
    order.insert(new, node)
    if not 0 <= new < len(nodes) or any(below(other) is None for other in order[:-1]):
        return False
    _connect(material, order)
    _lay_out(material)
    return True


def remove_source(material: bpy.types.Material, node: bpy.types.ShaderNodeGroup) -> None:
    """The others stay; nodes that fed this one alone go with it, and so does an object that was made
    for it."""
    _connect(material, [other for other in sources_of(material) if other != node])
    _remove_with_feeds(material.node_tree, node)
    _lay_out(material)
    remove_unfollowed()


def remove_sources(material: bpy.types.Material) -> None:
    """Back to one thickness."""
    for node in sources_of(material):
        remove_source(material, node)


def remove_unfollowed() -> None:
    """What was made for sources that are gone, or whose material nothing has any more: empties, curves
    and the modifiers that measure from them."""
    if heat.is_used():
        following = set(filter(_follows_curve, bpy.data.materials))
        heat.release(
            obj
            for obj in bpy.data.objects
            if obj.is_editable
            and not any(slot.material in following for slot in obj.material_slots)
        )
    for obj in [obj for obj in bpy.data.objects if MADE_HERE in obj and obj.is_editable]:
        if not followers(obj) and not any(
            heat.curve_of(other) == obj for other in bpy.data.objects
        ):
            data = obj.data
            bpy.data.objects.remove(obj)
            if data is not None and data.users == 0:
                bpy.data.curves.remove(data)


def _follows_curve(material: bpy.types.Material) -> bool:
    return any(spec_of(node).coordinates == CURVE for node in sources_of(material))


def followed(node: bpy.types.ShaderNodeGroup) -> bpy.types.Object | None:
    """The object around which a source lies."""
    coordinates = feed_of(node, "TEX_COORD", "Vector")
    return None if coordinates is None else coordinates.object


def followers(obj: bpy.types.Object) -> list[bpy.types.Material]:
    """Materials in use with a source that lies around an object. Panels ask this at each redraw: what is not
    ours is not looked into."""
    return [
        material
        for material in bpy.data.materials
        if groups.MATERIAL in material
        and material.users
        and any(followed(node) == obj for node in sources_of(material))
    ]


def _connect(material: bpy.types.Material, nodes: Sequence[bpy.types.ShaderNodeGroup]) -> None:
    """In this order, the uppermost first; what fed the lowest of our sources stays below all."""
    tree = material.node_tree
    old = sources_of(material)
    socket = thickness_socket(material)
    lowest = below(old[-1]) if old else socket
    foreign = lowest.links[0].from_socket if lowest is not None and lowest.is_linked else None
    for into in (socket, *map(below, (*old, *nodes))):
        if into is not None:
            for link in into.links:
                tree.links.remove(link)
    for node in nodes:
        tree.links.new(node.outputs[0], socket)
        socket = below(node)
    if nodes and UPON in nodes[-1].inputs:
        nodes[-1].inputs[UPON].default_value = False  # there is nothing to grow upon
    if foreign is not None and socket is not None:
        tree.links.new(foreign, socket)


def _feed_vector(
    node: bpy.types.ShaderNodeGroup, spec: Source, around: bpy.types.Object | None
) -> None:
    if spec.coordinates is None or "Vector" not in node.inputs:
        return
    tree = node.id_data
    if spec.coordinates == POSITION:
        output = tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"]
    elif spec.coordinates == CURVE:
        attribute = tree.nodes.new("ShaderNodeAttribute")
        attribute.attribute_name = heat.ATTRIBUTE
        output = attribute.outputs["Vector"]
    else:
        coordinates = tree.nodes.new("ShaderNodeTexCoord")
        if spec.coordinates == POINT:
            coordinates.object = around
        output = coordinates.outputs["Object" if spec.coordinates == POINT else spec.coordinates]
    tree.links.new(output, node.inputs["Vector"])


def _lay_out(material: bpy.types.Material) -> None:
    """Sources in a row, the uppermost beside the material; what feeds each below it, from left to
    right."""
    column, under, row = 240.0, 460.0, 340.0
    x, y = group_node(material).location
    rows = 0
    for place, node in enumerate(sources_of(material), 1):
        node.location = (x - place * column, y)
        ahead = [node]
        depth = 0
        while ahead := _feeds(ahead):
            depth += 1
            for feed in ahead:
                feed.location = (
                    x - (place + depth) * column - 60.0 * depth,
                    y - under - rows * row,
                )
        rows += depth > 0


def _feeds(nodes: Sequence[bpy.types.Node]) -> list[bpy.types.Node]:
    """What came with sources and leads into these nodes."""
    sockets = (socket for node in nodes for socket in node.inputs)
    found = (link.from_node for socket in sockets for link in socket.links)
    return list(dict.fromkeys(node for node in found if node.type in _FEEDS))


def feed_of(
    node: bpy.types.ShaderNodeGroup, kind: str, name: str = "Value"
) -> bpy.types.Node | None:
    """The nearest node of a type among those that came with a source and feed one of its inputs."""
    socket = node.inputs.get(name)
    while socket is not None and socket.is_linked:
        feed = socket.links[0].from_node
        if feed.type == kind:
            return feed
        socket = next((item for item in feed.inputs if item.is_linked), None)
    return None


def _remove_with_feeds(tree: bpy.types.NodeTree, node: bpy.types.Node) -> None:
    feeds = _feeds([node])
    tree.nodes.remove(node)
    for feed in feeds:
        if not any(output.is_linked for output in feed.outputs):
            _remove_with_feeds(tree, feed)


def image_node(node: bpy.types.ShaderNodeGroup) -> bpy.types.ShaderNodeTexImage:
    """The texture that feeds a source `map`, with a picture or still without one."""
    found = feed_of(node, "TEX_IMAGE")
    if found is None:
        tree = node.id_data
        found = tree.nodes.new("ShaderNodeTexImage")
        tree.links.new(found.outputs["Color"], node.inputs["Value"])
    return found


def link_image(
    material: bpy.types.Material,
    node: bpy.types.ShaderNodeGroup,
    image: bpy.types.Image | None,
) -> None:
    """Feeds the source `map` from a picture; without one there is a field for it."""
    image_node(node).image = image
    if image is not None:
        hold_as_data(image)
    _lay_out(material)


def link_attribute(
    material: bpy.types.Material, node: bpy.types.ShaderNodeGroup, name: str, ramp: bool
) -> None:
    """Feeds a source's value from an attribute of the mesh; of a colour, its grey value. With a ramp
    between them, what is painted can be bent: black is the minimum, white the maximum."""
    tree = material.node_tree
    attribute = tree.nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = name
    fed = node.inputs["Value"]
    if ramp:
        between = tree.nodes.new("ShaderNodeValToRGB")
        between.label = "From Painted to Thickness"
        tree.links.new(between.outputs["Color"], fed)
        fed = between.inputs["Fac"]
    tree.links.new(attribute.outputs["Fac"], fed)
    _lay_out(material)


def ramp_of(node: bpy.types.ShaderNodeGroup) -> bpy.types.ShaderNodeValToRGB | None:
    """The ramp between a painted attribute and the thickness, if there is one."""
    return feed_of(node, "VALTORGB")


def animate(node: bpy.types.ShaderNodeGroup) -> None:
    """Lets the scene's time run the source's own."""
    curve = node.inputs["Time"].driver_add("default_value")
    driver = curve.driver
    driver.type = "SCRIPTED"
    fps = driver.variables.new()
    fps.name = "fps"
    fps.type = "SINGLE_PROP"
    fps.targets[0].id_type = "SCENE"
    fps.targets[0].id = bpy.context.scene
    fps.targets[0].data_path = "render.fps"
    driver.expression = "frame / fps"


def _set_defaults(
    node: bpy.types.ShaderNodeGroup, spec: Source, span: tuple[float, float], present: float
) -> None:
    for item in spec.inputs:
        if item.follows:
            node.inputs[item.name].default_value = present
        elif item.is_thickness:
            node.inputs[item.name].default_value = default_thickness(item, span)
