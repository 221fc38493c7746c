# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where spectra go through nodes, and what meets them on their way."""

from __future__ import annotations

from dataclasses import replace

import bpy

from .. import forms
from ..described import REFLECTANCE
from ..marks import is_ours, trees
from ..report import Remark, Report
from .insert import put_in
from .roles import is_needed

_COLOURS = ("RGBA", "VECTOR")
"""Types of sockets that bands go through."""
_MIX_CHANNELS = ("HUE", "SATURATION", "VALUE", "COLOR")
_VECTOR_BY_CHANNEL = (
    "ADD", "SUBTRACT", "MULTIPLY", "DIVIDE", "MULTIPLY_ADD", "SCALE", "MINIMUM", "MAXIMUM",
)  # fmt: skip
_FACTORS = ("MULTIPLY", "DIVIDE")
"""What they multiply a light by is a reflectance."""


class Spectra:
    """Where spectra go in the nodes of a file, in and out of groups of somebody's own. What meets one gets one
    too, as far as nodes work by channel."""

    def __init__(self) -> None:
        self._known: dict[tuple, bool] = {}
        self._fed: set[tuple[bpy.types.NodeTree, str]] = set()
        """Inputs of groups that a spectrum comes in by, wherever the group is used."""
        while self._feed():
            self._known.clear()

    def _feed(self) -> bool:
        """Whether there are more of them than was known."""
        before = len(self._fed)
        for tree in trees():
            for node in tree.nodes:
                group = own_group(node)
                for socket in node.inputs if group is not None else ():
                    if socket.type == "RGBA" and self.arrive(tree, socket):
                        self._fed.add((group, socket.identifier))
        return len(self._fed) > before

    def arrive(self, tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket) -> bool:
        """Whether one is among what nodes compute for a socket."""
        key = (tree, socket.node.name, socket.identifier)
        if key not in self._known:
            self._known[key] = any(self._come_by(tree, link) for link in socket.links)
        return self._known[key]

    def _come_by(self, tree: bpy.types.NodeTree, link: bpy.types.NodeLink) -> bool:
        node, name = link.from_node, link.from_socket.identifier
        if is_our_node(node):
            return True
        if node.type == "GROUP_INPUT":
            return (tree, name) in self._fed
        group = own_group(node)
        if group is not None:
            inner = _end_of(group, name)
            return inner is not None and self.arrive(group, inner)
        return any(self.arrive(tree, each) for each in node.inputs if each.type in _COLOURS)

    def join(
        self, tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, role: str, report: Report,
        remark: Remark,
    ) -> None:  # fmt: skip
        for link in list(socket.links):
            node, group = link.from_node, own_group(link.from_node)
            if group is not None:
                inner = _end_of(group, link.from_socket.identifier)
                self.join(
                    group, inner, role, report, replace(remark, kind="node group", name=group.name)
                )
            elif not is_our_node(node) and node.type != "GROUP_INPUT":
                self._join_at(tree, node, role, report, remark)

    def _join_at(
        self, tree: bpy.types.NodeTree, node: bpy.types.Node, role: str, report: Report, remark: Remark
    ) -> None:  # fmt: skip
        if not _works_by_channel(node):
            text = f"{node.name}: takes the spectrum that comes in for RGB"
            report.remarks.append(replace(remark, text=text))
            return
        factor = getattr(node, "blend_type", getattr(node, "operation", "")) in _FACTORS
        meets = REFLECTANCE if factor else role
        for each in [each for each in node.inputs if each.enabled and each.type in _COLOURS]:
            if self.arrive(tree, each):
                self.join(tree, each, meets, report, remark)
            elif is_needed(node, each, meets):
                put_in(tree, each, meets, None)
                report.spectra += 1

    def join_group(self, tree: bpy.types.NodeTree, node: bpy.types.Node, report: Report) -> None:
        """A group that takes a spectrum somewhere else takes one here."""
        group = own_group(node)
        for socket in node.inputs if group is not None else ():
            is_fed = (group, socket.identifier) in self._fed and not self.arrive(tree, socket)
            if is_fed and is_needed(node, socket, REFLECTANCE):
                put_in(tree, socket, REFLECTANCE, None)
                report.spectra += 1


def is_our_node(node: bpy.types.Node) -> bool:
    return node.type == "GROUP" and node.node_tree is not None and is_ours(node.node_tree)


def own_group(node: bpy.types.Node) -> bpy.types.NodeTree | None:
    """Of somebody's own, that can be changed."""
    group = node.node_tree if node.type == "GROUP" else None
    is_own = group is not None and not is_ours(group) and group.library is None
    return group if is_own and not forms.is_material(group) else None


def _end_of(group: bpy.types.NodeTree, identifier: str) -> bpy.types.NodeSocket | None:
    """The socket that an output of the group has its value from."""
    for node in group.nodes:
        if node.type == "GROUP_OUTPUT" and node.is_active_output:
            return next((each for each in node.inputs if each.identifier == identifier), None)
    return None


def _works_by_channel(node: bpy.types.Node) -> bool:
    if node.type in ("MIX", "MIX_RGB"):
        return node.blend_type not in _MIX_CHANNELS
    if node.type == "VECT_MATH":
        return node.operation in _VECTOR_BY_CHANNEL
    return node.type in ("REROUTE", "GAMMA", "INVERT", "BRIGHTCONTRAST")
