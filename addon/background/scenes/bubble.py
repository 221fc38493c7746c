# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Soap bubbles out of doors; the film is thin on top, where it has drained, and swirls."""

from __future__ import annotations

import bpy

from ...materials.material import input_socket
from ...thickness.nodes import add_source
from .light import camera, environment
from .shape import sphere
from .stage import Stage, place_on

# Centre and radius.
_BUBBLES = (
    ((0.0, 0.0, 0.0), 1.0),
    ((1.5, 0.7, 0.68), 0.42),
    ((-1.45, 0.9, -0.6), 0.36),
    ((1.32, -0.5, -0.82), 0.2),
    ((-1.3, 1.6, 1.02), 0.3),
)


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "forest", strength=1.35, turn_deg=115.0, seen=0.5)
    bubbles = [
        sphere(scene, "Bubble", centre, radius, rings=96 if radius > 0.5 else 64)
        for centre, radius in _BUBBLES
    ]
    camera(scene, (0.0, -8.4, 0.1), (0.1, 0.0, 0.02), lens_mm=85.0, f_stop=0.7)
    scene.cycles.transparent_max_bounces = 32
    return Stage(scene, place_on(*bubbles), dress=_dress)


def _dress(material: bpy.types.Material) -> None:
    """Drained, with a black cap, and stirred."""
    socket = input_socket(material, "thickness_nm")
    if socket is None:
        return
    drainage = add_source(material, "drainage")
    drainage.inputs["Bottom"].default_value = 2.25 * socket.default_value
    drainage.inputs["Black Film"].default_value = 0.08
    swirl = add_source(material, "swirl")
    swirl.inputs["Time"].default_value = 1.0
