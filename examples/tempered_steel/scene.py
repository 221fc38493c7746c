# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A steel pipe whose oxide grew where it was heated: straw, brown, purple and blue."""

from __future__ import annotations

import math
import sys

from staging import backdrop, camera, lamp, lathe, new_scene, save, thickness_field, wave_material


def pipe(radius: float, length: float, wall: float):
    half = length / 2.0
    profile = [(radius - wall, -half), (radius - 0.01, -half), (radius, -half + 0.01)]
    profile += [(radius, -half + length * i / 40) for i in range(1, 40)]
    profile += [(radius, half - 0.01), (radius - 0.01, half), (radius - wall, half)]
    return lathe("Pipe", profile, closed=True)


def main() -> None:
    new_scene("interior", strength=0.7, turn_deg=40.0)
    backdrop((0.05, 0.05, 0.055), roughness=0.35)
    for x, y, turn, radius in ((0.0, 0.0, 62.0, 0.5), (0.9, 2.1, 112.0, 0.36)):
        obj = pipe(radius, 4.6, 0.07)
        obj.location = (x, y, radius)
        obj.rotation_euler = (0.0, math.radians(90.0), math.radians(turn - 90.0))
        node = wave_material(obj, "tempered_steel", roughness=0.18)
        thickness_field(obj, node, low_nm=8.0, high_nm=68.0, axis="Z", swirl=0.12, swirl_scale=1.5)
    lamp((-3.0, -3.0, 4.0), (0.0, 0.0, 0.4), size=1.6, watts=260.0)
    camera((0.6, -6.4, 2.5), (0.12, 0.3, 0.5), lens_mm=47.0, f_stop=2.8)
    save(sys.argv[1])


main()
