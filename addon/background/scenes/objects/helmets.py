# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Helmets and their visors."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix

from ..shape import lathe, plain, sheet, sphere, tube
from .portrayed import Portrayed, pose


def visor(scene: bpy.types.Scene) -> Portrayed:
    """Of an astronaut's helmet."""
    shield, shell, props = _helmet(scene, 0.0)
    inside = sheet(scene, "Inside", lambda u, v: _face(u, v, 0.945, 0.02), 96, 64)
    inside.data.materials.append(plain("Inside", (0.01, 0.01, 0.01), roughness=0.6))
    shell.data.materials.append(plain("Helmet", (0.7, 0.7, 0.69), roughness=0.3))
    props += [shell, inside]
    pose([shield, *props], turn_deg=24.0)
    return Portrayed((shield,), tuple(props), elevation_deg=12.0)


def helmet(scene: bpy.types.Scene) -> Portrayed:
    """For a rider: its shell takes the material, its visor is dark."""
    shield, shell, props = _helmet(scene, -0.24)
    shield.data.materials.append(plain("Visor", (0.008, 0.008, 0.009), roughness=0.08))
    pose([shell, shield, *props], turn_deg=34.0)
    return Portrayed((shell,), (shield, *props), elevation_deg=16.0)


def _face(u: float, v: float, radius: float, grow: float):
    """The opening, rounded, on a ball around (0, 0, 1.05)."""
    a, e = (2.0 * u - 1.0) * (1.12 + grow), (2.0 * v - 1.0) * (0.62 + grow)
    a *= 0.55 + 0.45 * math.cos(0.88 * (2.0 * v - 1.0) ** 2)
    e += 0.06
    x, y = math.sin(a) * math.cos(e), -math.cos(a) * math.cos(e)
    return radius * x, radius * y, 1.05 + radius * math.sin(e)


def _helmet(scene: bpy.types.Scene, grow: float):
    """Its visor and shell, and what belongs to every helmet."""
    grey = plain("Trim", (0.1, 0.1, 0.105), roughness=0.35)
    shield = sheet(scene, "Visor", lambda u, v: _face(u, v, 1.0, grow), 96, 64)
    shell = sphere(scene, "Helmet", (0.0, 0.0, 1.05), 0.93, rings=64)
    sides = ([(i / 40, 0.0) for i in range(40)], [(1.0, i / 30) for i in range(30)])
    half = [*sides[0], *sides[1]]
    edge = [
        _face(u, v, 1.0, grow + 0.02) for u, v in [*half, *((1.0 - u, 1.0 - v) for u, v in half)]
    ]
    trim = tube(scene, "Trim", edge, 0.045, segments=12, closed=True)
    section = ((0.62, 0.0), (0.78, 0.0), (0.82, 0.04), (0.82, 0.16), (0.74, 0.22), (0.62, 0.24))
    collar = lathe(scene, "Collar", section, segments=128)
    hinges = []
    for side in (1.0, -1.0):
        hinge = lathe(
            scene, "Hinge", ((0.2, 0.0), (0.2, 0.06), (0.17, 0.09), (0.0, 0.095)), segments=48
        )
        hinge.matrix_basis = Matrix.Translation((0.91 * side, 0.18, 1.05)) @ Matrix.Rotation(
            0.5 * math.pi * side, 4, "Y"
        )
        hinges.append(hinge)
    for part in (collar, *hinges):
        part.data.set_sharp_from_angle(angle=math.radians(42.0))
    for part in (trim, collar, *hinges):
        part.data.materials.append(grey)
    return shield, shell, [trim, collar, *hinges]
