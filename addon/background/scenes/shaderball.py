# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A turned body with a grooved collar on a stand: curved, flat and hollow parts under soft boxes."""

from __future__ import annotations

import math

import bpy

from .light import area_lamp, camera, environment
from .shape import backdrop, lathe, plain, sphere
from .stage import Stage, place_on
from .thickness import vary


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "studio", strength=0.95, turn_deg=30.0)
    backdrop(scene, (0.05, 0.053, 0.06), roughness=0.4)
    area_lamp(scene, (-3.8, -2.6, 4.6), (0.0, 0.0, 1.1), size=(2.4, 3.2), watts=520.0)
    area_lamp(
        scene,
        (4.2, -1.0, 2.6),
        (0.0, 0.0, 1.1),
        size=(0.7, 3.6),
        watts=220.0,
        colour=(1.0, 0.87, 0.72),
    )
    area_lamp(scene, (0.5, 3.9, 5.2), (0.0, 1.2, 0.4), size=(5.0, 1.2), watts=320.0)
    body = _body(scene)
    stand = lathe(scene, "Stand", _STAND, segments=128)
    stand.data.materials.append(plain("Stand", (0.02, 0.02, 0.022), roughness=0.28))
    core = sphere(scene, "Core", (0.0, 0.0, 1.32), 0.52, rings=64)
    core.data.materials.append(plain("Core", (0.3, 0.3, 0.31), roughness=0.45))
    camera(scene, (1.0, -8.9, 3.2), (0.0, 0.0, 1.1), lens_mm=85.0)
    return Stage(scene, place_on(*body), dress=_dress)


_STAND = (
    (0.0, 0.0), (0.86, 0.0), (0.9, 0.015), (0.92, 0.05), (0.9, 0.085), (0.86, 0.1), (0.5, 0.115),
    (0.4, 0.16), (0.36, 0.24), (0.36, 0.36), (0.0, 0.36),
)  # fmt: skip


def _body(scene: bpy.types.Scene) -> list[bpy.types.Object]:
    """A shell cut open at the front towards the core, and the collar around its foot."""
    centre, radius = 1.32, 1.0
    shell = lathe(scene, "Shell", _shell(radius), segments=256)
    shell.location = (0.0, 0.0, centre)
    shell.rotation_euler = (math.radians(58.0), 0.0, math.radians(-24.0))
    collar = lathe(scene, "Collar", _collar(0.66, 0.3, 0.085), segments=192)
    return [shell, collar]


def _shell(radius: float) -> list[tuple[float, float]]:
    """From the closed pole over the outside to a round lip, and back along the inside."""
    thick, opening = 0.075, math.radians(42.0)
    steps = 96
    angles = [math.pi - (math.pi - opening) * i / steps for i in range(steps + 1)]
    outside = [(radius * math.sin(a), radius * math.cos(a)) for a in angles]
    outside[0] = (0.0, -radius)
    middle = radius - thick / 2.0
    lip = []
    for i in range(1, 12):
        turn = math.pi * i / 12
        r = middle + thick / 2.0 * math.cos(turn)
        along = thick / 2.0 * math.sin(turn)
        lip.append(
            (
                r * math.sin(opening) - along * math.cos(opening),
                r * math.cos(opening) + along * math.sin(opening),
            )
        )
    inner = radius - thick
    inside = [(inner * math.sin(a), inner * math.cos(a)) for a in reversed(angles)]
    inside[-1] = (0.0, -inner)
    return [*outside, *lip, *inside]


def _collar(radius: float, height: float, thick: float) -> list[tuple[float, float]]:
    """A ring of round section, closed on itself."""
    steps = 40
    return [
        (
            radius + thick * math.cos(math.tau * i / steps),
            height - 0.12 + thick * math.sin(math.tau * i / steps),
        )
        for i in range(steps + 1)
    ]


def _dress(material: bpy.types.Material) -> None:
    vary(material, base=0.82, height=0.36, swirl=0.0, scale=1.0)
