# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Node groups that give a material its thickness; they work in every engine and need no add-on."""

from __future__ import annotations

import math
from collections.abc import Callable

import bpy

from ..core.thickness import SOCKETS, Input, Source, default_thickness, source
from .formula import Formula
from .image import hold_as_data
from .material import group_node, input_socket

SOURCE = "nacre_thickness_source"
"""Custom property of the groups below: the id of the source."""

Inputs = dict[str, bpy.types.NodeSocket]

_FEEDS = ("TEX_COORD", "ATTRIBUTE", "TEX_IMAGE", "VALTORGB")  # nodes that come with a source


def thickness_socket(material: bpy.types.Material) -> bpy.types.NodeSocket | None:
    """The input that sources feed, or None where the material has one thickness."""
    if group_node(material) is None:
        return None
    found = (input_socket(material, name) for name in SOCKETS)
    return next((socket for socket in found if socket is not None), None)


def thickness_range(socket: bpy.types.NodeSocket) -> tuple[float, float]:
    """What the material's tables cover; beyond it they hold their edge."""
    interface = socket.node.node_tree.interface.items_tree
    item = next(item for item in interface if item.identifier == socket.identifier)
    return item.min_value, item.max_value


def sources_of(material: bpy.types.Material) -> list[bpy.types.ShaderNodeGroup]:
    """Our groups that lead to the thickness, the last one first."""
    found: list[bpy.types.ShaderNodeGroup] = []
    socket = thickness_socket(material)
    while socket is not None and socket.is_linked:
        node = socket.links[0].from_node
        if node.type != "GROUP" or not node.node_tree or SOURCE not in node.node_tree:
            break
        found.append(node)
        socket = node.inputs.get("Thickness")
    return found


def add_source(material: bpy.types.Material, source_id: str) -> bpy.types.ShaderNodeGroup:
    """Feeds the thickness from a source. Swirl and spread go upon what is there; others take its
    place."""
    socket = thickness_socket(material)
    spec = source(source_id)
    tree = material.node_tree
    before = socket.links[0].from_socket if socket.is_linked else None
    if not spec.goes_upon_another:
        remove_sources(material)
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree = _group(spec)
    node.name = node.label = spec.name
    _set_defaults(node, spec, thickness_range(socket), socket.default_value)
    if spec.coordinates and "Vector" in node.inputs:
        coordinates = tree.nodes.new("ShaderNodeTexCoord")
        tree.links.new(coordinates.outputs[spec.coordinates], node.inputs["Vector"])
    if spec.goes_upon_another and before is not None:
        tree.links.new(before, node.inputs["Thickness"])
    tree.links.new(node.outputs[0], socket)
    _lay_out(material)
    return node


def _lay_out(material: bpy.types.Material) -> None:
    """Sources in a row, the last one beside the material; what feeds each below it, from left to right."""
    column, below, row = 240.0, 420.0, 340.0
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
                    y - below - rows * row,
                )
        rows += depth > 0


def _feeds(nodes: list[bpy.types.Node]) -> list[bpy.types.Node]:
    """What came with sources and leads into these nodes."""
    sockets = (socket for node in nodes for socket in node.inputs)
    found = (link.from_node for socket in sockets for link in socket.links)
    return list(dict.fromkeys(node for node in found if node.type in _FEEDS))


def remove_sources(material: bpy.types.Material) -> None:
    """Back to one thickness; nodes that fed our groups alone go with them."""
    tree = material.node_tree
    for node in sources_of(material):
        feeds = {link.from_node for socket in node.inputs for link in socket.links}
        tree.nodes.remove(node)
        for feed in feeds:
            used = any(output.is_linked for output in feed.outputs)
            if not used and feed.type in _FEEDS:
                _remove_with_feeds(tree, feed)


def _remove_with_feeds(tree: bpy.types.NodeTree, node: bpy.types.Node) -> None:
    feeds = {link.from_node for socket in node.inputs for link in socket.links}
    tree.nodes.remove(node)
    for feed in feeds:
        if feed.type in _FEEDS and not any(output.is_linked for output in feed.outputs):
            _remove_with_feeds(tree, feed)


def link_image(material: bpy.types.Material, image: bpy.types.Image) -> None:
    """Feeds the source `map` from a picture."""
    node = sources_of(material)[0]
    tree = material.node_tree
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.image = image
    hold_as_data(image)
    tree.links.new(texture.outputs["Color"], node.inputs["Value"])
    _lay_out(material)


def link_attribute(material: bpy.types.Material, name: str, ramp: bool) -> None:
    """Feeds a source's value from an attribute of the mesh; of a colour, its grey value. With a ramp
    between them, what is painted can be bent: black is the minimum, white the maximum."""
    node = sources_of(material)[0]
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


def ramp_of(source_node: bpy.types.ShaderNodeGroup) -> bpy.types.ShaderNodeValToRGB | None:
    """The ramp between a painted attribute and the thickness, if there is one."""
    value = source_node.inputs.get("Value")
    if value is None or not value.is_linked:
        return None
    feed = value.links[0].from_node
    return feed if feed.type == "VALTORGB" else None


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
        if item.name == "Thickness":
            node.inputs[item.name].default_value = present
        elif item.is_thickness:
            node.inputs[item.name].default_value = default_thickness(item, span)


def _group(spec: Source) -> bpy.types.ShaderNodeTree:
    for group in bpy.data.node_groups:
        if group.get(SOURCE) == spec.id and group.library is None:
            return group
    group = bpy.data.node_groups.new(f"Thickness: {spec.name}", "ShaderNodeTree")
    group[SOURCE] = spec.id
    for item in spec.inputs:
        _add_input(group, item)
    group.interface.new_socket(name="Thickness", in_out="OUTPUT", socket_type="NodeSocketFloat")
    formula = Formula(group)
    start = formula.node("NodeGroupInput")
    result = _FORMULAS[spec.id](formula, {socket.name: socket for socket in start.outputs})
    end = formula.node("NodeGroupOutput")
    group.links.new(result, end.inputs[0])
    return group


def _add_input(group: bpy.types.ShaderNodeTree, item: Input) -> None:
    is_vector = isinstance(item.value, tuple)
    socket = group.interface.new_socket(
        name=item.name,
        in_out="INPUT",
        socket_type="NodeSocketVector" if is_vector else "NodeSocketFloat",
    )
    socket.description = item.description
    socket.default_value = item.value
    socket.hide_value = item.name == "Vector"
    if not is_vector:
        socket.min_value, socket.max_value = item.minimum, item.maximum


def _between(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    held = formula.number("ADD", at["Value"], 0.0, clamp=True)
    return formula.mix(held, at["Minimum"], at["Maximum"])


def _as_it_is(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    return formula.number("MAXIMUM", at["Value"], 0.0)


def _drop(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """base + height (1 − r²/R²) inside, base outside."""
    r = formula.number(
        "DIVIDE", formula.vector("DISTANCE", at["Vector"], at["Centre"]), at["Radius"]
    )
    inside = formula.number("SUBTRACT", 1.0, formula.number("MULTIPLY", r, r), clamp=True)
    return formula.number("MULTIPLY_ADD", at["Height"], inside, at["Base"])


def _drainage(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """h = √(4 η z/(ρ g t)) of a film between rigid walls at the depth z: one profile for all times,
    bottom √(z/H)/√t. Above, the film has collapsed to black film, with a sharp edge."""
    separate = formula.node("ShaderNodeSeparateXYZ")
    formula.put(at["Vector"], separate.inputs[0])
    depth = formula.number("SUBTRACT", 1.0, separate.outputs["Z"], clamp=True)
    profile = formula.number("SQRT", formula.number("DIVIDE", depth, at["Time"]))
    film = formula.number("MULTIPLY", at["Bottom"], profile)
    edge = formula.number("ADD", at["Black Film"], 0.004)
    return formula.mix(
        formula.smooth_step(depth, at["Black Film"], edge), at["Black Thickness"], film
    )


def _swirl(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """Noise carried along by a flow without sources, N × ∇ψ of a noise ψ. Two copies, half a period
    apart, fade in and out, so that no copy is carried for long; with the same time comes the same
    picture, in any order of frames."""
    place = formula.scaled(at["Vector"], at["Scale"])
    flow = _flow(formula, place, formula.number("MULTIPLY", at["Time"], 0.1))
    copies = [_carried(formula, at, place, flow, start) for start in (0.0, 0.5)]
    (a, weight_a), (b, weight_b) = copies
    sum_ = formula.number("MULTIPLY_ADD", a, weight_a, formula.number("MULTIPLY", b, weight_b))
    # Two copies at half weight have less contrast than one.
    spread = formula.number(
        "SQRT",
        formula.number(
            "MULTIPLY_ADD", weight_a, weight_a, formula.number("MULTIPLY", weight_b, weight_b)
        ),
    )
    change = formula.number("MULTIPLY", formula.number("DIVIDE", sum_, spread), at["Amount"])
    factor = formula.number("MAXIMUM", formula.number("ADD", 1.0, change), 0.0)
    return formula.number("MULTIPLY", at["Thickness"], factor)


def _flow(formula: Formula, place, time) -> bpy.types.NodeSocket:
    """N × ∇ψ, by forward differences."""
    step = 0.05

    def potential(offset):
        return formula.noise(formula.vector("ADD", place, offset), 0.6, 0.0, time)

    here = potential((0.0, 0.0, 0.0))
    combine = formula.node("ShaderNodeCombineXYZ")
    for axis in range(3):
        offset = tuple(step if i == axis else 0.0 for i in range(3))
        slope = formula.number("SUBTRACT", potential(offset), here)
        formula.put(formula.number("DIVIDE", slope, step), combine.inputs[axis])
    normal = formula.node("ShaderNodeNewGeometry").outputs["Normal"]
    return formula.vector("CROSS_PRODUCT", normal, combine.outputs[0])


def _carried(formula: Formula, at: Inputs, place, flow, start: float):
    """One copy: noise from −1 to 1, and its weight, 0 where it begins anew."""
    period = 4.0  # seconds
    turns = formula.number("MULTIPLY_ADD", at["Time"], 1.0 / period, start)
    phase = formula.number("FRACT", turns)
    away = formula.number("ABSOLUTE", formula.number("MULTIPLY_ADD", phase, 2.0, -1.0))
    carried = formula.number("MULTIPLY", formula.number("MULTIPLY", phase, at["Flow"]), -4.0)
    from_where = formula.vector("ADD", place, formula.scaled(flow, carried))
    # Each turn begins with another noise.
    cycle = formula.number("MULTIPLY", formula.number("FLOOR", turns), 7.31)
    value = formula.noise(from_where, 1.0, 3.0, cycle)
    signed = formula.number("MULTIPLY_ADD", value, 2.0, -1.0)
    return signed, formula.number("SUBTRACT", 1.0, away)


def _spread(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """A Gaussian deviate by Box and Muller (1958), from two numbers that change with the sample, as
    its place within the pixel does."""
    place = formula.node("ShaderNodeNewGeometry").outputs["Position"]
    hashed = formula.node("ShaderNodeTexWhiteNoise", noise_dimensions="3D")
    formula.put(place, hashed.inputs["Vector"])
    numbers = formula.node("ShaderNodeSeparateXYZ")
    formula.put(hashed.outputs["Color"], numbers.inputs[0])
    positive = formula.number("MAXIMUM", numbers.outputs["X"], 1e-7)
    logarithm = formula.number("LOGARITHM", positive, math.e)
    radius = formula.number("SQRT", formula.number("MULTIPLY", logarithm, -2.0))
    angle = formula.number("MULTIPLY", numbers.outputs["Y"], 2.0 * math.pi)
    deviate = formula.number("MULTIPLY", radius, formula.number("COSINE", angle))
    drawn = formula.number("MULTIPLY_ADD", deviate, at["Spread"], at["Thickness"])
    return formula.number("MAXIMUM", drawn, 0.0)


_FORMULAS: dict[str, Callable[[Formula, Inputs], bpy.types.NodeSocket]] = {
    "map": _between,
    "attribute": _between,
    "attribute_nm": _as_it_is,
    "drop": _drop,
    "drainage": _drainage,
    "swirl": _swirl,
    "spread": _spread,
}
