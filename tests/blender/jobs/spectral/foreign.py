# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes that others made: what Blender brings with it, and glTF files."""

from __future__ import annotations

from pathlib import Path

import bpy
from mathutils import Vector

from .. import extension
from ..pictures import empty_scene, of_one_shader, render_picture
from .scenes import rendered


def there_and_back(
    *, kind: str, what: str, folder: str, size: int, samples: int, triples: int
) -> dict:
    """As it was (before.exr) and with another seed (again.exr), made spectral but in RGB (rgb.exr), in bands
    (bands.exr), and with everything undone (after.exr)."""
    convert = extension.module("spectral.convert")
    scene = _KINDS[kind](what)
    _complete(scene)
    scene.render.engine = "CYCLES"
    names = ("before", "again", "rgb", "bands", "after")
    places = {name: str(Path(folder) / f"{name}.exr") for name in names}
    render_picture(scene, size, size, samples, places["before"])
    seed, scene.cycles.seed = scene.cycles.seed, scene.cycles.seed + 1
    render_picture(scene, size, size, samples, places["again"])
    scene.cycles.seed = seed
    report = convert.make_spectral()
    render_picture(scene, size, size, samples, places["rgb"])
    said = rendered(scene, places["bands"], samples, triples)
    removed = convert.make_rgb()
    render_picture(scene, size, size, samples, places["after"])
    return {
        **said,
        "spectra": report.spectra,
        "removed": removed,
        "remarks": [[remark.where, remark.text] for remark in report.remarks],
    }


def _template(name: str) -> bpy.types.Scene:
    """Of those that Blender's *File > New* offers."""
    folder = Path(bpy.utils.resource_path("LOCAL"), "scripts/startup/bl_app_templates_system")
    bpy.ops.wm.open_mainfile(filepath=str(folder / name / "startup.blend"))
    return bpy.context.scene


def _gltf(file: str) -> bpy.types.Scene:
    scene = empty_scene()
    bpy.ops.import_scene.gltf(filepath=file)
    return scene


def _hair(name: str) -> bpy.types.Scene:
    """Brown hair on a ball, by a node group that Blender brings with it."""
    assets = Path(bpy.utils.resource_path("LOCAL"), "datafiles/assets")
    scene = empty_scene()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=12)
    bpy.ops.object.curves_empty_hair_add()
    hair = bpy.context.object
    file = next(assets.rglob("procedural_hair_node_assets.blend"))
    with bpy.data.libraries.load(str(file)) as (_, wanted):
        wanted.node_groups = [name]
    hair.modifiers.new(name, "NODES").node_group = wanted.node_groups[0]
    material, shader = of_one_shader("hair", "ShaderNodeBsdfHairPrincipled")
    shader.inputs["Color"].default_value = (0.5, 0.2, 0.05, 1.0)
    hair.data.materials.append(material)
    return scene


_KINDS = {"template": _template, "gltf": _gltf, "hair": _hair}


def _complete(scene: bpy.types.Scene) -> None:
    """With a camera that sees all there is, a sun and a sky, where these are missing."""
    if scene.camera is None:
        scene.camera = _camera(scene)
    if not any(item.type == "LIGHT" for item in scene.objects):
        sun = bpy.data.lights.new("sun", "SUN")
        sun.angle, sun.energy = 0.1, 2.0
        placed = bpy.data.objects.new("sun", sun)
        placed.rotation_euler = (0.6, 0.3, 0.2)
        scene.collection.objects.link(placed)
    if scene.world is None:
        scene.world = bpy.data.worlds.new("world")
        scene.world.use_nodes = True


def _camera(scene: bpy.types.Scene) -> bpy.types.Object:
    corners = [
        item.matrix_world @ Vector(corner)
        for item in scene.objects
        if item.type == "MESH"
        for corner in item.bound_box
    ]
    low, high = (Vector(pick(axis) for axis in zip(*corners, strict=True)) for pick in (min, max))
    middle, reach = (low + high) / 2, (high - low).length
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.clip_end = 10.0 * reach
    camera.location = middle + reach * Vector((0.8, -1.0, 0.5))
    camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    return camera
