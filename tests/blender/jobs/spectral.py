# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectral scenes inside Blender."""

from __future__ import annotations

from pathlib import Path

import bpy

from . import extension
from .pictures import empty_scene, render_picture


def chart(
    *, reflectances: list[str], lights: list[str], file: str, size: int, samples: int, passes: int
) -> dict:
    """Patches in a row under each light in turn, seen from above; one row of the picture a light.

    A white world of one light cannot be had together with others, so each row is an emission: the
    light times the reflectance, as a furnace would show it.
    """
    groups = extension.module("spectral.groups")
    described = extension.module("spectral.described").Described
    scene = empty_scene()
    columns, rows = len(reflectances), len(lights)
    for row, light in enumerate(lights):
        for column, reflectance in enumerate(reflectances):
            material = bpy.data.materials.new(f"{light} {reflectance}")
            material.use_nodes = True
            tree = material.node_tree
            tree.nodes.clear()
            both = tree.nodes.new("ShaderNodeVectorMath")
            both.operation = "MULTIPLY"
            for socket, name in zip(both.inputs, (light, reflectance), strict=False):
                node = tree.nodes.new("ShaderNodeGroup")
                node.node_tree = groups.spectrum_group(described.named(name))
                tree.links.new(node.outputs[0], socket)
            emission = tree.nodes.new("ShaderNodeEmission")
            out = tree.nodes.new("ShaderNodeOutputMaterial")
            tree.links.new(both.outputs[0], emission.inputs["Color"])
            tree.links.new(emission.outputs[0], out.inputs["Surface"])
            mesh = bpy.data.meshes.new("patch")
            x, y = float(column), -float(row)
            corners = [(x, y, 0), (x + 1, y, 0), (x + 1, y - 1, 0), (x, y - 1, 0)]
            mesh.from_pydata(corners, [], [(3, 2, 1, 0)])
            mesh.materials.append(material)
            scene.collection.objects.link(bpy.data.objects.new("patch", mesh))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = float(max(columns, rows))
    camera.location = (columns / 2, -rows / 2, 5.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = size * columns, size * rows
    scene.render.filter_size = 0.01
    return rendered(scene, file, samples, passes)


def rendered(scene: bpy.types.Scene, file: str, samples: int, passes: int) -> dict:
    plan = extension.module("spectral.plan")
    groups = extension.module("spectral.groups")
    made = plan.make(groups.found_spectra(), passes or None)
    extension.module("spectral.rendering").render(scene, made, samples, Path(file))
    return {"passes": made.passes, "left": [key for key in scene.keys() if "nacre" in key]}  # noqa: SIM118


def _material(name: str, colour: tuple) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    principled = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    principled.inputs["Base Color"].default_value = (*colour, 1.0)
    principled.inputs["Roughness"].default_value = 0.8
    return material


def _box() -> bpy.types.Scene:
    """A room with coloured walls: constants, a picture, colours that nodes compute, a tinted lamp, a
    coloured world, a glowing ball."""
    scene = empty_scene()
    white, red = _material("white", (0.7, 0.7, 0.7)), _material("red", (0.6, 0.06, 0.03))
    painted, mixed = _material("painted", (0.8, 0.8, 0.8)), _material("mixed", (0.8, 0.8, 0.8))
    glowing = _material("glowing", (0.0, 0.0, 0.0))

    tree = painted.node_tree
    picture = bpy.data.images.new("paint", 8, 8, float_buffer=True)
    pixels = [(x / 8, y / 8, 0.4, 1.0) for y in range(8) for x in range(8)]
    picture.pixels.foreach_set([channel for pixel in pixels for channel in pixel])
    picture.pack()
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.image = picture
    tree.links.new(texture.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])

    tree = mixed.node_tree
    checker = tree.nodes.new("ShaderNodeTexChecker")
    checker.inputs["Color1"].default_value = (0.1, 0.5, 0.15, 1.0)
    checker.inputs["Color2"].default_value = (0.05, 0.1, 0.6, 1.0)
    tree.links.new(checker.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])

    shining = glowing.node_tree.nodes["Principled BSDF"]
    shining.inputs["Emission Color"].default_value = (1.0, 0.45, 0.1, 1.0)
    shining.inputs["Emission Strength"].default_value = 2.0

    def wall(corners, material):
        mesh = bpy.data.meshes.new("wall")
        mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
        mesh.uv_layers.new()
        for loop, uv in zip(mesh.uv_layers[0].data, ((0, 0), (1, 0), (1, 1), (0, 1)), strict=True):
            loop.uv = uv
        mesh.materials.append(material)
        scene.collection.objects.link(bpy.data.objects.new("wall", mesh))

    wall([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], mixed)
    wall([(-1, 1, 0), (1, 1, 0), (1, 1, 2), (-1, 1, 2)], painted)
    wall([(-1, -1, 0), (-1, 1, 0), (-1, 1, 2), (-1, -1, 2)], red)
    wall([(1, -1, 0), (1, 1, 0), (1, 1, 2), (1, -1, 2)], white)
    bpy.ops.mesh.primitive_uv_sphere_add(radius=0.3, location=(0.3, 0.2, 0.3))
    bpy.context.object.data.materials.append(glowing)

    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.energy, lamp.size, lamp.color = 30.0, 0.5, (1.0, 0.8, 0.55)
    placed = bpy.data.objects.new("lamp", lamp)
    placed.location = (0.0, 0.0, 1.95)
    scene.collection.objects.link(placed)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = next(n for n in scene.world.node_tree.nodes if n.type == "BACKGROUND")
    background.inputs["Color"].default_value = (0.2, 0.3, 0.5, 1.0)
    background.inputs["Strength"].default_value = 0.3

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (0.0, -4.0, 1.0), (1.5708, 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene


def box(*, folder: str, size: int, samples: int, passes: int) -> dict:
    """As it is (before.exr), made spectral but rendered in RGB (rgb.exr), in bands (bands.exr), and
    with everything undone (after.exr)."""
    convert = extension.module("spectral.convert")
    scene = _box()
    places = {
        name: str(Path(folder) / f"{name}.exr") for name in ("before", "rgb", "bands", "after")
    }
    render_picture(scene, size, size, samples, places["before"])
    report = convert.make_spectral()
    twice = convert.make_spectral()
    render_picture(scene, size, size, samples, places["rgb"])
    said = rendered(scene, places["bands"], samples, passes)
    removed = convert.make_rgb()
    render_picture(scene, size, size, samples, places["after"])
    return {
        **said,
        "spectra": report.spectra,
        "remarks": [[remark.where, remark.text] for remark in report.remarks],
        "twice": twice.spectra,
        "removed": removed,
        "is_spectral": convert.is_spectral(),
    }
