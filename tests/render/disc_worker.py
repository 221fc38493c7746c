# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A flat disc under a point lamp, seen by a pinhole, inside Blender: arguments JOB.json.

The job: material, eye, lamp, target (points), fov_deg, height (pixels), samples, file. The picture is
five pixels wide; its middle column looks along the plane x = 0.
"""

from __future__ import annotations

import importlib
import json
import math
import sys
from pathlib import Path

import bpy
from mathutils import Vector
from worker_support import load_extension

WIDTH = 5


def add_disc() -> bpy.types.Object:
    bpy.ops.mesh.primitive_circle_add(vertices=64, radius=20, fill_type="NGON")
    return bpy.context.object


def add_lamp(scene: bpy.types.Scene, position: list[float]) -> None:
    light = bpy.data.lights.new("Lamp", "POINT")
    light.energy = 1e4
    light.shadow_soft_size = 0.0
    lamp = bpy.data.objects.new("Lamp", light)
    lamp.location = position
    scene.collection.objects.link(lamp)


def add_camera(scene: bpy.types.Scene, job: dict) -> None:
    data = bpy.data.cameras.new("Camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(job["fov_deg"])
    camera = bpy.data.objects.new("Camera", data)
    camera.location = job["eye"]
    look = Vector(job["target"]) - Vector(job["eye"])
    camera.rotation_euler = look.to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera


def render(package: str, job: dict) -> None:
    part = {
        name: importlib.import_module(f"{package}.{name}")
        for name in ("core.library", "nodes.material", "nodes.scene", "output")
    }
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    compiled = part["core.library"].Library.default().load(job["material"])
    material = part["nodes.material"].create_material(compiled, "osl")
    part["nodes.material"].set_values(material, {"roughness": 0.05})
    part["nodes.scene"].use_osl(scene)
    part["nodes.scene"].use_wavelengths(scene)
    disc = add_disc()
    disc.data.materials.append(material)
    add_lamp(scene, job["lamp"])
    add_camera(scene, job)
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, job["height"]
    scene.render.resolution_percentage = 100
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    scene.cycles.samples = job["samples"]
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    bpy.ops.render.render()
    part["output"].Writer(scene).save(Path(job["file"]))


def main() -> None:
    package = load_extension()
    for job in json.loads(Path(sys.argv[1]).read_text()):
        render(package, job)


main()
