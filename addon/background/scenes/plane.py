# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A puddle on wet asphalt at dusk, with a film that has spread unevenly."""

from __future__ import annotations

import math

import bpy

from .light import area_lamp, camera, environment
from .shape import mesh, plain, principled
from .stage import Stage, place_on
from .thickness import vary


def build(scene: bpy.types.Scene) -> Stage:
    environment(scene, "sunset", strength=2.6, turn_deg=90.0)
    area_lamp(scene, (0.0, 9.0, 7.5), (0.0, 0.0, 0.0), size=(26.0, 13.0), watts=1100.0)
    ground = mesh(scene, "Asphalt", _square(14.0), [(0, 1, 2, 3)], smooth=False)
    ground.data.materials.append(asphalt())
    vertices, faces = _puddle(0.004)
    uvs = [(0.5 + x / 4.0, 0.5 + y / 4.0) for x, y, _ in vertices]
    puddle = mesh(scene, "Puddle", vertices, faces, smooth=False, uvs=uvs)
    camera(scene, (0.0, -4.6, 3.4), (0.0, 0.05, 0.0), lens_mm=50.0)
    return Stage(scene, place_on(puddle), dress=_dress)


def _square(half: float):
    return [(-half, -half, 0.0), (half, -half, 0.0), (half, half, 0.0), (-half, half, 0.0)]


def _puddle(z: float, points: int = 360):
    """A round outline with a few slow waves in it."""
    vertices = []
    for i in range(points):
        a = math.tau * i / points
        r = 1.0 + 0.16 * math.sin(2 * a + 0.7) + 0.09 * math.sin(3 * a + 2.1)
        r += 0.05 * math.sin(5 * a + 0.4) + 0.018 * math.sin(11 * a) + 0.008 * math.sin(23 * a + 1)
        vertices.append((1.3 * r * math.cos(a), 1.2 * r * math.sin(a), z))
    return vertices, [tuple(range(points))]


def asphalt() -> bpy.types.Material:
    """Dark stones in bitumen; wet, so the hollows are smooth and the heights rough."""
    material = plain("Asphalt", (0.02, 0.02, 0.021), roughness=0.5)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    shader = principled(material)
    coordinates = nodes.new("ShaderNodeTexCoord")
    stones = nodes.new("ShaderNodeTexVoronoi")
    stones.inputs["Scale"].default_value = 34.0
    fine = nodes.new("ShaderNodeTexNoise")
    fine.inputs["Scale"].default_value = 90.0
    fine.inputs["Detail"].default_value = 6.0
    height = nodes.new("ShaderNodeMath")
    height.operation = "MULTIPLY_ADD"
    height.inputs[1].default_value = -0.9
    bump = nodes.new("ShaderNodeBump")
    bump.inputs["Strength"].default_value = 0.7
    bump.inputs["Distance"].default_value = 0.02
    for texture in (stones, fine):
        links.new(coordinates.outputs["Object"], texture.inputs["Vector"])
    links.new(stones.outputs["Distance"], height.inputs[0])
    links.new(fine.outputs[0], height.inputs[2])
    links.new(height.outputs[0], bump.inputs["Height"])
    links.new(bump.outputs["Normal"], shader.inputs["Normal"])
    rough = nodes.new("ShaderNodeMapRange")
    rough.inputs["To Min"].default_value = 0.28
    rough.inputs["To Max"].default_value = 0.75
    links.new(fine.outputs[0], rough.inputs["Value"])
    links.new(rough.outputs["Result"], shader.inputs["Roughness"])
    return material


def _dress(material: bpy.types.Material) -> None:
    vary(material, base=0.95, height=0.0, swirl=1.25, scale=0.62, stretch=(1.0, 1.35, 1.0))
