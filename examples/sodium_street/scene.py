# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A terrace in the rain at night: sodium lamps along the street, a tungsten lamp over one door."""

from __future__ import annotations

import sys

import bpy
from mathutils import Vector, noise
from spectra import measured
from staging import bump, camera, mesh_object, new_scene, plain_material, save

HOUSE = 3.4  # metres
DOORS = ("cqs/VS12", "cqs/VS9", "cqs/VS1", "cqs/VS7", "cqs/VS4", "cqs/VS14", "cqs/VS9")
FIRST = -1  # of them, the number of the house at x = 0 being 0
PAVEMENT, KERB = 0.12, -2.0
ORANGE, WARM = (1.0, 0.5, 0.05), (1.0, 0.7, 0.4)  # what the lamps would be in RGB
DOOR, WINDOW, UPPER = (0.3, 1.3, 0.12, 2.3), (1.85, 2.95, 0.95, 2.35), (1.85, 2.95, 3.3, 4.7)

_CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
_SIDES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def boxes(name: str, spans, material, *, bevel: float = 0.0) -> bpy.types.Object:
    """One object of boxes, each (x0, x1, y0, y1, z0, z1)."""
    vertices, faces = [], []
    for span in spans:
        first = len(vertices)
        low, high = span[0::2], span[1::2]
        vertices += [
            tuple(b if at else a for at, a, b in zip(c, low, high, strict=True)) for c in _CORNERS
        ]
        faces += [tuple(first + i for i in side) for side in _SIDES]
    obj = mesh_object(name, vertices, faces, smooth=False)
    obj.data.materials.append(material)
    if bevel > 0.0:
        added = obj.modifiers.new("Bevel", "BEVEL")
        added.width, added.segments = bevel, 3
    return obj


def walls() -> None:
    spans = []
    for house in range(FIRST, FIRST + len(DOORS)):
        x = HOUSE * house
        for a, b in ((0.0, 0.3), (1.3, 1.85), (2.95, HOUSE)):
            spans.append((x + a, x + b, 0.0, 0.3, 0.0, 6.5))
        spans.append((x + 0.3, x + 1.3, 0.0, 0.3, DOOR[3], 6.5))
        for low, high in ((0.0, WINDOW[2]), (WINDOW[3], UPPER[2]), (UPPER[3], 6.5)):
            spans.append((x + 1.85, x + 2.95, 0.0, 0.3, low, high))
    boxes("Wall", spans, bricks())


def bricks() -> bpy.types.Material:
    material = plain_material("Bricks", (0.3, 0.12, 0.07), roughness=0.75)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    place = nodes.new("ShaderNodeNewGeometry")
    parts, plane = nodes.new("ShaderNodeSeparateXYZ"), nodes.new("ShaderNodeCombineXYZ")
    links.new(place.outputs["Position"], parts.inputs[0])
    for axis, to in (("X", "X"), ("Z", "Y"), ("Y", "Z")):
        links.new(parts.outputs[axis], plane.inputs[to])
    brick = nodes.new("ShaderNodeTexBrick")
    links.new(plane.outputs[0], brick.inputs["Vector"])
    for name, value in (("Scale", 1.0), ("Mortar Size", 0.009), ("Mortar Smooth", 0.3)):
        brick.inputs[name].default_value = value
    brick.inputs["Brick Width"].default_value, brick.inputs["Row Height"].default_value = (
        0.23,
        0.075,
    )
    for name, colour in (
        ("Color1", (0.30, 0.105, 0.06, 1.0)),
        ("Color2", (0.17, 0.07, 0.05, 1.0)),
        ("Mortar", (0.22, 0.19, 0.16, 1.0)),
    ):
        brick.inputs[name].default_value = colour
    shader = nodes["Principled BSDF"]
    links.new(brick.outputs["Color"], shader.inputs["Base Color"])
    raised = nodes.new("ShaderNodeBump")
    raised.invert = True
    raised.inputs["Distance"].default_value = 0.012
    links.new(brick.outputs["Fac"], raised.inputs["Height"])
    links.new(raised.outputs["Normal"], shader.inputs["Normal"])
    return material


def frame(x: float, opening, width: float, depth: float, bars: int):
    left, right, low, high = x + opening[0], x + opening[1], opening[2], opening[3]
    y0, y1 = depth, depth + 0.07
    spans = [
        (left, left + width, y0, y1, low, high),
        (right - width, right, y0, y1, low, high),
        (left, right, y0, y1, high - width, high),
    ]
    for bar in range(bars):
        z = low + (high - low) * bar / bars
        spans.append((left, right, y0, y1, z, z + 0.6 * width))
    return spans


def openings() -> None:
    white = measured("White Paint", "colorchecker/white-9-5", roughness=0.35)
    stone = measured("Stone", "colorchecker/neutral-5", roughness=0.3)
    pane = plain_material("Pane", (0.01, 0.01, 0.012), roughness=0.03)
    spans, sills, panes = [], [], []
    for house in range(FIRST, FIRST + len(DOORS)):
        x = HOUSE * house
        spans += frame(x, DOOR, 0.07, 0.1, 0)
        spans.append((x + 0.3, x + 1.3, 0.1, 0.17, 1.98, 2.03))
        panes.append((x + 0.35, x + 1.25, 0.14, 0.15, 2.0, 2.3))
        for opening in (WINDOW, UPPER):
            spans += frame(x, opening, 0.06, 0.1, 2)
            sills.append((x + 1.78, x + 3.02, -0.07, 0.12, opening[2] - 0.09, opening[2]))
            sills.append((x + 1.75, x + 3.05, -0.012, 0.05, opening[3], opening[3] + 0.2))
            panes.append((x + 1.85, x + 2.95, 0.14, 0.15, opening[2], opening[3]))
        sills.append((x + 0.2, x + 1.4, -0.012, 0.05, DOOR[3], DOOR[3] + 0.2))
        sills.append((x + 0.2, x + 1.4, -0.35, 0.1, 0.0, PAVEMENT + 0.14))
    sills.append((HOUSE * FIRST, HOUSE * (FIRST + len(DOORS)), -0.04, 0.1, 2.82, 2.94))
    boxes("Frames", spans, white, bevel=0.006)
    boxes("Stone", sills, stone, bevel=0.012)
    boxes("Panes", panes, pane)


def doors() -> None:
    brass = plain_material("Brass", (0.8, 0.55, 0.2), roughness=0.2, metallic=1.0)
    for house, key in enumerate(DOORS, FIRST):
        x, low, high = HOUSE * house + 0.37, 0.26, 1.98
        spans = [(x, x + 0.86, 0.13, 0.17, low, high)]
        rails = ((0.0, 0.12), (0.37, 0.49), (0.74, 0.86))
        spans += [(x + a, x + b, 0.105, 0.14, low, high) for a, b in rails]
        heights = ((low, low + 0.2), (1.0, 1.15), (high - 0.13, high))
        spans += [(x + 0.004, x + 0.856, 0.108, 0.14, a, b) for a, b in heights]
        boxes(f"Door {house}", spans, measured(f"Door {house}", key, roughness=0.22), bevel=0.009)
        for dx, dz, size in ((0.8, 1.05, 0.035), (0.43, 1.42, 0.05)):
            bpy.ops.mesh.primitive_uv_sphere_add(radius=size, location=(x + dx, 0.08, dz))
            bpy.ops.object.shade_smooth()
            bpy.context.object.data.materials.append(brass)


def wet(name: str, colour, *, dry: float, scale: float) -> bpy.types.Material:
    """Stone under a film of water, which is deeper in places."""
    material = plain_material(name, colour, roughness=0.3)
    bump(material, scale=90.0, strength=0.22, distance_m=0.004)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    depth = nodes.new("ShaderNodeTexNoise")
    depth.inputs["Scale"].default_value = scale
    depth.inputs["Detail"].default_value = 5.0
    place = nodes.new("ShaderNodeNewGeometry")
    links.new(place.outputs["Position"], depth.inputs["Vector"])
    ramp = nodes.new("ShaderNodeMapRange")
    ramp.inputs["From Min"].default_value, ramp.inputs["From Max"].default_value = 0.42, 0.62
    ramp.inputs["To Min"].default_value, ramp.inputs["To Max"].default_value = dry, 0.03
    links.new(depth.outputs["Fac"], ramp.inputs["Value"])
    links.new(ramp.outputs["Result"], nodes["Principled BSDF"].inputs["Roughness"])
    return material


def ground() -> None:
    flags = wet("Flagstones", (0.13, 0.125, 0.12), dry=0.34, scale=0.9)
    spans, far = [], HOUSE * (FIRST + len(DOORS))
    x = HOUSE * FIRST
    while x < far:
        spans += [(x, x + 0.84, y, y + 0.59, -0.1, PAVEMENT) for y in (-1.8, -1.2, -0.6)]
        x += 0.85
    boxes("Flagstones", spans, flags, bevel=0.006)
    boxes("Kerb", [(HOUSE * FIRST, far, KERB, -1.81, -0.1, PAVEMENT + 0.005)], flags, bevel=0.02)
    bpy.ops.mesh.primitive_plane_add(size=80.0)
    asphalt = wet("Asphalt", (0.035, 0.035, 0.037), dry=0.3, scale=0.7)
    bpy.context.object.data.materials.append(asphalt)


def box_tree(x: float, seed: float) -> None:
    pot = measured("Terracotta", "colorchecker/dark-skin", roughness=0.6)
    leaves = measured("Leaves", "cqs/VS6", roughness=0.5)
    z = PAVEMENT
    bpy.ops.mesh.primitive_cone_add(
        radius1=0.13, radius2=0.18, depth=0.34, vertices=48, location=(x, -0.42, z + 0.17)
    )
    bpy.ops.object.shade_smooth_by_angle()
    bpy.context.object.data.materials.append(pot)
    bpy.ops.mesh.primitive_ico_sphere_add(
        subdivisions=6, radius=0.27, location=(x, -0.42, z + 0.55)
    )
    ball = bpy.context.object
    for vertex in ball.data.vertices:
        place = vertex.co.normalized()
        leaf = noise.noise(place * 14.0 + Vector((seed, 0.0, 0.0))) + noise.noise(place * 31.0)
        vertex.co *= 1.0 + 0.07 * leaf
    ball.data.materials.append(leaves)


def bulb(name: str, location, colour, *, radius: float, watts: float) -> None:
    data = bpy.data.lights.new(name, "POINT")
    data.energy, data.shadow_soft_size, data.color = watts, radius, colour
    obj = bpy.data.objects.new(name, data)
    obj.location = location
    bpy.context.scene.collection.objects.link(obj)


def lamps() -> None:
    iron = plain_material("Iron", (0.02, 0.02, 0.02), roughness=0.35)
    posts = []
    for number, x in enumerate((-4.5, 5.6, 14.6)):
        y = -1.72
        posts += [(x - 0.05, x + 0.05, y - 0.05, y + 0.05, 0.0, 4.3)]
        posts += [(x - 0.05, x + 0.05, y - 0.05, y + 0.85, 4.25, 4.33)]
        posts += [(x - 0.14, x + 0.14, y + 0.5, y + 1.0, 4.3, 4.36)]
        bulb(f"Sodium {number + 1}", (x, y + 0.75, 4.18), ORANGE, radius=0.09, watts=1490.0)
    # The lantern over the door is open below.
    posts += [(0.76, 0.84, -0.16, 0.0, 2.62, 2.65), (0.7, 0.9, -0.3, -0.1, 2.62, 2.66)]
    boxes("Iron", posts, iron, bevel=0.01)
    bulb("Porch", (0.8, -0.2, 2.56), WARM, radius=0.05, watts=228.0)


def main() -> None:
    new_scene("city", strength=0.0045)
    walls()
    openings()
    doors()
    ground()
    lamps()
    for x, seed in ((0.05, 1.0), (1.55, 5.0)):
        box_tree(x, seed)
    camera((-2.7, -3.9, 1.2), (2.2, -0.75, 1.42), lens_mm=27.0, f_stop=4.0)
    save(sys.argv[1])


main()
