# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Flint-glass prisms among light tubes: each tube seen through a prism is a spectrum."""

from __future__ import annotations

import math
import sys

import bpy
from staging import (
    backdrop,
    camera,
    mesh_object,
    new_scene,
    plain_material,
    save,
    wave_material,
)


def prism(name: str, side: float, height: float) -> bpy.types.Object:
    """An upright prism with an equilateral base."""
    corners = [
        (side / math.sqrt(3.0) * math.cos(angle), side / math.sqrt(3.0) * math.sin(angle))
        for angle in (math.radians(90.0 + 120.0 * i) for i in range(3))
    ]
    vertices = [(x, y, 0.0) for x, y in corners] + [(x, y, height) for x, y in corners]
    faces = [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]
    obj = mesh_object(name, vertices, faces, smooth=False)
    bevel = obj.modifiers.new("Edges", "BEVEL")
    bevel.width, bevel.segments = 0.012, 2
    return obj


def light_tubes(count: int, radius: float) -> None:
    """Upright tubes in an arc that is open towards the camera."""
    for index in range(count):
        azimuth = math.radians(-28.0 + 236.0 * index / (count - 1))
        bpy.ops.mesh.primitive_cylinder_add(
            radius=0.045,
            depth=2.6,
            location=(radius * math.cos(azimuth), radius * math.sin(azimuth), 1.32),
        )
        tube = plain_material("Tube", (1.0, 1.0, 1.0))
        shader = tube.node_tree.nodes["Principled BSDF"]
        shader.inputs["Emission Color"].default_value = (1.0, 1.0, 1.0, 1.0)
        shader.inputs["Emission Strength"].default_value = 3.0
        bpy.context.object.data.materials.append(tube)


def main() -> None:
    new_scene("studio", strength=0.12, turn_deg=150.0, bounces=16)
    backdrop((0.02, 0.02, 0.023), roughness=0.3, depth=7.0)
    light_tubes(27, 3.2)
    # One edge towards the camera: both faces beside it are near the angle of least deviation.
    for x, y, turn_deg in ((-0.95, 0.1, 57.0), (0.85, 0.35, 64.0)):
        obj = prism("Prism", 1.1, 1.5)
        obj.location = (x, y, 0.002)
        obj.rotation_euler.z = math.radians(turn_deg)
        wave_material(obj, "sf11")
    bpy.ops.mesh.primitive_uv_sphere_add(
        segments=128, ring_count=96, radius=0.36, location=(-0.05, -0.9, 0.362)
    )
    bpy.ops.object.shade_smooth()
    wave_material(bpy.context.object, "n_bk7")
    camera((0.1, -6.8, 2.0), (0.0, 0.0, 0.78), lens_mm=58.0)
    save(sys.argv[1])


main()
