# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyframes and drivers of a node's inputs, which Blender knows by number, when the numbers change."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

import bpy


def move_inputs(tree: bpy.types.NodeTree, node: bpy.types.Node, places: Mapping[int, int]) -> None:
    """Lets the curves of input `old` go to input `places[old]`; those of inputs that are gone stay,
    without effect, in case the input comes back."""
    start = f'nodes["{bpy.utils.escape_identifier(node.name)}"].inputs['
    for curve in _curves(tree.animation_data):
        if not curve.data_path.startswith(start):
            continue
        number, rest = re.match(r"(\d+)(.*)", curve.data_path[len(start) :]).groups()
        if int(number) in places:
            curve.data_path = f"{start}{places[int(number)]}{rest}"


def _curves(animation: bpy.types.AnimData | None) -> Iterator[bpy.types.FCurve]:
    if animation is None:
        return
    yield from animation.drivers
    action = animation.action
    if action is None:
        return
    if not hasattr(action, "layers"):  # before Blender 4.4
        yield from action.fcurves
        return
    for layer in action.layers:
        for strip in layer.strips:
            for bag in strip.channelbags:
                if bag.slot == animation.action_slot:
                    yield from bag.fcurves


def is_animated(socket: bpy.types.NodeSocket) -> bool:
    """Whether keyframes or a driver give its value."""
    return _is_on(socket.id_data, socket.path_from_id("default_value"))


def is_property_animated(owner: bpy.types.ID, name: str) -> bool:
    return _is_on(owner, name)


def _is_on(owner: bpy.types.ID, path: str) -> bool:
    return any(curve.data_path == path for curve in _curves(owner.animation_data))


def is_shared(tree: bpy.types.NodeTree) -> bool:
    """Whether other blocks follow the same keyframes, which cannot be moved then."""
    animation = tree.animation_data
    return animation is not None and animation.action is not None and animation.action.users > 1


def move(source: bpy.types.NodeSocket, target: bpy.types.NodeSocket) -> None:
    """Lets what gives the value of one input give that of another one of the same tree."""
    before, after = (socket.path_from_id("default_value") for socket in (source, target))
    for curve in _curves(source.id_data.animation_data):
        if curve.data_path == before:
            curve.data_path = after
