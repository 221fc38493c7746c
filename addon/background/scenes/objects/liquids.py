# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bubbles, slicks and drops."""

from __future__ import annotations

import math

import bpy

from ..plane import asphalt
from ..shape import flat_uvs, lathe, mesh, plain, plate, sheet, sphere, spline
from .portrayed import FOR_CLEAR, Portrayed, pose


def bubble(scene: bpy.types.Scene) -> Portrayed:
    """One large with two small ones."""
    places = (((0.0, 0.0, 0.0), 0.95), ((0.98, -0.2, 0.62), 0.23), ((-0.86, -0.3, -0.72), 0.3))
    bubbles = [sphere(scene, "Bubble", at, r, rings=96 if r > 0.5 else 48) for at, r in places]
    pose(bubbles, floats=True)
    return Portrayed(tuple(bubbles), elevation_deg=8.0, floats=True, light="WINDOW")


def dome(scene: bpy.types.Scene) -> Portrayed:
    """Bubbles that sit on a wet black plate."""
    places = (
        ((0.0, 0.0), 0.86),
        ((0.98, -0.42), 0.36),
        ((-0.72, -0.66), 0.27),
        ((0.62, -0.86), 0.16),
    )
    bubbles = []
    for (x, y), radius in places:
        steps = 64 if radius > 0.5 else 32
        angles = [0.5 * math.pi * i / steps for i in range(steps)]
        profile = [(radius * math.cos(a), radius * math.sin(a)) for a in angles]
        bubble = lathe(scene, "Dome", [*profile, (0.0, radius)], segments=128)
        bubble.matrix_basis.translation = (x, y, 0.045)
        bubbles.append(bubble)
    rim = ((0.0, 0.0), (1.28, 0.0), (1.3, 0.015), (1.3, 0.03), (1.28, 0.045), (0.0, 0.045))
    dish = lathe(scene, "Plate", rim)
    dish.data.set_sharp_from_angle(angle=math.radians(50.0))
    dish.data.materials.append(plain("Plate", (0.01, 0.01, 0.011), roughness=0.12))
    pose([*bubbles, dish])
    return Portrayed(tuple(bubbles), (dish,), elevation_deg=14.0, light=FOR_CLEAR)


def puddle(scene: bpy.types.Scene) -> Portrayed:
    """A slick on wet asphalt."""
    outline = [(1.1 * r * math.cos(a), 0.95 * r * math.sin(a)) for a, r in _waves(240)]
    slick = plate(scene, "Puddle", outline, _bead(0.025), sharp_deg=60.0)
    square = [(-14.0, -14.0, 0.0), (14.0, -14.0, 0.0), (14.0, 14.0, 0.0), (-14.0, 14.0, 0.0)]
    ground = mesh(scene, "Asphalt", square, [(0, 1, 2, 3)], smooth=False)
    ground.data.materials.append(asphalt())
    pose([slick, ground])
    return Portrayed((slick,), elevation_deg=62.0, fill=0.92, light_turn_deg=180.0, has_ground=True)


def _waves(points: int):
    for i in range(points):
        a = math.tau * i / points
        r = 1.0 + 0.14 * math.sin(2 * a + 0.7) + 0.09 * math.sin(3 * a + 2.1)
        yield a, r + 0.05 * math.sin(5 * a + 0.4) + 0.018 * math.sin(11 * a)


def _bead(height: float) -> list[tuple[float, float]]:
    """The edge of a liquid that lies on the ground."""
    steps = 8
    angles = [0.5 * math.pi * i / steps for i in range(steps + 1)]
    return [(4.0 * height * (1.0 - math.cos(a)), height * math.sin(a)) for a in angles]


def pan(scene: bpy.types.Scene) -> Portrayed:
    """Liquid in a black pan with a lip."""
    slick = lathe(
        scene, "Liquid", ((1.02, 0.13), (0.98, 0.118), (0.94, 0.115), (0.0, 0.115)), segments=192
    )
    flat_uvs(slick)
    wall = (
        (0.0, 0.0), (1.0, 0.0), (1.06, 0.03), (1.16, 0.25), (1.15, 0.27), (1.13, 0.27), (1.02, 0.05),
        (0.97, 0.02), (0.0, 0.02),
    )  # fmt: skip
    dish = lathe(scene, "Pan", wall, segments=192)
    dish.data.set_sharp_from_angle(angle=math.radians(60.0))
    dish.data.materials.append(plain("Pan", (0.012, 0.012, 0.013), roughness=0.3))
    pose([slick, dish])
    return Portrayed((slick,), (dish,), elevation_deg=52.0, light_turn_deg=180.0)


def drop(scene: bpy.types.Scene) -> Portrayed:
    """Drops on a leaf."""
    places = (
        ((0.02, 0.0), 0.36), ((0.56, 0.2), 0.23), ((-0.48, 0.3), 0.19), ((-0.5, -0.24), 0.25),
        ((0.44, -0.34), 0.16), ((0.9, -0.12), 0.12), ((0.1, 0.46), 0.12), ((-0.88, 0.04), 0.12),
        ((-0.08, -0.5), 0.12), ((0.72, -0.5), 0.06), ((-0.2, 0.52), 0.05), ((0.34, 0.02), 0.04),
    )  # fmt: skip
    drops = [_drop(scene, x, y, r) for (x, y), r in places]
    leaf = _leaf(scene)
    pose([*drops, leaf], turn_deg=-24.0)
    return Portrayed(tuple(drops), elevation_deg=38.0, fill=0.86, has_ground=True)


def _drop(scene: bpy.types.Scene, x: float, y: float, radius: float) -> bpy.types.Object:
    """Flattened by its weight, on a surface that it hardly wets."""
    steps = 32
    contact = math.radians(110.0)
    flat = 1.0 - 0.5 * radius
    lowest = -math.cos(math.pi - contact)
    profile = [(0.0, 0.0)]
    for i in range(steps):
        a = contact * (1.0 - i / steps)
        profile.append((radius * math.sin(a), radius * flat * (math.cos(a) - lowest)))
    profile.append((0.0, radius * flat * (1.0 - lowest)))
    drop = lathe(scene, "Drop", profile, segments=56)
    drop.data.set_sharp_from_angle(angle=math.radians(60.0))
    drop.matrix_basis.translation = (x, y, _leaf_height(x, y) + 0.004)
    return drop


def _leaf_height(x: float, y: float) -> float:
    return 0.06 * y * y - 0.04 * x * x + 0.23


def _leaf(scene: bpy.types.Scene) -> bpy.types.Object:
    half = [(-2.4, 0.0), (-2.0, 0.55), (-1.1, 1.1), (0.0, 1.3), (1.1, 1.0), (1.9, 0.42), (2.4, 0.0)]
    edge = spline(half, 30)

    def place(u: float, v: float):
        x, width = edge[round(u * (len(edge) - 1))]
        y = (2.0 * v - 1.0) * max(width, 0.0)
        vein = 0.01 * abs(math.sin(6.0 * (x - 0.8 * abs(y)))) ** 12 + 0.03 * math.exp(
            -((y / 0.03) ** 2)
        )
        return x, y, _leaf_height(x, y) - vein

    leaf = sheet(scene, "Leaf", place, len(edge) - 1, 120)
    leaf.data.materials.append(plain("Leaf", (0.035, 0.11, 0.015), roughness=0.5))
    return leaf
