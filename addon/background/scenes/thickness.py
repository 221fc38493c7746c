# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Thickness that changes over a surface, around the value that the material has."""

from __future__ import annotations

import bpy

from ...materials.material import input_socket


def vary(
    material: bpy.types.Material,
    *,
    base: float,
    height: float,
    swirl: float,
    scale: float,
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0),
) -> None:
    """thickness = value * (base + height * z + swirl * noise), z from 0 on top to 1 at the bottom.

    Does nothing for a material without a thickness.
    """
    socket = input_socket(material, "thickness_nm")
    if socket is None:
        return
    tree = material.node_tree
    factor = _add(
        tree, _scaled(tree, _depth(tree), height, base), _swirl(tree, swirl, scale, stretch)
    )
    product = tree.nodes.new("ShaderNodeMath")
    product.operation = "MULTIPLY"
    product.inputs[1].default_value = socket.default_value
    tree.links.new(factor, product.inputs[0])
    tree.links.new(product.outputs[0], socket)


def _depth(tree: bpy.types.NodeTree) -> bpy.types.NodeSocket:
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    separate = tree.nodes.new("ShaderNodeSeparateXYZ")
    tree.links.new(coordinates.outputs["Generated"], separate.inputs[0])
    return _scaled(tree, separate.outputs["Z"], -1.0, 1.0)


def _swirl(tree: bpy.types.NodeTree, amount: float, scale: float, stretch) -> bpy.types.NodeSocket:
    """Noise of mean zero, warped by itself as flow in a film warps it."""
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = stretch
    noise = tree.nodes.new("ShaderNodeTexNoise")
    noise.inputs["Scale"].default_value = scale
    noise.inputs["Detail"].default_value = 3.5
    noise.inputs["Roughness"].default_value = 0.45
    noise.inputs["Distortion"].default_value = 2.2
    tree.links.new(coordinates.outputs["Object"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], noise.inputs["Vector"])
    return _scaled(tree, noise.outputs[0], 2.0 * amount, -amount)


def _scaled(tree, value, factor: float, offset: float) -> bpy.types.NodeSocket:
    node = tree.nodes.new("ShaderNodeMath")
    node.operation = "MULTIPLY_ADD"
    node.inputs[1].default_value = factor
    node.inputs[2].default_value = offset
    tree.links.new(value, node.inputs[0])
    return node.outputs[0]


def _add(tree, a, b) -> bpy.types.NodeSocket:
    node = tree.nodes.new("ShaderNodeMath")
    tree.links.new(a, node.inputs[0])
    tree.links.new(b, node.inputs[1])
    return node.outputs[0]
