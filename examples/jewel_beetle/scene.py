# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A jewel beetle's wing cases: sixteen layers of chitin that turn from green to blue with angle."""

from __future__ import annotations

import math
import sys

import bpy
from mathutils import Vector, noise
from staging import (
    backdrop,
    bump,
    camera,
    lamp,
    new_scene,
    plain_material,
    save,
    wave_material,
)


def shell(name: str, size, centre, *, dimples: float, half: int = 0) -> bpy.types.Object:
    """An ellipsoid with fine dimples; `half` keeps the part on one side of the seam at x = 0, and
    gives it the ribs of a wing case.
    """
    bpy.ops.mesh.primitive_uv_sphere_add(segments=160, ring_count=120)
    obj = bpy.context.object
    obj.name = name
    bpy.ops.object.shade_smooth()
    for vertex in obj.data.vertices:
        p = vertex.co.copy()
        ridge = 1.0 + dimples * noise.noise(Vector((p.x * 14.0, p.y * 5.0, p.z * 14.0)))
        taper = 1.0 - (0.35 if half else 0.22) * max(p.y, 0.0) ** 2
        if half:
            ridge += 0.008 * math.cos(22.0 * math.atan2(p.z, p.x)) * (1.0 - p.y * p.y)
        x = p.x * size[0] * taper
        if half:
            # The two cases meet in a groove.
            x = half * (abs(x) if x * half > 0.0 else 0.0) + half * 0.012
        vertex.co = (x * ridge, p.y * size[1] * ridge, p.z * size[2] * ridge)
    obj.location = centre
    return obj


def limb(points, radius: float) -> None:
    """Thinner towards its end."""
    curve = bpy.data.curves.new("Leg", "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth, curve.bevel_resolution = 0.055, 6
    spline = curve.splines.new("NURBS")
    spline.points.add(len(points) - 1)
    for number, (point, position) in enumerate(zip(spline.points, points, strict=True)):
        point.co = (*position, 1.0)
        point.radius = radius * (1.0 - 0.65 * number / (len(points) - 1))
    spline.use_endpoint_u, spline.order_u = True, 3
    obj = bpy.data.objects.new("Leg", curve)
    bpy.context.scene.collection.objects.link(obj)
    wave_material(obj, "jewel_beetle", roughness=0.3)


def main() -> None:
    new_scene("forest", strength=0.9, turn_deg=60.0)
    floor = backdrop((0.32, 0.25, 0.18), roughness=0.8)
    bump(floor.data.materials[0], scale=3.0, strength=0.25, distance_m=0.05)
    height = 0.62
    for side in (-1, 1):
        case = shell("Wing case", (0.86, 1.55, 0.58), (0.0, 0.25, height), dimples=0.012, half=side)
        wave_material(case, "jewel_beetle", roughness=0.16)
        for y, reach, forward in ((-0.95, 1.25, -0.55), (-0.2, 1.45, 0.0), (0.6, 1.35, 0.6)):
            limb(
                [
                    (side * 0.5, y, 0.45),
                    (side * 0.9, y + forward * 0.4, 0.62),
                    (side * 0.98, y + forward * 0.45, 0.66),
                    (side * (reach - 0.05), y + forward * 0.95, 0.06),
                    (side * reach, y + forward, 0.03),
                    (side * (reach + 0.2), y + forward * 1.3, 0.03),
                ],
                radius=1.0,
            )
    thorax = shell("Thorax", (0.74, 0.5, 0.46), (0.0, -1.28, height - 0.04), dimples=0.015)
    head = shell("Head", (0.44, 0.34, 0.3), (0.0, -1.78, height - 0.14), dimples=0.01)
    for part in (thorax, head):
        wave_material(part, "jewel_beetle", roughness=0.2)
    dark = plain_material("Eye", (0.01, 0.008, 0.006), roughness=0.15)
    for side in (-1, 1):
        bpy.ops.mesh.primitive_uv_sphere_add(
            radius=0.13, location=(side * 0.35, -1.86, height - 0.06)
        )
        bpy.ops.object.shade_smooth()
        bpy.context.object.data.materials.append(dark)
        limb(
            [
                (side * 0.14, -2.05, height - 0.08),
                (side * 0.3, -2.35, height + 0.12),
                (side * 0.62, -2.6, height + 0.1),
                (side * 0.95, -2.72, height - 0.05),
            ],
            radius=0.5,
        )
    lamp((-3.0, -3.0, 5.0), (0.0, 0.0, 0.5), size=2.5, watts=380.0)
    lamp((2.2, 3.9, 2.4), (0.0, 0.4, 0.6), size=3.0, watts=260.0)
    camera((-3.8, -5.7, 4.4), (0.15, -0.42, 0.4), lens_mm=52.0, f_stop=4.0)
    save(sys.argv[1])


main()
