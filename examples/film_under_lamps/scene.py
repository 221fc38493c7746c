# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A soap film in a ring of wire, black where it has drained, that mirrors a large lamp."""

from __future__ import annotations

import math
import sys

import bpy
from staging import (
    backdrop,
    camera,
    lamp,
    lathe,
    mesh_object,
    new_scene,
    plain_material,
    ring_faces,
    save,
    thickness_field,
    wave_material,
)

HEIGHT, TURN_DEG = 1.75, 24.0


def film(radius: float) -> bpy.types.Object:
    """A disc that bulges a little."""
    rings, segments, bulge = 40, 160, 0.008
    vertices = [(0.0, -bulge, 0.0)]
    for ring in range(1, rings + 1):
        share = ring / rings
        for step in range(segments):
            angle = math.tau * step / segments
            r = radius * share
            vertices.append((r * math.cos(angle), -bulge * (1.0 - share**2), r * math.sin(angle)))
    return mesh_object("Film", vertices, ring_faces(rings, segments))


def stand(radius: float) -> None:
    iron = plain_material("Iron", (0.07, 0.07, 0.07), roughness=0.35, metallic=1.0)
    wire = [
        (radius + 0.022 * math.cos(a), 0.022 * math.sin(a))
        for a in (math.tau * i / 16 for i in range(16))
    ]
    ring = lathe("Ring", wire, segments=200, closed=True)
    ring.rotation_euler = (math.pi / 2.0, 0.0, math.radians(TURN_DEG))
    ring.location.z = HEIGHT
    rod = HEIGHT - radius
    bpy.ops.mesh.primitive_cylinder_add(radius=0.024, depth=rod, location=(0.0, 0.0, rod / 2.0))
    bpy.ops.object.shade_smooth_by_angle()
    for obj in (ring, bpy.context.object):
        obj.data.materials.append(iron)
    profile = [(0.0, 0.0), (0.42, 0.0), (0.44, 0.02), (0.44, 0.07), (0.4, 0.11), (0.12, 0.15)]
    base = lathe("Base", [*profile, (0.05, 0.2), (0.0, 0.2)])
    base.data.materials.append(plain_material("Walnut", (0.09, 0.04, 0.018), roughness=0.25))


def main() -> None:
    new_scene("studio", strength=0.12, turn_deg=150.0, bounces=8)
    backdrop((0.012, 0.012, 0.012), roughness=0.3, depth=5.0)
    obj = film(1.0)
    obj.location.z = HEIGHT
    obj.rotation_euler.z = math.radians(TURN_DEG)
    node = wave_material(obj, "soap_film")
    thickness_field(obj, node, low_nm=1450.0, high_nm=-60.0, axis="Z", swirl=0.06, swirl_scale=0.7)
    stand(1.0)
    # Where the film mirrors it to the camera.
    turn = math.radians(2.0 * TURN_DEG)
    place = (6.0 * math.sin(turn), -6.0 * math.cos(turn), 1.7)
    lamp(place, (0.0, 0.0, HEIGHT), size=6.0, watts=1000.0)
    camera((0.0, -9.0, 1.6), (0.0, 0.0, 1.44), lens_mm=98.0, f_stop=2.0)
    save(sys.argv[1])


main()
