# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Measured colours that other nodes change on their way to a shader."""

from __future__ import annotations

import bpy

from .. import extension
from ..pictures import empty_scene
from .scenes import matt, patch, rendered, seen_from_above, spectrum_node

BLUE = "colorchecker/blue-sky"
COLOUR = (0.7, 0.3, 0.1, 1.0)


def patches(*, file: str, size: int, samples: int) -> dict:
    """Matt ones under an even sky: of a reflectance, of it times white, of it times a colour, of that colour
    alone, of the reflectance times a picture of the colour, likewise where it goes into a group and where it
    comes out of one, of a colour that goes into that group, and of what no node can do by channel."""
    scene = empty_scene()
    picture = bpy.data.images.new("plain", 1, 1, float_buffer=True, is_data=True)
    picture.pixels.foreach_set(COLOUR)
    picture.pack()
    plain = matt("")
    _colour_of(plain).default_value = COLOUR
    materials = [
        matt(BLUE), _times((1.0, 1.0, 1.0, 1.0)), _times(COLOUR), plain, _times(picture),
        *_groups(), _turned(),
    ]  # fmt: skip
    for column, material in enumerate(materials):
        patch(scene, column, 0, material)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    seen_from_above(scene, len(materials), 1, size)
    convert = extension.module("spectral.convert")
    report, again = convert.make_spectral(), convert.make_spectral()
    said = rendered(scene, file, samples, 8)
    return {
        **said,
        "spectra": [report.spectra, again.spectra],
        "removed": convert.make_rgb(),
        "remarks": [[remark.where, remark.text] for remark in report.remarks],
    }


def _colour_of(material: bpy.types.Material) -> bpy.types.NodeSocket:
    nodes = material.node_tree.nodes
    return next(node for node in nodes if node.type == "BSDF_DIFFUSE").inputs["Color"]


def _product(
    tree: bpy.types.NodeTree, source: bpy.types.NodeSocket, second: tuple | bpy.types.Image
) -> bpy.types.NodeSocket:
    node = tree.nodes.new("ShaderNodeMix")
    node.data_type, node.blend_type = "RGBA", "MULTIPLY"
    factor, a, b = (socket for socket in node.inputs if socket.enabled)
    factor.default_value = 1.0
    tree.links.new(source, a)
    if isinstance(second, tuple):
        b.default_value = second
    else:
        texture = tree.nodes.new("ShaderNodeTexImage")
        texture.image = second
        tree.links.new(texture.outputs["Color"], b)
    return next(socket for socket in node.outputs if socket.enabled)


def _times(second: tuple | bpy.types.Image) -> bpy.types.Material:
    material = matt(BLUE)
    socket, tree = _colour_of(material), material.node_tree
    tree.links.new(_product(tree, socket.links[0].from_socket, second), socket)
    return material


def _turned() -> bpy.types.Material:
    material = matt(BLUE)
    socket, tree = _colour_of(material), material.node_tree
    hue = tree.nodes.new("ShaderNodeHueSaturation")
    tree.links.new(socket.links[0].from_socket, hue.inputs["Color"])
    tree.links.new(hue.outputs["Color"], socket)
    return material


def _groups() -> tuple[bpy.types.Material, bpy.types.Material, bpy.types.Material]:
    """One whose reflectance goes into a group, one that has it from a group, and one of a colour that goes
    into the first group."""
    paint, stock = (bpy.data.node_groups.new(name, "ShaderNodeTree") for name in ("Paint", "Stock"))
    paint.interface.new_socket("Tint", in_out="INPUT", socket_type="NodeSocketColor")
    paint.interface.new_socket("Surface", in_out="OUTPUT", socket_type="NodeSocketShader")
    stock.interface.new_socket("Tint", in_out="OUTPUT", socket_type="NodeSocketColor")
    start, shader, end = (
        paint.nodes.new(kind)
        for kind in ("NodeGroupInput", "ShaderNodeBsdfDiffuse", "NodeGroupOutput")
    )
    paint.links.new(_product(paint, start.outputs["Tint"], COLOUR), shader.inputs["Color"])
    paint.links.new(shader.outputs[0], end.inputs["Surface"])
    end = stock.nodes.new("NodeGroupOutput")
    stock.links.new(_product(stock, spectrum_node(stock, BLUE), COLOUR), end.inputs["Tint"])

    into, out_of, other = matt(BLUE), matt(""), matt("")
    for material in (into, other):
        tree = material.node_tree
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = paint
        node.inputs["Tint"].default_value = (0.9, 0.9, 0.3, 1.0)
        out = next(each for each in tree.nodes if each.type == "OUTPUT_MATERIAL")
        tree.links.new(node.outputs["Surface"], out.inputs["Surface"])
        if material == into:
            tree.links.new(_colour_of(into).links[0].from_socket, node.inputs["Tint"])
    node = out_of.node_tree.nodes.new("ShaderNodeGroup")
    node.node_tree = stock
    out_of.node_tree.links.new(node.outputs["Tint"], _colour_of(out_of))
    return into, out_of, other
