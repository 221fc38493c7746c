# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A round brilliant among strip lights on black: its fire is the dispersion."""

from __future__ import annotations

import math

import bpy

from .light import area_lamp, camera, environment
from .shape import backdrop, mesh
from .stage import Stage, place_on

# Of a well cut stone, in girdle diameters and degrees: Tolkowsky, "Diamond Design" (1919).
_TABLE, _CROWN_DEG, _PAVILION_DEG, _GIRDLE = 0.53, 34.5, 40.75, 0.025


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "studio", strength=1.3, turn_deg=75.0)
    backdrop(scene, (0.03, 0.03, 0.034), roughness=0.3)
    stones = [_place(scene, *pose) for pose in _POSES]
    for x in (-1.0, -0.35, 0.35, 1.0):
        area_lamp(scene, (3.2 * x, -1.5, 4.6), (0.0, 0.0, 0.5), size=(0.16, 2.6), watts=110.0)
    area_lamp(scene, (0.0, 3.4, 3.4), (0.0, 0.0, 0.6), size=(2.6, 0.3), watts=70.0)
    camera(scene, (0.0, -6.4, 3.6), (0.0, 0.0, 0.5), lens_mm=85.0)
    scene.cycles.max_bounces = scene.cycles.transmission_bounces = 24
    return Stage(scene, place_on(*stones), samples=256)


# Centre on the floor, size, turn and lean in degrees.
_POSES = (
    ((0.0, 0.0), 2.0, 12.0, 0.0),
    ((-1.65, 0.7), 1.05, 40.0, 0.0),
    ((1.6, 0.45), 0.85, 5.0, 0.0),
)


def _place(scene, centre, size, turn_deg, lean_deg) -> bpy.types.Object:
    stone = brilliant(scene)
    stone.scale = (size, size, size)
    stone.rotation_euler = (math.radians(lean_deg), 0.0, math.radians(turn_deg))
    stone.location = (*centre, 0.5 * size * math.tan(math.radians(_PAVILION_DEG)) + 0.01)
    return stone


def brilliant(scene: bpy.types.Scene) -> bpy.types.Object:
    """57 facets and the girdle, as the hull of the corners of the cut; girdle diameter 1."""
    crown = 0.5 * (1.0 - _TABLE) * math.tan(math.radians(_CROWN_DEG))
    depth = 0.5 * math.tan(math.radians(_PAVILION_DEG))
    top = _GIRDLE + crown
    points = [(0.0, 0.0, -depth)]
    points += _ring(8, 0.0, 0.5 * _TABLE, top)
    # Stars meet the bezels where both slopes are kept.
    points += _ring(8, 0.5, 0.5 * (0.5 * _TABLE + 0.5) * 1.035, _GIRDLE + 0.48 * crown)
    points += _ring(16, 0.0, 0.5, _GIRDLE)
    points += _ring(16, 0.0, 0.5, 0.0)
    points += _ring(8, 0.5, 0.125, -0.77 * depth)
    return _hull(scene, points)


def _ring(count: int, shift: float, radius: float, z: float):
    angles = [math.tau * (i + shift) / count for i in range(count)]
    return [(radius * math.cos(a), radius * math.sin(a), z) for a in angles]


def _hull(scene: bpy.types.Scene, points) -> bpy.types.Object:
    import bmesh

    shape = bmesh.new()
    corners = [shape.verts.new(point) for point in points]
    bmesh.ops.convex_hull(shape, input=corners)
    bmesh.ops.dissolve_limit(
        shape, angle_limit=math.radians(0.5), verts=shape.verts, edges=shape.edges
    )
    stone = mesh(scene, "Brilliant", [], [], smooth=False)
    shape.to_mesh(stone.data)
    shape.free()
    return stone
