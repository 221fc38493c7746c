# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What somebody says that a lamp, the world or a surface is, in place of a spectrum of its colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import bpy

from ..blender.space import of_file
from . import convert
from .described import CONSTANT, EMISSION, REFLECTANCE, Described, SpectrumError
from .groups import rgb_of, spectrum_group
from .marks import BEFORE, LUMINANCE, MADE, SPECTRUM, has_own_colour, is_ours, name_of
from .report import Report
from .sockets.insert import new_node, take_out
from .sockets.roles import roles

_MAIN = ("Base Color", "Color")
"""Of a surface's colours the one that is there always, by the name of its socket."""


def to_lamp(light: bpy.types.Light, spectrum: Described | None) -> None:
    """As bright as the lamp was; None: a spectrum of its colour again. Raises SpectrumError."""
    sockets = _emitting(light.node_tree, "EMISSION")
    if spectrum is None:
        _take_out(light.node_tree, sockets)
        if MADE in light:
            convert.own_again(light)
        convert.convert_lamp(light, Report())
        return
    where = f"the lamp {light.name}"
    _check(spectrum, EMISSION, where)
    convert.convert_lamp(light, Report())
    own = light.color if has_own_colour(light) else None
    luminances = _shine(light.node_tree, spectrum, "EMISSION", where, own)
    if own is not None:
        light.color = [max(0.0, luminances[0] * channel) for channel in rgb_of(spectrum)]


def to_world(world: bpy.types.World, spectrum: Described | None) -> None:
    """Likewise, in place of the world's colour or of its picture. Raises SpectrumError."""
    tree = world.node_tree if world.use_nodes else None
    where = f"the world {world.name}"
    if spectrum is None:
        _take_out(tree, _emitting(tree, "BACKGROUND"))
        if tree is not None:
            convert.renew(tree)
        return
    _check(spectrum, EMISSION, where)
    _shine(tree, spectrum, "BACKGROUND", where)


def _emitting(tree: bpy.types.NodeTree | None, kind: str) -> list[bpy.types.NodeSocket]:
    nodes = tree.nodes if tree is not None else ()
    return [node.inputs["Color"] for node in nodes if node.type == kind]


def _check(spectrum: Described, kind: str, where: str) -> None:
    if spectrum.kind != kind:
        words = {EMISSION: "a light", REFLECTANCE: "a reflectance", CONSTANT: "n or k of a metal"}
        raise SpectrumError(
            f"{where}: {spectrum.name} is {words[spectrum.kind]}, not {words[kind]}"
        )


def _shine(
    tree: bpy.types.NodeTree | None,
    spectrum: Described,
    kind: str,
    where: str,
    own: Sequence[float] | None = None,
) -> list[float]:
    """Returns how bright each node that emits is. own: a lamp's colour, which is on top of theirs."""
    sockets = _emitting(tree, kind)
    if not sockets:
        raise SpectrumError(f"{where} has no node that emits light")
    luminances = []
    for socket in sockets:
        luminances.append(_luminance(socket, own))
        node = _put_in(tree, socket, spectrum, keeps_rgb=own is not None)
        node.inputs[LUMINANCE].default_value = luminances[-1]
    return luminances


def _put_in(
    tree: bpy.types.NodeTree,
    socket: bpy.types.NodeSocket,
    spectrum: Described,
    *,
    keeps_rgb: bool = False,
) -> bpy.types.ShaderNodeGroup:
    _take_out(tree, [socket])
    node = new_node(tree, socket)
    node.node_tree = spectrum_group(spectrum, keeps_rgb=keeps_rgb)
    node.inputs[BEFORE].default_value = (1.0, 1.0, 1.0, 1.0)
    if socket.is_linked:
        tree.links.new(socket.links[0].from_socket, node.inputs[BEFORE])
    tree.links.new(node.outputs[0], socket)
    return node


def _take_out(tree: bpy.types.NodeTree | None, sockets: list[bpy.types.NodeSocket]) -> None:
    for socket in sockets:
        for source in [link.from_node for link in socket.links]:
            if MADE in source:
                take_out(tree, source)


def _luminance(socket: bpy.types.NodeSocket, own: Sequence[float] | None) -> float:
    """Of the colour that a socket has; of one that is computed, as of white."""
    source = socket.links[0].from_node if socket.is_linked else None
    if source is None:
        colour = socket.default_value
    elif MADE in source and LUMINANCE in source.inputs:
        return source.inputs[LUMINANCE].default_value
    elif MADE in source and not source.inputs["Color"].is_linked:
        colour = source.inputs["Color"].default_value
    else:
        return 1.0
    if own is not None:
        colour = [channel * on_top for channel, on_top in zip(colour, own, strict=False)]
    return sum(row * channel for row, channel in zip(of_file()[1], colour, strict=False))


@dataclass(frozen=True)
class SurfaceColour:
    """A socket of a material's nodes that takes a reflectance."""

    material: bpy.types.Material
    node: bpy.types.Node
    socket: bpy.types.NodeSocket

    @property
    def label(self) -> str:
        """The same for no other of the material."""
        return f"{self.node.name}: {self.socket.name}"

    @property
    def rgb(self) -> tuple[float, ...]:
        """What is set; of what nodes compute, grey."""
        for link in self.socket.links:
            source = link.from_node.inputs.get(BEFORE) or link.from_node.inputs.get("Color")
            if MADE in link.from_node and not source.is_linked and source.name != BEFORE:
                return tuple(source.default_value)
            if MADE not in link.from_node or source.is_linked:
                return (0.5, 0.5, 0.5, 1.0)
        return tuple(self.socket.default_value)

    @property
    def spectrum(self) -> str:
        """The name of that which it was given, or nothing."""
        group = _ours(self.socket)
        if group is None or SPECTRUM not in group:
            return ""
        return name_of(group)

    def give(self, spectrum: Described | None) -> None:
        """None: a spectrum of the colour again. Raises SpectrumError."""
        tree = self.material.node_tree
        if spectrum is None:
            _take_out(tree, [self.socket])
            convert.renew(tree)
            return
        _check(spectrum, REFLECTANCE, f"the material {self.material.name}")
        _put_in(tree, self.socket, spectrum)


@dataclass(frozen=True)
class SurfaceMetal:
    """A node that takes the index of a metal: *Metallic BSDF* as a *Physical Conductor*."""

    material: bpy.types.Material
    node: bpy.types.Node

    @property
    def label(self) -> str:
        """The same for no other of the material."""
        return f"{self.node.name}: n and k"

    @property
    def metal(self) -> str:
        """The key of that which it was given, or nothing."""
        group = _ours(self.node.inputs["IOR"])
        if group is None or SPECTRUM not in group:
            return ""
        return name_of(group).removesuffix(", n")

    def give(self, key: str | None) -> None:
        """A medium of the library; None: n and k as they are set. Raises SpectrumError."""
        tree = self.material.node_tree
        sockets = [self.node.inputs[name] for name in ("IOR", "Extinction")]
        if key is None:
            _take_out(tree, sockets)
            convert.renew(tree)
            return
        for socket, constant in zip(sockets, Described.of_metal(key), strict=True):
            _put_in(tree, socket, constant)


def metals_of(material: bpy.types.Material) -> list[SurfaceMetal]:
    return [
        SurfaceMetal(material, node)
        for node in (material.node_tree.nodes if material.node_tree is not None else ())
        if node.type == "BSDF_METALLIC" and node.fresnel_type == "PHYSICAL_CONDUCTOR"
    ]


def _ours(socket: bpy.types.NodeSocket) -> bpy.types.NodeTree | None:
    """The group that makes a spectrum for it."""
    for link in socket.links:
        group = link.from_node.node_tree if link.from_node.type == "GROUP" else None
        if group is not None and is_ours(group):
            return group
    return None


def colours_of(material: bpy.types.Material) -> list[SurfaceColour]:
    """Main ones first; tints only where they tint."""
    found = []
    for node in material.node_tree.nodes if material.node_tree is not None else ():
        for name, role in roles(node).items():
            socket = node.inputs.get(name)
            if socket is None or role != REFLECTANCE or socket.hide or not socket.enabled:
                continue
            if name in _MAIN or _ours(socket) is not None:
                found.append(SurfaceColour(material, node, socket))
    return sorted(found, key=lambda colour: colour.socket.name not in _MAIN)
