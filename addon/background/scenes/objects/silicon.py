# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wafers and cells."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix

from ..shape import flat_uvs, mesh, plain, plate
from .portrayed import Portrayed, pose

_FLAT = 0.94  # of the radius: where the flat cuts the edge


def _wafer_outline(radius: float, points: int = 256):
    cut = math.acos(_FLAT)
    return [
        (radius * math.cos(a), radius * math.sin(a))
        for a in (
            -0.5 * math.pi + cut + (math.tau - 2.0 * cut) * i / points for i in range(points + 1)
        )
    ]


def wafer(scene: bpy.types.Scene) -> Portrayed:
    """With its dies."""
    base = plate(
        scene,
        "Silicon",
        _wafer_outline(1.0),
        [(0.006, -0.02), (0.0, -0.014), (0.0, -0.006), (0.006, 0.0)],
    )
    base.data.materials.append(plain("Silicon", (0.06, 0.06, 0.064), roughness=0.3, metallic=0.9))
    dies = _dies(scene, (0.19, 0.15), 0.012)
    pose([dies, base], lean_deg=53.0, turn_deg=-6.0, roll_deg=0.0)
    return Portrayed((dies,), (base,), elevation_deg=24.0)


def _dies(scene: bpy.types.Scene, size: tuple[float, float], gap: float) -> bpy.types.Object:
    """Those that are whole, each with its blocks as fine steps."""
    vertices, faces = [], []

    def block(x0: float, y0: float, x1: float, y1: float, z: float) -> None:
        start, e = len(vertices), 0.003
        vertices.extend([(x0, y0, 0.0), (x1, y0, 0.0), (x1, y1, 0.0), (x0, y1, 0.0)])
        vertices.extend(
            [(x0 + e, y0 + e, z), (x1 - e, y0 + e, z), (x1 - e, y1 - e, z), (x0 + e, y1 - e, z)]
        )
        faces.append([start + 4, start + 5, start + 6, start + 7])
        for i in range(4):
            j = (i + 1) % 4
            faces.append([start + i, start + j, start + 4 + j, start + 4 + i])

    width, height = size
    for column in range(-6, 7):
        for row in range(-7, 8):
            x, y = (column - 0.5) * width, (row - 0.5) * height
            reach = max(math.hypot(x + dx, y + dy) for dx in (0.0, width) for dy in (0.0, height))
            if reach > 0.985 or y < -_FLAT + 0.03:
                continue
            x0, y0, w, h = x + 0.5 * gap, y + 0.5 * gap, width - gap, height - gap
            block(x0, y0, x0 + w, y0 + h, 0.004)
            for bx, by, bw, bh in (
                (0.06, 0.08, 0.4, 0.36),
                (0.54, 0.08, 0.4, 0.16),
                (0.54, 0.32, 0.4, 0.12),
                (0.06, 0.54, 0.88, 0.38),
            ):
                block(x0 + bx * w, y0 + by * h, x0 + (bx + bw) * w, y0 + (by + bh) * h, 0.0075)
    dies = mesh(scene, "Dies", vertices, faces, smooth=False)
    flat_uvs(dies)
    return dies


def wafers(scene: bpy.types.Scene) -> Portrayed:
    """Three bare ones in a rack."""
    made = []
    for k in range(3):
        bare = plate(
            scene,
            "Wafer",
            _wafer_outline(0.92),
            [(0.008, -0.012), (0.0, -0.006), (0.0, 0.006), (0.008, 0.012)],
            sharp_deg=30.0,
        )
        bare.matrix_basis = (
            Matrix.Translation((0.3 * (k - 1), 0.34 * (k - 1), 0.0))
            @ Matrix.Rotation(math.radians(58.0), 4, "X")
            @ Matrix.Translation((0.0, 0.92 * _FLAT, 0.0))
        )
        made.append(bare)
    black = plain("Rack", (0.015, 0.015, 0.017), roughness=0.4)
    rails = []
    for x in (-0.42, 0.42):
        rail = plate(
            scene,
            "Rail",
            [(x - 0.05, -0.6), (x + 0.05, -0.6), (x + 0.05, 0.75), (x - 0.05, 0.75)],
            [(0.0, -0.1), (0.0, 0.0), (0.01, 0.01)],
        )
        rail.data.materials.append(black)
        rails.append(rail)
    pose([*made, *rails], turn_deg=-16.0)
    return Portrayed(tuple(made), tuple(rails), elevation_deg=22.0)


def cell(scene: bpy.types.Scene) -> Portrayed:
    """A solar cell with its fingers and busbars."""
    cut, half = 0.16, 0.95
    corners = [(half - cut, -half), (half, -half + cut), (half, half - cut), (half - cut, half)]
    corners += [
        (-half + cut, half),
        (-half, half - cut),
        (-half, -half + cut),
        (-half + cut, -half),
    ]
    silicon = plate(
        scene, "Cell", corners, [(0.004, -0.012), (0.0, -0.008), (0.0, -0.004), (0.004, 0.0)]
    )
    silver = plain("Silver", (0.22, 0.22, 0.23), roughness=0.35, metallic=1.0)
    vertices, faces = [], []

    def bar(x0: float, y0: float, x1: float, y1: float, z: float) -> None:
        start = len(vertices)
        vertices.extend([(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)])
        faces.append([start, start + 1, start + 2, start + 3])

    for i in range(40):
        y = -0.9 + 1.8 * i / 39
        reach = half - 0.04 - max(0.0, abs(y) - (half - cut))
        bar(-reach, y - 0.0035, reach, y + 0.0035, 0.0015)
    for x in (-0.58, 0.0, 0.58):
        bar(x - 0.026, -0.92, x + 0.026, 0.92, 0.003)
    lines = mesh(scene, "Busbars", vertices, faces, smooth=False)
    lines.data.materials.append(silver)
    pose([silicon, lines], lean_deg=55.0, turn_deg=-16.0)
    return Portrayed((silicon,), (lines,), elevation_deg=24.0)
