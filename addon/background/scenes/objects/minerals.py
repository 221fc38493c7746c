# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crystals, ores and cut stones."""

from __future__ import annotations

import math
import random

import bmesh
import bpy
from mathutils import Matrix, Vector

from ..gem import brilliant as round_brilliant
from ..shape import box_uvs, circle, flat_uvs, lathe, mesh, plain, tube
from .portrayed import FOR_CLEAR, Portrayed, pose


def brilliant(scene: bpy.types.Scene) -> Portrayed:
    """Table up, leaning on its pavilion."""
    stone = round_brilliant(scene)
    stone.scale = (2.0, 2.0, 2.0)
    flat_uvs(stone)
    pose([stone], lean_deg=14.0, turn_deg=10.0)
    return Portrayed((stone,), elevation_deg=30.0, light=FOR_CLEAR)


def cabochon(scene: bpy.types.Scene) -> Portrayed:
    """An oval stone in a silver setting."""
    steps = 48
    angles = [0.5 * math.pi * i / steps for i in range(steps)]
    profile = [
        (0.9, -0.06),
        *((0.9 * math.cos(a), 0.5 * math.sin(a) ** 0.9) for a in angles),
        (0.0, 0.5),
    ]
    stone = lathe(scene, "Cabochon", profile, segments=160)
    flat_uvs(stone)
    rail = (
        (0.84, -0.12),
        (0.99, -0.12),
        (1.0, -0.1),
        (0.985, 0.04),
        (0.955, 0.1),
        (0.93, 0.11),
        (0.9, 0.08),
    )
    setting = lathe(scene, "Bezel", [(0.0, -0.12), *rail], segments=160)
    setting.data.set_sharp_from_angle(angle=math.radians(50.0))
    beads = tube(
        scene, "Wire", circle(1.03, -0.08, 480),
        lambda v: 0.032 + 0.012 * math.cos(math.tau * 60 * v), segments=12, closed=True,
    )  # fmt: skip
    silver = plain("Silver", (0.62, 0.61, 0.6), roughness=0.28, metallic=1.0)
    for part in (setting, beads):
        part.data.materials.append(silver)
    for part in (stone, setting, beads):
        part.matrix_basis = Matrix.Diagonal((1.0, 0.76, 1.0, 1.0))
    pose([stone, setting, beads], lean_deg=40.0, roll_deg=-18.0, turn_deg=-10.0)
    return Portrayed((stone,), (setting, beads), elevation_deg=24.0)


def crystal(scene: bpy.types.Scene) -> Portrayed:
    """Bismuth: hopper cubes that have grown into each other."""
    shape = bmesh.new()
    dice = random.Random(4)
    for centre, size in (
        ((0.0, 0.0, 0.5), 1.0), ((0.62, -0.2, 0.32), 0.64), ((-0.6, -0.12, 0.36), 0.72),
        ((0.1, -0.56, 0.26), 0.52),
        ((-0.2, 0.1, 1.12), 0.56), ((0.34, -0.02, 1.02), 0.42), ((-0.5, -0.5, 0.2), 0.4),
        ((0.7, 0.3, 0.66), 0.46),
        ((0.55, -0.62, 0.15), 0.3), ((-0.84, 0.2, 0.2), 0.4), ((-0.12, -0.22, 1.3), 0.26),
        ((-0.42, 0.22, 0.95), 0.4),
    ):  # fmt: skip
        _hopper_cube(shape, Vector(centre), size, dice)
    cluster = mesh(scene, "Bismuth", [], [], smooth=False)
    bmesh.ops.recalc_face_normals(shape, faces=shape.faces)
    shape.to_mesh(cluster.data)
    shape.free()
    box_uvs(cluster)
    pose([cluster], turn_deg=36.0)
    return Portrayed((cluster,), elevation_deg=30.0)


def _hopper_cube(
    shape: bmesh.types.BMesh, centre: Vector, size: float, dice: random.Random
) -> None:
    """A cube whose faces go down in steps towards their middles."""
    steps = max(4, round(8 * size))
    for axis in range(3):
        for sign in (-1.0, 1.0):
            n = Vector([sign if i == axis else 0.0 for i in range(3)])
            a = Vector([1.0 if i == (axis + 1) % 3 else 0.0 for i in range(3)])
            b = n.cross(a)
            _terraces(shape, centre, size, steps, (a, b, n), dice)


def _terraces(shape, centre: Vector, size: float, steps: int, frame, dice: random.Random) -> None:
    a, b, n = frame
    half = 0.5 * size
    depth, off = 0.0, [0.0, 0.0]

    def ring(r: float, d: float):
        at = centre + (half - d) * n + off[0] * a + off[1] * b
        return [
            shape.verts.new(at + r * (x * a + y * b))
            for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]

    outer = ring(half, 0.0)
    r = half
    for _ in range(steps):
        step = half / (steps + 1) * dice.uniform(0.7, 1.25)
        if r - step < 0.22 * half:
            break
        r -= step
        inner = ring(r, depth)
        _walls(shape, outer, inner)
        depth += 0.3 * step * dice.uniform(0.7, 1.3)
        outer = ring(r, depth)
        _walls(shape, inner, outer)
        off[0] += dice.uniform(-0.3, 0.3) * step
        off[1] += dice.uniform(-0.3, 0.3) * step
    shape.faces.new(outer)


def _walls(shape, outer, inner) -> None:
    for i in range(4):
        j = (i + 1) % 4
        shape.faces.new((outer[i], outer[j], inner[j], inner[i]))


def ore(scene: bpy.types.Scene) -> Portrayed:
    """A lump with broken faces."""
    dice = random.Random(11)
    shape = bmesh.new()
    for centre, radii, count in (
        ((0.0, 0.0, 0.6), (1.0, 0.75, 0.72), 46), ((0.6, -0.22, 0.4), (0.5, 0.5, 0.5), 30),
        ((-0.5, -0.32, 0.38), (0.52, 0.45, 0.46), 30), ((0.05, -0.1, 1.06), (0.48, 0.42, 0.36), 26),
        ((-0.42, 0.1, 0.95), (0.4, 0.4, 0.4), 24), ((0.16, -0.56, 0.34), (0.36, 0.32, 0.36), 22),
    ):  # fmt: skip
        _lump(shape, Vector(centre), radii, count, dice)
    rock = mesh(scene, "Ore", [], [], smooth=False)
    shape.to_mesh(rock.data)
    shape.free()
    rock.data.shade_smooth()
    rock.data.set_sharp_from_angle(angle=math.radians(14.0))
    box_uvs(rock)
    pose([rock], turn_deg=8.0)
    return Portrayed((rock,), elevation_deg=22.0)


def _lump(shape, centre: Vector, radii, count: int, dice: random.Random) -> None:
    """The hull of scattered points, its edges broken."""
    lump = bmesh.new()
    for _ in range(count):
        direction = Vector([dice.gauss(0.0, 1.0) for _ in range(3)]).normalized()
        far = dice.uniform(0.88, 1.0)
        lump.verts.new([c + far * r * d for c, r, d in zip(centre, radii, direction, strict=True)])
    _harden(lump, flat_deg=11.0, edge=0.016, segments=2)
    _put_in(shape, lump)


def druse(scene: bpy.types.Scene) -> Portrayed:
    """Six-sided points that grow out of one base."""
    dice = random.Random(3)
    shape = bmesh.new()
    for k in range(26):
        a, out = 2.39996 * k, 0.82 * math.sqrt(k / 26)
        lean = 0.95 * out + dice.uniform(-0.12, 0.12)
        long = (1.75 - 1.15 * out) * dice.uniform(0.75, 1.1)
        wide = (0.27 - 0.1 * out) * dice.uniform(0.8, 1.15)
        matrix = (
            Matrix.Translation((0.75 * out * math.cos(a), 0.75 * out * math.sin(a), -0.1))
            @ Matrix.Rotation(a, 4, "Z")
            @ Matrix.Rotation(lean, 4, "Y")
            @ Matrix.Rotation(dice.uniform(0.0, 1.0), 4, "Z")
        )
        _point(shape, matrix, wide, long, dice)
    cluster = mesh(scene, "Druse", [], [], smooth=False)
    shape.to_mesh(cluster.data)
    shape.free()
    box_uvs(cluster)
    pose([cluster])
    return Portrayed((cluster,), elevation_deg=24.0)


def _point(shape, matrix: Matrix, wide: float, long: float, dice: random.Random) -> None:
    """A prism under a pyramid, whose faces are not all alike."""
    point = bmesh.new()
    tip = 0.9 * wide
    for i in range(6):
        c, s = math.cos(math.tau * i / 6), math.sin(math.tau * i / 6)
        r = wide * dice.uniform(0.85, 1.1)
        point.verts.new((r * c, r * s, 0.0))
        point.verts.new((0.92 * r * c, 0.92 * r * s, long - tip * dice.uniform(0.9, 1.3)))
    point.verts.new((dice.uniform(-0.1, 0.1) * wide, dice.uniform(-0.1, 0.1) * wide, long))
    _harden(point, flat_deg=2.0, edge=0.008, segments=1)
    point.transform(matrix)
    _put_in(shape, point)


def _harden(part: bmesh.types.BMesh, *, flat_deg: float, edge: float, segments: int) -> None:
    """The hull of its points; what is nearly flat is flat, and edges catch light."""
    bmesh.ops.convex_hull(part, input=part.verts)
    angle = math.radians(flat_deg)
    bmesh.ops.dissolve_limit(part, angle_limit=angle, verts=part.verts, edges=part.edges)
    bmesh.ops.bevel(
        part,
        geom=part.edges,
        offset=edge,
        segments=segments,
        profile=0.5,
        affect="EDGES",
        clamp_overlap=True,
    )
    bmesh.ops.recalc_face_normals(part, faces=part.faces)


def _put_in(shape: bmesh.types.BMesh, part: bmesh.types.BMesh) -> None:
    """The part is gone afterwards."""
    data = bpy.data.meshes.new("Part")
    part.to_mesh(data)
    part.free()
    shape.from_mesh(data)
    bpy.data.meshes.remove(data)


def faceted(scene: bpy.types.Scene) -> Portrayed:
    """A ball of cut glass."""
    rings, around = 9, 18
    profile = [(0.0, 0.1)]
    for i in range(rings):
        a = math.pi * (i + 0.75) / (rings + 0.5)
        profile.append((math.sin(a), 1.0 - math.cos(a)))
    profile += [(0.0, 1.94)]
    profile[0] = (0.0, profile[1][1])
    profile[-1] = (0.0, profile[-2][1])
    ball = lathe(scene, "Cut Glass", profile, segments=around, smooth=False)
    pose([ball], lean_deg=12.0, turn_deg=6.0)
    return Portrayed((ball,), elevation_deg=20.0, light=FOR_CLEAR)
