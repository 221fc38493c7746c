# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Round brilliants: dispersion of diamond breaks the light of small lamps into fire."""

from __future__ import annotations

import math
import sys

import bpy  # first: it brings the modules below

# isort: split
import bmesh
from mathutils import Vector
from staging import backdrop, camera, lamp, new_scene, save, wave_material

# Facets by name: angle to the girdle plane, first azimuth, number around, distance from the centre
# in units of the girdle's radius. After Tolkowsky (1919): crown 34.5, pavilion 40.75, table 53 %.
CROWN, PAVILION = 34.5, -40.75
FACETS = (
    (0.0, 0.0, 1, 0.3234),
    (CROWN, 0.0, 8, None),
    (41.5, 11.25, 16, None),
    (21.5, 22.5, 8, 0.4963),
    (PAVILION, 0.0, 8, None),
    (-42.0, 11.25, 16, None),
)


def cut(mesh: bmesh.types.BMesh, normal: Vector, distance: float) -> None:
    geometry = [*mesh.verts, *mesh.edges, *mesh.faces]
    result = bmesh.ops.bisect_plane(
        mesh, geom=geometry, plane_co=normal * distance, plane_no=normal, clear_outer=True
    )
    edges = [item for item in result["geom_cut"] if isinstance(item, bmesh.types.BMEdge)]
    if edges:
        bmesh.ops.contextual_create(mesh, geom=edges)


def brilliant(name: str) -> bpy.types.Object:
    mesh = bmesh.new()
    bmesh.ops.create_cone(mesh, cap_ends=True, segments=96, radius1=1.0, radius2=1.0, depth=2.0)
    for angle_deg, first_deg, count, distance in FACETS:
        tilt = math.radians(angle_deg)
        for index in range(count):
            azimuth = math.radians(first_deg + 360.0 / count * index)
            lateral = math.sin(abs(tilt))
            normal = Vector(
                (lateral * math.cos(azimuth), lateral * math.sin(azimuth), math.cos(tilt))
            )
            if angle_deg < 0.0:
                normal.z = -normal.z
            # Where no distance is given the facet passes just above or below the girdle.
            reach = distance if distance is not None else lateral + abs(normal.z) * 0.015
            cut(mesh, normal, reach)
    bmesh.ops.recalc_face_normals(mesh, faces=mesh.faces)
    data = bpy.data.meshes.new(name)
    mesh.to_mesh(data)
    mesh.free()
    obj = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def main() -> None:
    new_scene("courtyard", strength=0.32, turn_deg=90.0, exposure=0.6, bounces=24)
    backdrop((0.012, 0.012, 0.016), roughness=0.3)
    for x, y, z, tilt, turn, scale in (
        (0.0, 0.0, 0.668, 49.0, 8.0, 1.0),
        (-1.75, 0.5, 0.48, 49.0, 70.0, 0.72),
        (1.6, 0.35, 0.43, 49.0, -50.0, 0.64),
    ):
        obj = brilliant("Brilliant")
        obj.location = (x, y, z)
        obj.rotation_euler = (math.radians(tilt), 0.0, math.radians(turn))
        obj.scale = (scale, scale, scale)
        wave_material(obj, "diamond")
    for index in range(13):
        angle = math.tau * index / 13
        lamp(
            (3.2 * math.cos(angle), 3.2 * math.sin(angle), 3.6 + 0.5 * (index % 3)),
            (0.0, 0.0, 0.6),
            size=0.07,
            watts=110.0,
        )
    camera((0.0, -6.2, 3.4), (-0.05, 0.1, 0.6), lens_mm=54.0)
    save(sys.argv[1])


main()
