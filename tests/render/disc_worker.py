# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A flat disc under a point lamp, seen by a pinhole, inside Blender: arguments JOB.json.

The job: material, eye, lamp, target (points), fov_deg, height (pixels), samples, file. The picture is
five pixels wide; its middle column looks along the plane x = 0.
"""

from __future__ import annotations

import math

import bpy
from mathutils import Vector
from worker_support import extension, render_picture, run_jobs

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


def render(job: dict) -> None:
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    compiled = extension("core.library").Library.default().load(job["material"])
    material = extension("nodes.material").create_material(compiled, "osl")
    extension("nodes.material").set_values(material, {"roughness": 0.05})
    extension("nodes.scene").use_osl(scene)
    extension("nodes.scene").use_wavelengths(scene)
    disc = add_disc()
    disc.data.materials.append(material)
    add_lamp(scene, job["lamp"])
    add_camera(scene, job)
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    render_picture(scene, WIDTH, job["height"], job["samples"], job["file"])


run_jobs(render)
