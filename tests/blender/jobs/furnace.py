# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Furnace spheres inside Blender: one, or an atlas of many in one picture.

A job of one: material, form, values, size, samples, file and `lit`:
`all` the plain furnace; `reflected` the world is black for light that passed the film, or glass below
it; `passed` it is white only for camera rays that went straight through the film. (Cycles meets a
point sphere from outside only, so that light crosses one wall.) `sun` is one direction, `angle`
degrees below the camera, and nothing else. Without a material the sphere is white glossy, or with an
`index` white glass, of Blender's own. `brush` lays the tangent to the camera's right. `solid`: the
sphere is a mesh, whose far side light meets from inside; glass always has one. `spread_nm` makes the
thickness uneven by that standard deviation. `inside_deg`: in place of the sphere a plane, seen from
its back at that angle, as from inside of glass. `quarter`: the upper right one of the picture alone.

An atlas: `form`, `cells` (each the material, values, `brush` and `spread_nm` of a sphere), `columns`,
the `size` of a cell, samples and file. Cells go from left to right and down.
"""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix

from . import extension
from .pictures import render_picture

# Enough for what is left inside a sphere of diamond to be nothing.
BOUNCES = ("max_bounces", "glossy_bounces", "transmission_bounces", "transparent_max_bounces")


def light_by_depth(world: bpy.types.World, depth: int) -> None:
    """White where the path has crossed exactly `depth` transparent surfaces and none that refracts,
    and, where it has crossed any, came straight from the camera; black elsewhere."""
    tree = world.node_tree
    background = next(node for node in tree.nodes if node.type == "BACKGROUND")
    path = tree.nodes.new("ShaderNodeLightPath")
    math = extension.module("blender.formula").Formula(tree).number
    crossed = math("COMPARE", path.outputs["Transparent Depth"], float(depth), 0.5)
    unbent = math("COMPARE", path.outputs["Transmission Depth"], 0.0, 0.5)
    lit = math("MULTIPLY", crossed, unbent)
    if depth > 0:
        lit = math("MULTIPLY", lit, path.outputs["Is Camera Ray"])
    tree.links.new(lit, background.inputs["Strength"])


def light_by_sun(scene: bpy.types.Scene, angle: float) -> None:
    """Sharp white light from `angle` degrees below the camera's own direction; a black world."""
    background = next(n for n in scene.world.node_tree.nodes if n.type == "BACKGROUND")
    background.inputs["Strength"].default_value = 0.0
    lamp = bpy.data.lights.new("sun", "SUN")
    lamp.angle = 0.0
    sun = bpy.data.objects.new("sun", lamp)
    # Lamps shine along their own -z, as cameras look.
    turned = Matrix.Rotation(math.radians(angle), 4, "X")
    sun.matrix_world = scene.camera.matrix_world @ turned
    scene.collection.objects.link(sun)


def blenders_own(roughness: float, index: float | None) -> bpy.types.Material:
    material = bpy.data.materials.new("white")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    lobe = tree.nodes.new("ShaderNodeBsdfAnisotropic" if index is None else "ShaderNodeBsdfGlass")
    lobe.distribution = "GGX" if index is None else "MULTI_GGX"
    lobe.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    lobe.inputs["Roughness"].default_value = roughness
    if index is not None:
        lobe.inputs["IOR"].default_value = index
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(lobe.outputs[0], output.inputs["Surface"])
    return material


def film(scene: bpy.types.Scene, job: dict) -> bpy.types.Material:
    materials = extension.module("materials.material")
    compiled = extension.module("core.library").Library.default().load(job["material"])
    material = materials.create_material(compiled, job["form"])
    materials.set_values(material, job["values"])
    if job.get("spread_nm"):
        source = extension.module("thickness.nodes").add_source(material, "spread")
        source.inputs["Spread"].default_value = job["spread_nm"]
    if job.get("brush"):
        right = tuple(scene.camera.matrix_world.col[0].to_3d())
        materials.set_values(material, {"tangent": right})
    if job["form"] == "osl":
        extension.module("materials.scene").use_osl(scene)
        if compiled.wavelength_per_path:
            extension.module("materials.scene").use_wavelengths(scene)
    return material


def place_from_inside(scene: bpy.types.Scene, material: bpy.types.Material, deg: float) -> None:
    """A plane with its front away from the camera, which looks down."""
    mesh = bpy.data.meshes.new("plane")
    corners = [(-9.0, -9.0, 0.0), (-9.0, 9.0, 0.0), (9.0, 9.0, 0.0), (9.0, -9.0, 0.0)]
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    mesh.materials.append(material)
    plane = bpy.data.objects.new("plane", mesh)
    plane.matrix_world = Matrix.Rotation(math.radians(deg), 4, "X")
    scene.collection.objects.link(plane)


def keep_all_light(scene: bpy.types.Scene) -> None:
    scene.cycles.seed = 0
    for bounces in BOUNCES:
        setattr(scene.cycles, bounces, 64)


def render(**job) -> None:
    stage = extension.module("background.scenes").build_stage("furnace")
    scene = stage.scene
    if job["material"] is None:
        material = blenders_own(job["values"]["roughness"], job.get("index"))
    else:
        material = film(scene, job)
    if "inside_deg" in job:
        place_from_inside(scene, material, job["inside_deg"])
    elif job.get("solid"):
        ball = extension.module("background.scenes.shape").sphere
        ball(scene, "Sphere", (0.0, 0.0, 0.0), 1.0, rings=256).data.materials.append(material)
    else:
        stage.place(material)
    if job["lit"] == "sun":
        light_by_sun(scene, job["angle"])
    elif job["lit"] != "all":
        light_by_depth(scene.world, 0 if job["lit"] == "reflected" else 1)
    if job.get("quarter"):
        scene.render.use_border = scene.render.use_crop_to_border = True
        scene.render.border_min_x = scene.render.border_min_y = 0.5
    keep_all_light(scene)
    render_picture(scene, job["size"], job["size"], job["samples"], job["file"])


def seen_by_the_camera_alone(sphere: bpy.types.Object) -> None:
    """The world is white for whatever leaves the sphere, which is convex and so never meets itself."""
    for way in ("diffuse", "glossy", "transmission", "volume_scatter", "shadow"):
        setattr(sphere, f"visible_{way}", False)


def atlas_scene(job: dict) -> bpy.types.Scene:
    stage = extension.module("background.scenes").build_stage("furnace")
    scene, columns = stage.scene, job["columns"]
    rows = math.ceil(len(job["cells"]) / columns)
    scene.camera.data.ortho_scale = 2.0 * max(columns, rows)
    for at, cell in enumerate(job["cells"]):
        before = set(scene.objects)
        stage.place(film(scene, {"form": job.get("form"), **cell}))
        (sphere,) = set(scene.objects) - before
        row, column = divmod(at, columns)
        sphere.location = (2 * column - columns + 1, rows - 1 - 2 * row, 0)
        seen_by_the_camera_alone(sphere)
    keep_all_light(scene)
    return scene


def atlas(**job) -> None:
    scene, columns = atlas_scene(job), job["columns"]
    rows = math.ceil(len(job["cells"]) / columns)
    render_picture(scene, columns * job["size"], rows * job["size"], job["samples"], job["file"])
