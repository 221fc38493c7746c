# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nodes that make a spectrum, in front of a socket: in and out again."""

from __future__ import annotations

import bpy

from ...blender import animation
from ...blender.space import of_file
from ...core.space import REC709, conversion, converted
from ..attributes import CENTRE_NM, HALF_WIDTH_NM
from ..described import EMISSION, REFLECTANCE, Described
from ..groups import (
    LIGHT_OF_COLOUR,
    LIGHT_OF_MIXTURE,
    REFLECTANCE_OF_COLOUR,
    REFLECTANCE_OF_MIXTURE,
    VALUES_OF_CHANNELS,
    spectrum_group,
    upsampling_group,
)
from ..marks import BEFORE, LUMINANCE, MADE
from .roles import CHANNELS

_OF_COLOUR = {REFLECTANCE: REFLECTANCE_OF_COLOUR, EMISSION: LIGHT_OF_COLOUR}
_OF_MIXTURE = {
    REFLECTANCE: REFLECTANCE_OF_MIXTURE,
    EMISSION: LIGHT_OF_MIXTURE,
    CHANNELS: VALUES_OF_CHANNELS,
}
_COOLEST_K = 800.0
"""Below it Blender's black body has the colour of that."""


def is_constant(socket: bpy.types.NodeSocket) -> bool:
    return not socket.is_linked and not animation.is_animated(socket)


def put_in(
    tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, role: str, colour: tuple | None
) -> bpy.types.ShaderNodeGroup:
    """A group between the socket and what it had; `colour` in place of the socket's own."""
    node = new_node(tree, socket)
    kelvin = _temperature(socket) if role == EMISSION else None
    if kelvin is not None:
        glow = Described.named(f"blackbody:{kelvin:g}")
        node.node_tree = spectrum_group(glow, keeps_rgb=True)
        node.inputs[LUMINANCE].default_value = 1.0  # as Blender has it
        tree.links.new(socket.links[0].from_socket, node.inputs[BEFORE])
    elif socket.is_linked:
        node.node_tree = upsampling_group(_OF_MIXTURE[role])
        tree.links.new(socket.links[0].from_socket, node.inputs["Color"])
    elif animation.is_animated(socket):
        node.node_tree = upsampling_group(_OF_MIXTURE[role])
        node.inputs["Color"].default_value = socket.default_value
        animation.move(socket, node.inputs["Color"])
    else:
        given = tuple(socket.default_value) if colour is None else colour
        if role == CHANNELS:
            node.node_tree = upsampling_group(VALUES_OF_CHANNELS)
        else:
            given = (*given[:3], 1.0)
            _fill(node, role, given)
        node.inputs["Color"].default_value = given
    tree.links.new(node.outputs[0], socket)
    return node


def _temperature(socket: bpy.types.NodeSocket) -> float | None:
    """Of Blender's own black body, where nothing changes it."""
    source = socket.links[0].from_node if socket.is_linked else None
    if source is None or source.type != "BLACKBODY" or not is_constant(source.inputs[0]):
        return None
    kelvin = source.inputs[0].default_value
    return kelvin if kelvin >= _COOLEST_K else None


def new_node(tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket) -> bpy.types.ShaderNodeGroup:
    node = tree.nodes.new("ShaderNodeGroup")
    node[MADE] = True
    node.location = (socket.node.location.x - 180.0, socket.node.location.y - 40.0)
    node.hide = True
    return node


def _fill(node: bpy.types.ShaderNodeGroup, role: str, colour: tuple) -> None:
    """With the coefficients of a colour; as a mixture, where no smooth spectrum has it."""
    import nacre

    rgb = converted(conversion(of_file(), REC709), colour[:3])
    largest = max(rgb)
    # A light is D65 through a filter of its colour at half strength, so that even a bright
    # saturated one gets a smooth spectrum.
    scale = 1.0 if role == REFLECTANCE else 2.0 * largest
    try:
        found = nacre.rgb_to_spectrum([channel / scale for channel in rgb]).coefficients
    except nacre.NacreError:
        node.node_tree = upsampling_group(_OF_MIXTURE[role])
        return
    node.node_tree = upsampling_group(_OF_COLOUR[role])
    node.inputs["Coefficients"].default_value = polynomial(found)
    if role == EMISSION:
        node.inputs["Scale"].default_value = scale


def polynomial(by_nanometre) -> tuple[float, float, float]:
    """Of attributes.polynomial_variable(), from one of λ/nm; both highest power first."""
    a, b, c = (float(value) for value in by_nanometre)
    return (
        HALF_WIDTH_NM**2 * a,
        HALF_WIDTH_NM * (2.0 * CENTRE_NM * a + b),
        (CENTRE_NM * a + b) * CENTRE_NM + c,
    )


def take_out(tree: bpy.types.NodeTree, node: bpy.types.Node) -> None:
    source = node.inputs.get(BEFORE) or node.inputs["Color"]
    if source.is_linked:
        for link in list(node.outputs[0].links):
            tree.links.new(source.links[0].from_socket, link.to_socket)
    else:
        for link in node.outputs[0].links:
            animation.move(source, link.to_socket)
    tree.nodes.remove(node)
