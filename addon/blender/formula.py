# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes formulas as nodes: each call adds a node and returns the socket of its result."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

Operand = bpy.types.NodeSocket | float | Sequence[float]
_COLUMN, _ROW, _ROWS = 180.0, 170.0, 6


class Formula:
    """Operands are sockets or constants; nodes are laid out in the order in which they are added."""

    def __init__(self, tree: bpy.types.NodeTree) -> None:
        self.tree = tree
        self._count = 0

    def node(self, kind: str, **properties: object) -> bpy.types.Node:
        node = self.tree.nodes.new(kind)
        for name, value in properties.items():
            setattr(node, name, value)
        node.location = (self._count // _ROWS * _COLUMN, -(self._count % _ROWS) * _ROW)
        self._count += 1
        return node

    def put(self, value: Operand, socket: bpy.types.NodeSocket) -> None:
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        else:
            socket.default_value = value

    def number(
        self, operation: str, *operands: Operand, clamp: bool = False
    ) -> bpy.types.NodeSocket:
        node = self.node("ShaderNodeMath", operation=operation, use_clamp=clamp)
        for operand, socket in zip(operands, node.inputs, strict=False):
            self.put(operand, socket)
        return node.outputs[0]

    def vector(self, operation: str, *operands: Operand) -> bpy.types.NodeSocket:
        """A vector, or the number that DOT_PRODUCT, LENGTH and DISTANCE give."""
        node = self.node("ShaderNodeVectorMath", operation=operation)
        inputs = [socket for socket in node.inputs if socket.enabled]
        for operand, socket in zip(operands, inputs, strict=False):
            self.put(operand, socket)
        return next(socket for socket in node.outputs if socket.enabled)

    def scaled(self, vector: Operand, factor: Operand) -> bpy.types.NodeSocket:
        return self.vector("SCALE", vector, factor)

    def mix(self, factor: Operand, a: Operand, b: Operand) -> bpy.types.NodeSocket:
        """a where the factor is 0, b where it is 1, straight in between; beyond both too."""
        return self.number("MULTIPLY_ADD", factor, self.number("SUBTRACT", b, a), a)

    def smooth_step(self, value: Operand, low: Operand, high: Operand) -> bpy.types.NodeSocket:
        node = self.node("ShaderNodeMapRange", interpolation_type="SMOOTHSTEP")
        self.put(value, node.inputs["Value"])
        self.put(low, node.inputs["From Min"])
        self.put(high, node.inputs["From Max"])
        return node.outputs["Result"]

    def noise(
        self, vector: Operand, scale: Operand, detail: float, w: Operand = 0.0
    ) -> bpy.types.NodeSocket:
        """About 0.5, in four dimensions."""
        node = self.node("ShaderNodeTexNoise", noise_dimensions="4D")
        self.put(vector, node.inputs["Vector"])
        self.put(w, node.inputs["W"])
        self.put(scale, node.inputs["Scale"])
        node.inputs["Detail"].default_value = detail
        node.inputs["Roughness"].default_value = 0.5
        return node.outputs[0]
