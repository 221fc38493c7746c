# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Dichroic mirrors on a light table: what they reflect is missing from what they let through."""

from __future__ import annotations

import math
import sys

import bpy
from staging import backdrop, camera, lamp, mesh_object, new_scene, save, wave_material


def pane(name: str, width: float, height: float) -> bpy.types.Object:
    half = width / 2.0
    corners = [(-half, 0.0, 0.0), (half, 0.0, 0.0), (half, 0.0, height), (-half, 0.0, height)]
    return mesh_object(name, corners, [(0, 1, 2, 3)], smooth=False)


def main() -> None:
    new_scene("studio", strength=0.5, turn_deg=20.0, bounces=12)
    backdrop((0.55, 0.55, 0.55), roughness=0.6)
    for x, y, turn_deg in ((-1.35, 0.1, 50.0), (-0.05, 0.5, 8.0), (1.25, 0.0, -38.0)):
        obj = pane("Mirror", 1.25, 1.7)
        obj.location = (x, y, 0.0)
        obj.rotation_euler.z = math.radians(turn_deg)
        wave_material(obj, "dichroic_mirror")
    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=64, radius=0.3)
    ball = bpy.context.object
    bpy.ops.object.shade_smooth()
    ball.location = (-0.55, -0.75, 0.3)
    wave_material(ball, "dichroic_mirror")
    lamp((1.8, 5.2, 4.6), (0.0, 0.0, 0.4), size=0.5, watts=900.0)
    lamp((-3.5, -3.0, 3.5), (0.0, 0.0, 0.4), size=2.0, watts=180.0)
    camera((0.1, -7.0, 2.3), (-0.05, 0.0, 0.62), lens_mm=52.0)
    save(sys.argv[1])


main()
