# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders the scene at hand into a file."""

from __future__ import annotations

from pathlib import Path

import bpy

from . import extension


def empty_scene(space: str = "") -> bpy.types.Scene:
    """For Cycles, in a file of that working space, if not what it has."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.context.scene.render.engine = "CYCLES"
    extension.set_space(space)
    return bpy.context.scene


def render_picture(
    scene: bpy.types.Scene, width: int, height: int, samples: int, file: str
) -> None:
    """Every pixel gets all its samples, and nothing is smoothed."""
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.cycles.samples = samples
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    bpy.ops.render.render()
    extension.module("blender.output").Writer(scene).save(Path(file))


def of_one_shader(name: str, kind: str) -> tuple[bpy.types.Material, bpy.types.Node]:
    """A material and its only shader."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader, out = tree.nodes.new(kind), tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], out.inputs["Surface"])
    return material, shader


def wall(*, file: str, of_metal: bool = False) -> None:
    """A file with a matt green wall that fills the picture, or one of polished metal, under an even sky."""
    scene = empty_scene()
    mesh = bpy.data.meshes.new("wall")
    mesh.from_pydata([(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)], [], [(0, 1, 2, 3)])
    if of_metal:
        material, shader = of_one_shader("Wall", "ShaderNodeBsdfMetallic")
        shader.fresnel_type = "PHYSICAL_CONDUCTOR"
        shader.inputs["Roughness"].default_value = 0.0
    else:
        material, shader = of_one_shader("Wall", "ShaderNodeBsdfDiffuse")
        shader.inputs["Color"].default_value = (0.2, 0.6, 0.2, 1.0)
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new("wall", mesh))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.location = "ORTHO", (0.0, 0.0, 3.0)
    camera.data.ortho_scale = 1.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    bpy.ops.wm.save_as_mainfile(filepath=file)
