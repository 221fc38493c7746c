# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A film of oil on a puddle in a street, seen at a low angle."""

from __future__ import annotations

import math
import sys

import bpy
from mathutils import Vector, noise
from staging import (
    bump,
    camera,
    mesh_object,
    new_scene,
    plain_material,
    ring_faces,
    save,
    thickness_field,
    wave_material,
)


def puddle() -> bpy.types.Object:
    """A flat shape with a wandering outline."""
    rings, segments = 24, 160
    vertices = [(0.0, 0.0, 0.012)]
    for ring in range(1, rings + 1):
        for step in range(segments):
            angle = math.tau * step / segments
            direction = Vector((math.cos(angle), math.sin(angle), 0.0))
            reach = 1.9 + 0.9 * noise.noise(direction * 1.3) + 0.25 * noise.noise(direction * 4.0)
            point = direction * reach * ring / rings
            vertices.append((1.5 * point.x, point.y, 0.012))
    return mesh_object("Puddle", vertices, ring_faces(rings, segments))


def asphalt() -> None:
    bpy.ops.mesh.primitive_plane_add(size=60.0)
    material = plain_material("Asphalt", (0.03, 0.03, 0.033), roughness=0.75)
    bump(material, scale=55.0, strength=0.7, distance_m=0.02)
    bpy.context.object.data.materials.append(material)


def main() -> None:
    new_scene("city", turn_deg=2.0, exposure=0.8)
    asphalt()
    water = puddle()
    node = wave_material(water, "oil_on_water")
    thickness_field(water, node, low_nm=0.0, high_nm=750.0, axis="", swirl=1.0, swirl_scale=0.75)
    camera((0.2, -6.0, 2.7), (0.0, 0.0, 0.0), lens_mm=46.0, f_stop=4.0)
    save(sys.argv[1])


main()
