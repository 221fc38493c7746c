# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sources of a thickness as node groups: ordinary nodes, which every engine runs."""

from __future__ import annotations

import math
from collections.abc import Callable

import bpy

from ..blender.formula import Formula
from .sources import BELOW, ON, STRENGTH, UPON, ZERO_CELSIUS, Input, Source

SOURCE, FORM = "nacre_thickness_source", "nacre_thickness_form"
"""Custom properties of the groups: the id of the source, and which form of its sockets it has."""

FORM_NOW = 3  # 1: no layer below, no strength; 2: heat covers heat

Inputs = dict[str, bpy.types.NodeSocket]


def source_group(spec: Source) -> bpy.types.ShaderNodeTree:
    """The one of the file, or a new one."""
    for group in bpy.data.node_groups:
        is_it = group.get(SOURCE) == spec.id and group.get(FORM) == FORM_NOW
        if is_it and group.library is None:
            return group
    group = bpy.data.node_groups.new(f"Thickness: {spec.name}", "ShaderNodeTree")
    group[SOURCE], group[FORM] = spec.id, FORM_NOW
    for item in spec.inputs:
        _add_input(group, item)
    group.interface.new_socket(name="Thickness", in_out="OUTPUT", socket_type="NodeSocketFloat")
    formula = Formula(group)
    start = formula.node("NodeGroupInput")
    at = {socket.name: socket for socket in start.outputs if socket.name}
    own = _FORMULAS[spec.id](formula, at)
    share = formula.number("MULTIPLY", at[STRENGTH], at[ON])
    result = formula.mix(share, at[spec.below], own)
    group.links.new(result, formula.node("NodeGroupOutput").inputs[0])
    return group


def _add_input(group: bpy.types.ShaderNodeTree, item: Input) -> None:
    is_vector = isinstance(item.value, tuple)
    kind = "Bool" if item.is_switch else "Vector" if is_vector else "Float"
    socket = group.interface.new_socket(
        name=item.name, in_out="INPUT", socket_type=f"NodeSocket{kind}"
    )
    socket.description = item.description
    socket.default_value = item.value
    socket.hide_value = item.name == "Vector"
    if is_vector:
        socket.subtype = "XYZ"
    if kind == "Float":
        socket.min_value, socket.max_value = item.minimum, item.maximum
        if (item.minimum, item.maximum) == (0.0, 1.0):
            socket.subtype = "FACTOR"


def _between(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    held = formula.number("ADD", at["Value"], 0.0, clamp=True)
    return formula.mix(held, at["Minimum"], at["Maximum"])


def _as_it_is(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    return formula.number("MAXIMUM", at["Value"], 0.0)


def _noise(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    node = formula.node("ShaderNodeTexNoise", noise_dimensions="3D")
    for name in ("Vector", "Scale", "Detail"):
        formula.put(at[name], node.inputs[name])
    # Noise keeps to the middle: what lies within two deviations is spread over the whole range.
    part = formula.smooth_step(node.outputs[0], 0.25, 0.75)
    return formula.mix(part, at["Minimum"], at["Maximum"])


def _distance(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """From the start, in units of the reach."""
    away = at["Vector"]
    if "Start" in at:
        away = formula.vector("MULTIPLY", formula.vector("SUBTRACT", away, at["Start"]), at["Axes"])
    return formula.number("DIVIDE", formula.vector("LENGTH", away), at["Reach"])


def _gradient(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    part = formula.number("MINIMUM", _distance(formula, at), 1.0)
    return formula.mix(part, at["Near"], at["Far"])


def _height(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    separate = formula.node("ShaderNodeSeparateXYZ")
    formula.put(at["Vector"], separate.inputs[0])
    above = formula.number("SUBTRACT", separate.outputs["Z"], at["Bottom"])
    whole = formula.number("SUBTRACT", at["Top"], at["Bottom"])
    part = formula.number("DIVIDE", above, whole, clamp=True)
    return formula.mix(part, at["Near"], at["Far"])


def _edge(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """How open the inside of the object is: it is narrow at an edge that stands out."""
    node = formula.node("ShaderNodeAmbientOcclusion", inside=True, only_local=True)
    formula.put(at["Width"], node.inputs["Distance"])
    closed = formula.number("SUBTRACT", 1.0, node.outputs["AO"])
    worn = formula.smooth_step(closed, 0.15, 0.5)  # 0.5: a right angle, at the edge itself
    return formula.mix(worn, at["Faces"], at["Edges"])


def _heat(formula: Formula, at: Inputs) -> bpy.types.NodeSocket:
    """Along a bar that is heated at one end and cooled by the air the excess of temperature falls as
    exp(-x/L) (the equation of a fin); the oxide that grew, d = d_ref exp(B (1/T_ref - 1/T))."""
    fallen = formula.number("EXPONENT", formula.number("MULTIPLY", _distance(formula, at), -1.0))
    celsius = formula.mix(fallen, at["Coldest"], at["Hottest"])
    kelvin = formula.number("ADD", celsius, ZERO_CELSIUS)
    reference = formula.number("ADD", at["At"], ZERO_CELSIUS)
    slower = formula.number(
        "SUBTRACT", formula.number("DIVIDE", 1.0, reference), formula.number("DIVIDE", 1.0, kelvin)
    )
    grown = formula.number("EXPONENT", formula.number("MULTIPLY", at["Growth"], slower))
    own = formula.number("MULTIPLY", at["Grown"], grown)
    # An oxide grows as √t: of one heating after another the squares add up.
    before = formula.number("MULTIPLY", at[BELOW], at[UPON])
    squares = formula.number("MULTIPLY_ADD", before, before, formula.number("MULTIPLY", own, own))
    return formula.number("SQRT", squares)


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
    return formula.number("MULTIPLY", at[BELOW], factor)


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
    drawn = formula.number("MULTIPLY_ADD", deviate, at["Spread"], at[BELOW])
    return formula.number("MAXIMUM", drawn, 0.0)


_FORMULAS: dict[str, Callable[[Formula, Inputs], bpy.types.NodeSocket]] = {
    "map": _between,
    "attribute": _between,
    "attribute_nm": _as_it_is,
    "noise": _noise,
    "gradient": _gradient,
    "height": _height,
    "distance": _gradient,
    "edge": _edge,
    "temperature": _heat,
    "heat_point": _heat,
    "heat_curve": _heat,
    "drop": _drop,
    "drainage": _drainage,
    "swirl": _swirl,
    "spread": _spread,
}
