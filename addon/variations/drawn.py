# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variations of a material: what of it can vary, what was drawn, and a variation put into its nodes.

What was drawn is of this session and in no file: a variation becomes part of one when it is taken.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import bpy

from ..blender.animation import is_animated
from ..core.manifest import THICKNESSES
from ..films import colours as film_colours
from ..materials import group as groups
from ..materials.material import group_node, input_socket, interface_item
from ..materials.thickness import thickness_range, thickness_socket
from ..thickness.nodes import sources_of, spec_of
from ..thickness.sources import BELOW, STRENGTH
from .drawing import Knob, State, colour_ladder, like, randomised, state_of
from .knobs import own_knob, source_knob, thickness_knob

COUNT = 7
"""Variations that are offered at a time, beside the material as it was."""
_ROWS = 97  # of the table that steps of colour are found in

RANDOM, LIKE = "RANDOM", "LIKE"


@dataclass
class Drawn:
    """What is offered for a material; the first is as it was."""

    states: list[State]
    seed: int
    kind: str


_drawn: dict[int, Drawn] = {}  # by the material's session_uid


def knobs(material: bpy.types.Material, *, with_colours: bool = True) -> list[Knob]:
    """What neither links nor keyframes give. Steps of colour, which drawing needs, take a moment when
    a film is first seen."""
    socket = thickness_socket(material)
    found = []
    names = groups.socket_identifiers(group_node(material).node_tree)
    for name in names:
        own = input_socket(material, name)
        if name in THICKNESSES or own.type != "VALUE" or not _is_free(own):
            continue
        found.append(own_knob(name, own.default_value, _limits(own), is_alone=socket is None))
    if socket is not None:
        span = thickness_range(socket)
        ladder = _ladder(material, span) if with_colours else ()
        found += _thickness_knobs(material, socket, span, ladder)
    return [knob for knob in found if knob is not None]


def _thickness_knobs(
    material: bpy.types.Material,
    socket: bpy.types.NodeSocket,
    span: tuple[float, float],
    ladder: tuple[float, ...],
) -> list[Knob | None]:
    if _is_free(socket):
        name = next(name for name in THICKNESSES if input_socket(material, name) == socket)
        return [thickness_knob(name, socket.default_value, span, ladder)]
    found = []
    sources = sources_of(material)
    for node in sources:
        spec = spec_of(node)
        values = {item.name: item.default_value for item in node.inputs if item.type == "VALUE"}
        for item in spec.inputs:
            if item.name not in values or not _is_free(node.inputs[item.name]):
                continue
            is_seen = node == sources[-1] and spec.changes_what_is_below
            if item.name in (STRENGTH, "Value") or (item.name == BELOW and not is_seen):
                continue
            found.append(source_knob(node.name, spec, item, values, span, ladder))
    return found


def take(material: bpy.types.Material, state: Mapping[str, float]) -> None:
    for name, value in state.items():
        socket = _socket(material, name)
        if socket is not None and _is_free(socket):
            socket.default_value = value


def draw(material: bpy.types.Material, kind: str, seed: int) -> Drawn:
    """Draws anew, around the material as it is now."""
    turned = knobs(material)
    make = like if kind == LIKE else randomised
    states = [make(turned, seed * COUNT + number) for number in range(1, COUNT + 1)]
    made = Drawn([state_of(turned), *states], seed, kind)
    _drawn[material.session_uid] = made
    return made


def drawn(material: bpy.types.Material) -> Drawn | None:
    """What was drawn last, unless the material has other inputs by now."""
    found = _drawn.get(material.session_uid)
    if found is None or not found.states[0]:
        return None
    return found if all(_socket(material, name) for name in found.states[0]) else None


def is_now(material: bpy.types.Material, state: State) -> bool:
    return all(
        abs(_socket(material, name).default_value - value) <= 1e-5 * max(1.0, abs(value))
        for name, value in state.items()
    )


def forget() -> None:
    _drawn.clear()


def _socket(material: bpy.types.Material, name: str) -> bpy.types.NodeSocket | None:
    node_name, _, input_name = name.rpartition("/")
    if not node_name:
        return input_socket(material, name)
    node = material.node_tree.nodes.get(node_name)
    return node.inputs.get(input_name) if node is not None else None


def _is_free(socket: bpy.types.NodeSocket) -> bool:
    return not socket.is_linked and not is_animated(socket)


def _limits(socket: bpy.types.NodeSocket) -> tuple[float, float]:
    item = interface_item(socket)
    return item.min_value, item.max_value


def _ladder(material: bpy.types.Material, span: tuple[float, float]) -> tuple[float, ...]:
    """Nothing where colours cannot be computed: thicknesses are even then."""
    values, colours = film_colours.along(material, *span, _ROWS)
    return colour_ladder(values, colours) if colours else ()
