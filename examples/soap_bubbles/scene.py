# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Soap bubbles outdoors; each film is thin at the top, where it has drained, and thick below."""

from __future__ import annotations

import sys

import bpy
from staging import camera, new_scene, save, thickness_field, wave_material

# Centre, radius (m), thickness at the top and at the bottom (nm).
BUBBLES = (
    ((0.0, 0.0, 0.0), 1.0, 120.0, 620.0),
    ((1.75, 0.5, 0.75), 0.62, 250.0, 700.0),
    ((-1.7, 0.9, -0.55), 0.7, 60.0, 520.0),
    ((1.25, -0.8, -0.85), 0.36, 350.0, 900.0),
    ((-1.25, -0.4, 1.0), 0.3, 200.0, 480.0),
    ((0.35, 1.8, 1.35), 0.42, 150.0, 800.0),
    ((-2.9, 2.5, 1.0), 0.5, 300.0, 650.0),
    ((2.9, 2.2, -0.6), 0.55, 180.0, 560.0),
)


def bubble(centre, radius, top_nm, bottom_nm) -> None:
    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=64, radius=radius, location=centre)
    obj = bpy.context.object
    bpy.ops.object.shade_smooth()
    node = wave_material(obj, "soap_film")
    # Drainage by height, with the swirls that air currents draw.
    thickness_field(
        obj, node, low_nm=bottom_nm, high_nm=top_nm, axis="Z", swirl=0.35, swirl_scale=1.6
    )


def main() -> None:
    new_scene("forest", strength=0.9, turn_deg=115.0, exposure=0.3, bounces=12)
    for values in BUBBLES:
        bubble(*values)
    camera((0.0, -9.5, 0.1), (0.0, 0.0, 0.15), lens_mm=70.0, f_stop=0.4)
    save(sys.argv[1])


main()
