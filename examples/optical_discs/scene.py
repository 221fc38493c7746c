# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Optical discs under a lamp: the finer the tracks, the wider the colours are spread.

usage: scene.py cd|dvd OUT.blend
"""

from __future__ import annotations

import math
import sys

from staging import backdrop, camera, lamp, lathe, new_scene, plain_material, save, wave_material

# Radii of a 120 mm disc in decimetres: hole, clear ring, data, rim (IEC 60908).
HOLE, DATA, DATA_END, RIM = 0.075, 0.23, 0.585, 0.6
THICKNESS = 0.012


def disc(material: str, location, rotation_deg) -> None:
    data = lathe("Data", [(DATA, 0.0), (DATA_END, 0.0)], segments=256)
    edge = [
        (DATA_END, 0.0),
        (RIM, 0.0),
        (RIM, -THICKNESS),
        (HOLE, -THICKNESS),
        (HOLE, 0.0),
        (DATA, 0.0),
    ]
    rest = lathe("Edge", edge, segments=256)
    rest.data.materials.append(
        plain_material("Plastic", (0.55, 0.56, 0.58), roughness=0.12, metallic=0.9)
    )
    for obj in (data, rest):
        obj.location = location
        obj.rotation_euler = [math.radians(angle) for angle in rotation_deg]
    wave_material(data, material)


def main() -> None:
    material, path = sys.argv[1:]
    new_scene("studio", strength=2.5, turn_deg=-60.0, exposure=0.4)
    backdrop((0.02, 0.02, 0.023), roughness=0.45)
    disc(material, (-0.42, 0.0, 0.016), (0.0, 0.0, 0.0))
    disc(material, (0.55, 0.42, 0.56), (68.0, 0.0, -24.0))
    for x, y, z in (
        (-1.6, 1.9, 2.4),
        (1.9, -1.2, 2.2),
        (-2.6, -0.6, 1.8),
        (0.4, 2.6, 2.9),
        (0.6, -2.6, 2.6),
    ):
        lamp((x, y, z), (0.1, 0.2, 0.3), size=0.12, watts=22.0)
    camera((-0.15, -3.2, 1.75), (0.06, 0.1, 0.36), lens_mm=46.0)
    save(path)


main()
