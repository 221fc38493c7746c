# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Titanium rings, each anodised at another voltage: the oxide grows by about 2 nm a volt."""

from __future__ import annotations

import math
import sys

from staging import backdrop, camera, lamp, lathe, new_scene, save, wave_material

THICKNESSES_NM = (25.0, 38.0, 52.0, 70.0, 92.0, 118.0, 142.0, 165.0, 190.0)


def ring(radius: float, width: float, wall: float):
    """A band with rounded edges and a slightly domed outside."""
    half, edge = width / 2.0, wall * 0.45
    outside = [
        (radius + 0.02 * math.cos(math.pi * t), (half - edge) * 2.0 * t)
        for t in (i / 12 - 0.5 for i in range(13))
    ]
    rims = []
    for side in (1.0, -1.0):
        for step in range(1, 8):
            angle = math.pi * step / 8
            r = radius - wall / 2.0 + side * math.cos(angle) * wall / 2.0
            rims.append((r, side * (half - edge + math.sin(angle) * edge)))
    inside = [(radius - wall, half - edge), (radius - wall, -half + edge)]
    return lathe("Ring", outside + rims[:7] + inside + rims[7:], closed=True, segments=160)


def main() -> None:
    new_scene("studio", strength=1.9, turn_deg=150.0, exposure=0.5)
    backdrop((0.018, 0.018, 0.02), roughness=0.25)
    for index, thickness_nm in enumerate(THICKNESSES_NM):
        row, column = divmod(index, 3)
        obj = ring(0.5, 0.42, 0.09)
        x = (column - 1) * 1.32 + (0.3 if row % 2 else 0.0)
        obj.location = (x, row * 1.15 - 1.0, 0.21)
        if index % 3 == 1:
            # Standing on its edge, leaning back a little.
            obj.location.z = 0.54
            obj.rotation_euler = (math.radians(78.0), 0.0, math.radians(15.0 * (row - 1)))
        wave_material(obj, "anodised_titanium", thickness_nm=thickness_nm, roughness=0.12)
    lamp((-3.5, -1.5, 4.0), (0.0, 0.0, 0.2), size=2.0, watts=320.0)
    lamp((4.0, 2.5, 3.0), (0.0, 0.0, 0.2), size=1.0, watts=160.0)
    camera((0.0, -6.6, 4.3), (0.08, 0.12, 0.2), lens_mm=56.0, f_stop=2.8)
    save(sys.argv[1])


main()
