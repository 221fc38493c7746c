# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A mirror ball in the lights that a scene can be put into."""

from __future__ import annotations

import math

import bpy

from . import extension
from .pictures import empty_scene, render_picture

SIZE = 48


def names() -> list[str]:
    """Of all lights, as the menu has them."""
    return [key for key, _, _ in extension.module("lighting.rooms").LIGHTS]


def mirror(**job) -> None:
    """`turn_deg` turns the camera around the ball, as `rotation_deg` does the light."""
    scene = empty_scene()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32)
    ball = bpy.context.object
    bpy.ops.object.shade_smooth()
    material = bpy.data.materials.new("Mirror")
    material.use_nodes = True
    principled = material.node_tree.nodes["Principled BSDF"]
    principled.inputs["Metallic"].default_value = 1.0
    principled.inputs["Roughness"].default_value = 0.0
    principled.inputs["Base Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    ball.data.materials.append(material)
    data = bpy.data.cameras.new("Camera")
    data.type, data.ortho_scale = "ORTHO", 1.9
    scene.camera = bpy.data.objects.new("Camera", data)
    scene.collection.objects.link(scene.camera)
    turn = math.radians(job["turn_deg"] - 90.0)
    scene.camera.location = (5.0 * math.cos(turn), 5.0 * math.sin(turn), 0.0)
    scene.camera.rotation_euler = (math.pi / 2.0, 0.0, turn + math.pi / 2.0)
    rotation = math.radians(job["rotation_deg"])
    lighting = extension.module("lighting.world")
    lighting.light_scene(scene, job["light"], job["strength"], rotation)
    render_picture(scene, SIZE, SIZE, 16, job["file"])
