# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A prism before thin tubes of light: each tube that is seen through it becomes a spectrum."""

from __future__ import annotations

import math

import bpy

from .light import area_lamp, camera, environment
from .shape import backdrop, glow, mesh
from .stage import Stage, place_on

# Where the tubes stand around the prism: from the left over the back to the right. Flint glass turns
# light by some 60 degrees, so what is seen through the prism stands at its sides.
_TUBES_DEG = tuple(range(-20, 201, 11))
_DISTANCE = 3.4


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "studio", strength=0.4, turn_deg=60.0)
    backdrop(scene, (0.012, 0.012, 0.014), roughness=0.3, depth=5.0)
    tubes = glow("Tube", (1.0, 0.97, 0.93), 9.0)
    for angle_deg in _TUBES_DEG:
        _tube(scene, math.radians(angle_deg), tubes)
    prism = _prism(scene, side=1.55, height=1.9)
    prism.rotation_euler = (0.0, 0.0, math.radians(14.0))
    area_lamp(scene, (-2.5, -3.0, 4.5), (0.0, 0.0, 0.8), size=(1.0, 2.2), watts=60.0)
    camera(scene, (0.35, -7.4, 2.2), (0.0, 0.0, 0.95), lens_mm=70.0)
    return Stage(scene, place_on(prism), samples=256)


def _tube(scene: bpy.types.Scene, angle: float, material: bpy.types.Material) -> None:
    half = 0.022
    corners = [(-half, 0.0, 0.02), (half, 0.0, 0.02), (half, 0.0, 3.2), (-half, 0.0, 3.2)]
    tube = mesh(scene, "Tube", corners, [(0, 1, 2, 3)], smooth=False)
    tube.location = (_DISTANCE * math.cos(angle), _DISTANCE * math.sin(angle), 0.0)
    tube.rotation_euler = (0.0, 0.0, angle + math.pi / 2.0)
    tube.data.materials.append(material)


def _prism(scene: bpy.types.Scene, side: float, height: float) -> bpy.types.Object:
    """Upright, with an equilateral base and bevelled edges."""
    radius = side / math.sqrt(3.0)
    corners = [math.radians(90.0 + 120.0 * i) for i in range(3)]
    outline = [(radius * math.cos(a), radius * math.sin(a)) for a in corners]
    vertices = [(x, y, z) for z in (0.01, height) for x, y in outline]
    faces = [(2, 1, 0), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]
    prism = mesh(scene, "Prism", vertices, faces, smooth=False)
    bevel = prism.modifiers.new("Bevel", "BEVEL")
    bevel.width, bevel.segments = 0.018, 2
    return prism
