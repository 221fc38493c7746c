# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colour-shift ink, as on banknotes and cars, on a form that shows every angle."""

from __future__ import annotations

import math
import sys

import bpy
from staging import backdrop, camera, lamp, new_scene, save, wave_material


def knot(p: int, q: int, *, tube: float) -> bpy.types.Object:
    """A torus knot that winds p times around the axis and q times through the hole."""
    curve = bpy.data.curves.new("Knot", "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth, curve.bevel_resolution, curve.resolution_u = tube, 24, 8
    spline = curve.splines.new("NURBS")
    steps = 240
    spline.points.add(steps - 1)
    for step, point in enumerate(spline.points):
        t = math.tau * step / steps
        r = 1.0 + 0.42 * math.cos(q * t)
        point.co = (r * math.cos(p * t), r * math.sin(p * t), 0.42 * math.sin(q * t), 1.0)
    spline.use_cyclic_u, spline.order_u = True, 4
    obj = bpy.data.objects.new("Knot", curve)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def main() -> None:
    new_scene("sunset", strength=0.9, turn_deg=70.0)
    backdrop((0.08, 0.08, 0.085), roughness=0.4)
    obj = knot(2, 3, tube=0.27)
    obj.location = (0.0, 0.0, 1.42)
    obj.rotation_euler = (math.radians(72.0), math.radians(14.0), math.radians(10.0))
    wave_material(obj, "colour_shift_ink", roughness=0.2)
    lamp((-3.0, -2.5, 4.5), (0.0, 0.0, 1.2), size=2.0, watts=300.0)
    camera((0.0, -7.2, 2.2), (0.0, 0.0, 1.34), lens_mm=46.0, f_stop=4.0)
    save(sys.argv[1])


main()
