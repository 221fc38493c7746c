# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A wrist watch."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix

from ..shape import join, lathe, plain, plate, sheet, spline
from .outline import round_edges, softened
from .portrayed import Portrayed, pose


def watch(scene: bpy.types.Scene) -> Portrayed:
    """Case, lugs and crown take the material."""
    section = (
        (0.0, -0.12), (0.74, -0.12), (0.8, -0.08), (0.82, 0.0), (0.8, 0.06), (0.78, 0.07), (0.76, 0.12),
        (0.74, 0.14), (0.64, 0.15), (0.62, 0.14), (0.6, 0.06),
    )  # fmt: skip
    case = lathe(scene, "Case", section, segments=192)
    crown = lathe(scene, "Crown", ((0.1, 0.0), (0.1, 0.1), (0.08, 0.12), (0.0, 0.12)), segments=48)
    crown.matrix_basis = Matrix.Translation((0.8, 0.0, 0.0)) @ Matrix.Rotation(math.pi / 2, 4, "Y")
    lugs = []
    for sx in (-1.0, 1.0):
        for sy in (-1.0, 1.0):
            box = [(0.36, 0.6), (0.5, 0.55), (0.5, 0.98), (0.36, 0.98)]
            outline = [(sx * x, sy * y) for x, y in box]
            outline = outline if sx * sy > 0.0 else outline[::-1]
            lugs.append(
                plate(scene, "Lug", softened(outline, 0.05), round_edges(-0.12, 0.05, 0.03))
            )
    for part in (case, crown):
        part.data.set_sharp_from_angle(angle=math.radians(32.0))
    metal = join((case, crown, *lugs))
    props = [*_dial(scene), *_strap(scene)]
    pose([metal, *props], lean_deg=52.0, turn_deg=-16.0)
    return Portrayed((metal,), tuple(props), elevation_deg=22.0)


def _dial(scene: bpy.types.Scene):
    black = plain("Dial", (0.01, 0.011, 0.014), roughness=0.35)
    white = plain("Hands", (0.5, 0.5, 0.48), roughness=0.4)
    dial = lathe(scene, "Dial", ((0.61, 0.065), (0.0, 0.065)), segments=96)
    dial.data.materials.append(black)
    marks = []
    bars = [(math.tau * i / 12, 0.45, 0.56, 0.02 if i % 3 else 0.034) for i in range(12)]
    bars += [(math.radians(60.0), -0.06, 0.3, 0.028), (math.radians(144.0), -0.06, 0.48, 0.02)]
    for angle, inner, outer, half in bars:
        mark = plate(
            scene, "Mark", [(inner, -half), (outer, -half), (outer, half), (inner, half)],
            [(0.0, 0.066), (0.0, 0.08), (0.004, 0.084)],
        )  # fmt: skip
        mark.matrix_basis = Matrix.Rotation(angle, 4, "Z")
        mark.data.materials.append(white)
        marks.append(mark)
    return [dial, *marks]


def _strap(scene: bpy.types.Scene):
    leather = plain("Strap", (0.02, 0.014, 0.011), roughness=0.6)
    halves = []
    for side in (-1.0, 1.0):
        path = spline([(0.8, -0.02), (0.98, -0.06), (1.15, -0.2), (1.22, -0.42)], 10)
        last = len(path) - 1

        def place(u: float, v: float, side=side, path=path, last=last):
            y, z = path[round(v * last)]
            a = math.tau * u
            x = math.copysign(abs(math.cos(a)) ** 0.3, math.cos(a)) * 0.345
            return (
                side * x,
                side * y,
                z + 0.05 * math.copysign(abs(math.sin(a)) ** 0.5, math.sin(a)),
            )

        half = sheet(scene, "Strap", place, 48, last)
        half.data.flip_normals()
        half.data.materials.append(leather)
        halves.append(half)
    return halves
