# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball on a studio floor: reflections of a window, two soft boxes and a dark room."""

from __future__ import annotations

import bpy

from .light import area_lamp, camera, environment
from .shape import backdrop, sphere
from .stage import Stage, place_on


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "interior", strength=0.9, turn_deg=150.0, small_lamps=True)
    backdrop(scene, (0.055, 0.058, 0.065), roughness=0.35)
    area_lamp(scene, (-3.6, -2.2, 4.2), (0.0, 0.0, 1.0), size=(2.2, 3.0), watts=420.0)
    area_lamp(
        scene,
        (4.0, -0.5, 2.4),
        (0.0, 0.0, 1.0),
        size=(0.6, 3.4),
        watts=170.0,
        colour=(1.0, 0.86, 0.7),
    )
    area_lamp(scene, (0.0, 3.8, 5.0), (0.0, 1.5, 0.0), size=(5.0, 1.0), watts=260.0)
    ball = sphere(scene, "Ball", (0.0, 0.0, 1.0), 1.0, rings=128)
    camera(scene, (0.0, -8.0, 2.1), (0.0, 0.0, 0.98), lens_mm=85.0)
    return Stage(scene, place_on(ball))
