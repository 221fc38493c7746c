# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A flat disc under a point lamp, seen by a pinhole, inside Blender.

A job: material, eye, lamp, target (points), fov_deg, height (pixels), samples, file. The picture is
the middle one of five columns, which looks along the plane x = 0. `space`: of the file, if not
what it has; returned is the matrix to XYZ.
"""

from __future__ import annotations

import math

import bpy
from mathutils import Vector

from . import extension
from .furnace import film
from .pictures import empty_scene, render_picture

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


def render(**job) -> list[list[float]]:
    scene = empty_scene(job.get("space", ""))
    material = film(
        scene, {"material": job["material"], "form": "osl", "values": {"roughness": 0.05}}
    )
    disc = add_disc()
    disc.data.materials.append(material)
    add_lamp(scene, job["lamp"])
    add_camera(scene, job)
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    scene.render.use_border = scene.render.use_crop_to_border = True
    scene.render.border_min_x = (WIDTH // 2) / WIDTH
    scene.render.border_max_x = (WIDTH // 2 + 1) / WIDTH
    render_picture(scene, WIDTH, job["height"], job["samples"], job["file"])
    return extension.space_to_xyz()
