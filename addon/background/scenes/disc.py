# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An optical disc, tilted towards the camera, under a small bright lamp."""

from __future__ import annotations

import math

import bpy

from .light import area_lamp, camera, environment
from .shape import backdrop, lathe, plain
from .stage import Stage, place_on

# Radii of a 120 mm disc in decimetres: hole, clamping ring, data, rim (IEC 60908).
_HOLE, _RING, _DATA, _RIM = 0.075, 0.23, 0.58, 0.6
_THICK = 0.012


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "night", strength=1.2, turn_deg=0.0, small_lamps=True)
    backdrop(scene, (0.02, 0.021, 0.024), roughness=0.4, depth=3.0)
    data = lathe(scene, "Data", ((_RING, 0.0), (_DATA, 0.0)), segments=256)
    ring = lathe(
        scene, "Ring", ((_HOLE, -_THICK), (_HOLE, 0.0), (_RING, 0.0)), segments=128, smooth=False
    )
    rim = lathe(
        scene, "Rim", ((_DATA, 0.0), (_RIM, 0.0), (_RIM, -_THICK), (_HOLE, -_THICK)),
        segments=256, smooth=False,
    )  # fmt: skip
    clear = plain("Polycarbonate", (0.32, 0.33, 0.35), roughness=0.12, metallic=0.85)
    for obj in (ring, rim):
        obj.data.materials.append(clear)
    # Leaning back on its rim.
    tilt = math.radians(52.0)
    for obj in (data, ring, rim):
        obj.rotation_euler = (tilt, 0.0, 0.0)
        obj.location = (0.0, 0.0, _RIM * math.sin(tilt) + _THICK)
    area_lamp(scene, (-0.9, -2.2, 3.2), (0.0, 0.0, 0.45), size=(0.16, 0.16), watts=38.0)
    area_lamp(scene, (1.5, -1.0, 2.2), (0.0, 0.0, 0.45), size=(0.1, 0.7), watts=16.0)
    camera(scene, (0.15, -3.9, 1.45), (0.0, -0.02, 0.44), lens_mm=85.0)
    return Stage(scene, place_on(data))
