# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A shop window: cloth and ceramics in measured colours, anodised titanium, three groups of light."""

from __future__ import annotations

import math
import sys

import bpy
from spectra import curtain, light_groups, measured, table_cloth
from staging import (
    camera,
    lamp,
    lathe,
    new_scene,
    plain_material,
    save,
    thickness_field,
    wave_material,
)

TABLE = 1.0


def turned(name: str, points, *, wall: float = 0.03, steps: int = 12):
    """A vessel: a smooth curve through `points`, radius and height, outside and back inside."""
    outside = smooth(points, steps)
    inside = [(max(r - wall, 0.0), max(z, wall)) for r, z in reversed(outside)]
    return lathe(name, [(0.0, 0.0), *outside, *inside, (0.0, wall)], segments=160)


def smooth(points, steps: int):
    """Catmull and Rom."""
    padded = [points[0], *points, points[-1]]
    found = []
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:], strict=False):
        for i in range(steps):
            t = i / steps
            found.append(tuple(spline(*values, t) for values in zip(a, b, c, d, strict=True)))
    return [*found, points[-1]]


def spline(a: float, b: float, c: float, d: float, t: float) -> float:
    return 0.5 * (
        2.0 * b
        + (c - a) * t
        + (2.0 * a - 5.0 * b + 4.0 * c - d) * t**2
        + (3.0 * b - a - 3.0 * c + d) * t**3
    )


def vessels() -> None:
    tall = turned(
        "Vase",
        [
            (0.16, 0.0),
            (0.25, 0.18),
            (0.3, 0.45),
            (0.2, 0.8),
            (0.085, 1.02),
            (0.09, 1.2),
            (0.13, 1.27),
        ],
    )
    tall.location = (-0.42, 0.15, TABLE)
    tall.data.materials.append(measured("Yellow Glaze", "cqs/VS4", roughness=0.12))
    bowl = turned("Bowl", [(0.14, 0.0), (0.16, 0.05), (0.3, 0.14), (0.42, 0.32), (0.44, 0.36)])
    bowl.location = (-0.02, -0.48, TABLE)
    bowl.data.materials.append(measured("Turquoise Glaze", "cqs/VS9", roughness=0.12))
    jug = turned(
        "Jar", [(0.12, 0.0), (0.2, 0.1), (0.23, 0.25), (0.15, 0.4), (0.12, 0.45), (0.14, 0.5)]
    )
    jug.location = (0.08, 0.42, TABLE)
    jug.data.materials.append(measured("Lilac Glaze", "cqs/VS13", roughness=0.12))
    titanium = turned(
        "Titanium", [(0.13, 0.0), (0.3, 0.12), (0.36, 0.3), (0.27, 0.5), (0.19, 0.62), (0.25, 0.74)]
    )
    titanium.location = (0.5, 0.0, TABLE)
    node = wave_material(titanium, "anodised_titanium", roughness=0.12)
    thickness_field(
        titanium, node, low_nm=22.0, high_nm=150.0, axis="Z", swirl=0.06, swirl_scale=2.0
    )


def cloths() -> None:
    cloth = table_cloth(0.95, TABLE, folds=17, flare=0.16)
    cloth.data.materials.append(measured("Crimson Cloth", "cqs/VS1", roughness=0.9, weave=160.0))
    behind = curtain(7.0, 4.5, pleats=22.0, depth=0.09)
    behind.location = (0.0, 1.7, 0.0)
    behind.data.materials.append(
        measured("Blue Velvet", "colorchecker/blue", roughness=0.9, weave=120.0)
    )
    for number, key in enumerate(("cqs/VS7", "cqs/VS3", "cqs/VS14", "colorchecker/white-9-5")):
        bpy.ops.mesh.primitive_cube_add(location=(1.2, -0.75, 0.11 + 0.2 * number))
        towel = bpy.context.object
        towel.scale = (0.36, 0.27, 0.095)
        towel.rotation_euler.z = math.radians((12.0, 6.0, 15.0, 9.0)[number])
        bpy.ops.object.transform_apply(location=False, rotation=False)
        bevel = towel.modifiers.new("Bevel", "BEVEL")
        bevel.width, bevel.segments = 0.085, 8
        bpy.ops.object.shade_smooth()
        towel.data.materials.append(measured(f"Towel {number}", key, roughness=0.95, weave=60.0))


def room() -> None:
    bpy.ops.mesh.primitive_plane_add(size=16.0)
    bpy.context.object.data.materials.append(
        plain_material("Floor", (0.16, 0.16, 0.16), roughness=0.35)
    )


def main() -> None:
    scene = new_scene("interior", strength=0.12, turn_deg=150.0)
    scene.cycles.use_light_tree = False  # four lamps, each of them is wanted everywhere
    vessels()
    cloths()
    room()
    centre = (0.1, 0.0, 1.1)
    light_groups(
        Room=scene.world,
        Window=lamp((-4.2, -3.4, 2.6), centre, size=2.6, watts=330.0, name="Window"),
        Ceiling=lamp((0.6, -0.8, 4.6), (0.2, 0.2, 0.0), size=2.2, watts=120.0, name="Ceiling"),
        Display=lamp((2.4, -2.6, 3.6), (0.2, 0.0, 1.2), size=0.25, watts=90.0, name="Display"),
    )
    camera((0.22, -7.0, 1.85), (0.22, -0.2, 1.1), lens_mm=64.0, f_stop=1.4)
    save(sys.argv[1])


main()
