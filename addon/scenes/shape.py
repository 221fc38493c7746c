# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and plain materials of the stages."""

from __future__ import annotations

import math
from collections.abc import Sequence

import bpy

from ..nodes.space import here

Point = tuple[float, float, float]


def mesh(
    scene: bpy.types.Scene,
    name: str,
    vertices: Sequence[Point],
    faces: Sequence[Sequence[int]],
    *,
    smooth: bool = True,
    uvs: Sequence[tuple[float, float]] = (),
) -> bpy.types.Object:
    """`uvs`: one for each corner of each face, in their order."""
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    if uvs:
        layer = data.uv_layers.new(name="UVMap")
        layer.data.foreach_set("uv", [x for uv in uvs for x in uv])
    data.validate()
    if smooth:
        data.shade_smooth()
    obj = bpy.data.objects.new(name, data)
    scene.collection.objects.link(obj)
    return obj


def lathe(
    scene: bpy.types.Scene,
    name: str,
    profile: Sequence[tuple[float, float]],
    *,
    segments: int = 160,
    smooth: bool = True,
) -> bpy.types.Object:
    """Turns `profile`, points (radius, z) from the bottom up with the outside to the right; u goes
    around, v along the profile."""
    angles = [math.tau * i / segments for i in range(segments)]
    circle = [(math.cos(angle), math.sin(angle)) for angle in angles]
    vertices: list[Point] = []
    firsts = []
    for radius, z in profile:
        firsts.append(len(vertices))
        vertices += [(radius * x, radius * y, z) for x, y in circle[: segments if radius else 1]]
    faces, uvs = [], []
    # The last step ends at u = 1, where the first begins at 0.
    around = [(i, (i + 1) % segments, i / segments, (i + 1) / segments) for i in range(segments)]
    last = len(profile) - 1
    for ring in range(last):
        low, high = firsts[ring], firsts[ring + 1]
        below, above = ring / last, (ring + 1) / last
        for i, j, u, next_u in around:
            if profile[ring][0] == 0.0:
                faces.append((low, high + j, high + i))
                uvs += ((u, below), (next_u, above), (u, above))
            elif profile[ring + 1][0] == 0.0:
                faces.append((low + i, low + j, high))
                uvs += ((u, below), (next_u, below), (next_u, above))
            else:
                faces.append((low + i, low + j, high + j, high + i))
                uvs += ((u, below), (next_u, below), (next_u, above), (u, above))
    return mesh(scene, name, vertices, faces, smooth=smooth, uvs=uvs)


def sphere(
    scene: bpy.types.Scene, name: str, centre: Point, radius: float, rings: int = 96
) -> bpy.types.Object:
    profile = [
        (radius * math.sin(math.pi * i / rings), -radius * math.cos(math.pi * i / rings))
        for i in range(1, rings)
    ]
    obj = lathe(scene, name, [(0.0, -radius), *profile, (0.0, radius)], segments=2 * rings)
    obj.location = centre
    return obj


def backdrop(
    scene: bpy.types.Scene, colour: Point, *, roughness: float = 0.5, depth: float = 5.0
) -> bpy.types.Object:
    """A floor at z = 0 that bends up into a wall behind the scene."""
    bend, height, half_width = 2.5, 9.0, 16.0
    profile = [(-10.0, 0.0), (depth - bend, 0.0)]
    for step in range(1, 24):
        angle = math.pi / 2.0 * step / 24
        profile.append((depth - bend + bend * math.sin(angle), bend - bend * math.cos(angle)))
    profile += [(depth, bend), (depth, height)]
    vertices = [(x, y, z) for y, z in profile for x in (-half_width, half_width)]
    faces = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(len(profile) - 1)]
    obj = mesh(scene, "Backdrop", vertices, faces)
    obj.data.materials.append(plain("Backdrop", colour, roughness=roughness))
    return obj


def plain(
    name: str, colour: Point, *, roughness: float = 0.5, metallic: float = 0.0
) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = principled(material)
    shader.inputs["Base Color"].default_value = (*here(colour), 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    return material


def principled(material: bpy.types.Material) -> bpy.types.Node:
    return next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")


def glow(name: str, colour: Point, strength: float) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = principled(material)
    shader.inputs["Base Color"].default_value = (0.0, 0.0, 0.0, 1.0)
    shader.inputs["Emission Color"].default_value = (*here(colour), 1.0)
    shader.inputs["Emission Strength"].default_value = strength
    return material
