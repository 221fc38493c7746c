# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What scenes that are rendered in bands share: measured colours, light groups, cloth."""

from __future__ import annotations

import math
import tempfile
from pathlib import Path

import bpy
from staging import bump, mesh_object, plain_material, ring_faces


def measured(
    name: str, spectrum: object, *, roughness: float = 0.5, weave: float = 0.0
) -> bpy.types.Material:
    """A plain material whose colour is a reflectance: a key of the library, or one of its spectra.

    `weave`: how fine a cloth's threads are; 0 for what is no cloth.
    """
    material = plain_material(name, (0.5, 0.5, 0.5), roughness=roughness)
    if isinstance(spectrum, str):
        bpy.ops.nacre.give_reflectance(material=material.name, reflectance=spectrum)
    else:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "spectrum.csv")
            rows = zip(spectrum.wavelength_nm, spectrum.values, strict=True)
            lines = [f"wavelength_nm,{name}", *(f"{nm:g},{value:.9g}" for nm, value in rows)]
            file.write_text("\n".join(lines), "utf-8")
            bpy.ops.nacre.read_spectra(filepath=str(file), material=material.name)
    if weave > 0.0:
        shader = material.node_tree.nodes["Principled BSDF"]
        shader.inputs["Specular IOR Level"].default_value = 0.15
        bump(material, scale=weave, strength=0.35, distance_m=0.02)
    return material


def even_sky(strength: float) -> None:
    """White from everywhere, in place of the environment: D65 alone in bands, and no noise."""
    tree = bpy.context.scene.world.node_tree
    sky = tree.nodes["Background"]
    for link in list(sky.inputs["Color"].links):
        tree.links.remove(link)
    sky.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    sky.inputs["Strength"].default_value = strength


def light_groups(**members: bpy.types.Object | bpy.types.World) -> None:
    """Each lamp, or the world, in a group of its own."""
    for name, member in members.items():
        bpy.context.view_layer.lightgroups.add(name=name)
        member.lightgroup = name


def table_cloth(radius: float, height: float, *, folds: int, flare: float) -> bpy.types.Object:
    """Laid over a round table, down to the floor in folds."""
    segments, edge = 720, 0.05
    arc = [(radius + edge * math.sin(a), edge * (math.cos(a) - 1.0)) for a in _quarter(8)]
    down = [(radius + edge, -edge - (height - edge) * i / 60) for i in range(1, 61)]
    profile = [(radius * i / 12, 0.0) for i in range(1, 12)] + arc + down
    vertices = [(0.0, 0.0, height)]
    for r, drop in profile:
        share = max(0.0, -drop - 0.02) / height
        for step in range(segments):
            angle = math.tau * step / segments
            phase = folds * angle + 0.9 * math.sin(3.0 * angle + 0.4) + 0.5 * math.sin(5.0 * angle)
            wave = 0.5 + 0.5 * math.sin(phase)
            reach = r + flare * share**0.7 * (0.25 + wave**1.4 + 0.2 * math.sin(2.0 * angle))
            vertices.append((reach * math.cos(angle), reach * math.sin(angle), height + drop))
    return mesh_object("Table Cloth", vertices, ring_faces(len(profile), segments))


def curtain(width: float, height: float, *, pleats: float, depth: float) -> bpy.types.Object:
    """Hanging in pleats, along x, the front towards -y."""
    columns, rows = 900, 24
    vertices = []
    for row in range(rows + 1):
        z = height * row / rows
        for column in range(columns + 1):
            x = width * (column / columns - 0.5)
            phase = math.tau * pleats * column / columns
            phase += 0.9 * math.sin(0.31 * phase) + 0.15 * math.sin(1.7 * z + 0.23 * phase)
            swing = math.sin(phase) + 0.18 * math.sin(2.0 * phase + 0.6)
            vertices.append((x, -depth * swing * (1.0 - 0.25 * row / rows), z))
    wide = columns + 1
    faces = [
        (row * wide + i, row * wide + i + 1, (row + 1) * wide + i + 1, (row + 1) * wide + i)
        for row in range(rows)
        for i in range(columns)
    ]
    return mesh_object("Curtain", vertices, faces)


def _quarter(steps: int) -> list[float]:
    return [math.pi / 2.0 * i / steps for i in range(steps + 1)]
