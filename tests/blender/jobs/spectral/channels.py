# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What shaders have by channel: colours that stay RGB, indices of metals, how far light goes under skin."""

from __future__ import annotations

from pathlib import Path

import bpy

from .. import extension
from ..pictures import empty_scene, of_one_shader, render_picture
from .scenes import patch, rendered, seen_from_above

COLOURS = ((0.8, 0.1, 0.1), (0.1, 0.6, 0.1), (0.1, 0.1, 0.7), (0.7, 0.6, 0.1), (0.5, 0.2, 0.6))
METALS = {
    "gold": ((0.183, 0.421, 1.373), (3.424, 2.346, 1.770)),
    "copper": ((0.271, 0.677, 1.316), (3.610, 2.625, 2.292)),
}


def patches(*, folder: str, size: int, samples: int, metals: list[str], light: str) -> dict:
    """Under an even sky: matt ones whose colours stay RGB, metals by n and k of three channels, skin, and
    metals of the library, polished."""
    scene = empty_scene()
    convert, give = extension.module("spectral.convert"), extension.module("spectral.give")
    matt = [_matt(colour) for colour in COLOURS]
    by_channel = [_conductor(*indices, roughness=0.3) for indices in METALS.values()]
    skin, node = of_one_shader("Skin", "ShaderNodeSubsurfaceScattering")
    node.inputs["Color"].default_value = (0.8, 0.8, 0.8, 1.0)
    node.inputs["Scale"].default_value = 1.0
    polished = [_conductor((1.0, 1.0, 1.0), (1.0, 1.0, 1.0), roughness=0.0) for _ in metals]
    materials = [*matt, *by_channel, skin, *polished]
    for column, material in enumerate(materials):
        if material == skin:
            _block(column, material)
        else:
            patch(scene, column, 0, material)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    seen_from_above(scene, len(materials), 1, size)
    files = {name: str(Path(folder, f"{name}.exr")) for name in ("before", "bands", "after")}
    picture = (size * len(materials), size, samples)
    render_picture(scene, *picture, files["before"])
    report = convert.make_spectral()
    _stay_rgb(matt)
    for material, key in zip(polished, metals, strict=True):
        (metal,) = give.metals_of(material)
        metal.give(key)
    given = [give.metals_of(material)[0].metal for material in polished]
    give.to_world(scene.world, extension.module("spectral.described").Described.named(light))
    said = rendered(scene, files["bands"], samples, 16)
    convert.make_rgb()
    render_picture(scene, *picture, files["after"])
    remarks = [[remark.where, remark.text] for remark in report.remarks]
    return {"left": said["left"], "remarks": remarks, "given": given}


def _block(column: int, material: bpy.types.Material) -> None:
    """In place of a patch, for what light goes into."""
    bpy.ops.mesh.primitive_cube_add(size=0.9, location=(column + 0.5, -0.5, -0.5))
    bpy.context.object.data.materials.append(material)


def _matt(colour: tuple) -> bpy.types.Material:
    material, node = of_one_shader("Matt", "ShaderNodeBsdfDiffuse")
    node.inputs["Color"].default_value = (*colour, 1.0)
    return material


def _conductor(n: tuple, k: tuple, *, roughness: float) -> bpy.types.Material:
    material, node = of_one_shader("Metal", "ShaderNodeBsdfMetallic")
    node.fresnel_type = "PHYSICAL_CONDUCTOR"
    for name, value in (("IOR", n), ("Extinction", k), ("Roughness", roughness)):
        node.inputs[name].default_value = value
    return material


def _stay_rgb(materials: list[bpy.types.Material]) -> None:
    marks, insert = extension.module("spectral.marks"), extension.module("spectral.sockets.insert")
    for material in materials:
        for node in [node for node in material.node_tree.nodes if marks.MADE in node]:
            insert.take_out(material.node_tree, node)
