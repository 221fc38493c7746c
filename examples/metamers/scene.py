# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A grey sofa and its cushions: one of them is of another cloth, which is the same grey in daylight."""

from __future__ import annotations

import math
import sys

import bpy
import numpy as np
from mathutils import Vector, noise
from spectra import even_sky, measured
from staging import camera, lamp, mesh_object, new_scene, plain_material, save

NM = np.arange(360.0, 831.0)
GREY = "colorchecker/neutral-6-5"
DYES_NM, DYES_WIDTH_NM, UNDYED = (470.0, 510.0, 650.0), 70.0, 0.03


def metamer():
    """Three bells upon a constant: as high as it takes to be the grey under D65."""
    import nacre

    shapes = nacre.shapes
    to_eye = nacre.colour_matching() * np.asarray(nacre.illuminant("D65"))[:, None]
    wanted = shapes.total(shapes.Scaled(GREY, 1.0), NM) - UNDYED
    bells = [shapes.Gaussian(nm, DYES_WIDTH_NM, 1.0) for nm in DYES_NM]
    alone = np.array([shapes.total(bell, NM) for bell in bells])
    heights = np.linalg.solve((alone @ to_eye).T, wanted @ to_eye)
    dyes = [bell._replace(peak=height) for bell, height in zip(bells, heights, strict=True)]
    return shapes.define(
        [shapes.Constant(UNDYED), *dyes], "reflectance", key="examples/grey", name="The Other Grey"
    )


def cushion(name: str, size: float, seed: float):
    """Two sheets that were sewn together and filled."""
    count, vertices, faces = 72, [], []
    for side in (1.0, -1.0):
        first = len(vertices)
        for row in range(count + 1):
            for column in range(count + 1):
                u, v = 2.0 * column / count - 1.0, 2.0 * row / count - 1.0
                filled = max(0.0, (1.0 - u * u) * (1.0 - v * v)) ** 0.42
                x = u * (1.0 - 0.07 * (1.0 - v * v))
                z = v * (1.0 - 0.07 * (1.0 - u * u))
                crease = noise.noise(Vector((2.1 * u + seed, 2.1 * v, seed + side)))
                y = side * 0.36 * filled * (1.0 + 0.18 * crease)
                vertices.append((0.5 * size * x, 0.5 * size * y, 0.5 * size * z))
        for row in range(count):
            for column in range(count):
                a = first + row * (count + 1) + column
                face = (a, a + 1, a + count + 2, a + count + 1)
                faces.append(face if side < 0.0 else face[::-1])
    return mesh_object(name, vertices, faces)


def upholstery(name: str, location, size, cloth, *, edge: float = 0.09) -> None:
    bpy.ops.mesh.primitive_cube_add(size=1.0, location=location)
    obj = bpy.context.object
    obj.name, obj.scale = name, size
    bpy.ops.object.transform_apply(location=False, rotation=False)
    bevel = obj.modifiers.new("Bevel", "BEVEL")
    bevel.width, bevel.segments = edge, 8
    bpy.ops.object.shade_smooth()
    obj.data.materials.append(cloth)


def main() -> None:
    new_scene("interior")
    even_sky(0.12)
    grey = measured("Grey Cloth", GREY, roughness=0.95, weave=90.0)
    other = measured("Other Grey Cloth", metamer(), roughness=0.95, weave=90.0)
    mustard = measured("Mustard Cloth", "cqs/VS4", roughness=0.95, weave=90.0)
    upholstery("Seat Left", (-0.76, 0.0, 0.42), (1.5, 1.0, 0.3), grey)
    upholstery("Seat Right", (0.76, 0.0, 0.42), (1.5, 1.0, 0.3), grey)
    upholstery("Base", (0.0, 0.02, 0.2), (3.0, 0.98, 0.2), grey, edge=0.04)
    upholstery("Back", (0.0, 0.58, 0.72), (3.4, 0.3, 0.95), grey, edge=0.12)
    for side in (-1.0, 1.0):
        upholstery("Arm", (1.66 * side, 0.05, 0.5), (0.3, 1.1, 0.75), grey, edge=0.12)
        leg = plain_material("Oak", (0.28, 0.14, 0.06), roughness=0.4)
        upholstery("Leg", (1.55 * side, -0.4, 0.05), (0.09, 0.09, 0.14), leg, edge=0.01)
    # What is alike stands alike: the lamps reach both in the same way.
    for name, cloth, x, turn, size in (
        ("Cushion Left", other, -0.62, 7.0, 0.78),
        ("Cushion Right", grey, 0.62, -7.0, 0.78),
        ("Cushion Middle", mustard, 0.04, 3.0, 0.52),
    ):
        obj = cushion(name, size, 3.1)
        obj.location = (x, 0.24 if size > 0.6 else 0.02, 0.56 + 0.48 * size)
        obj.rotation_euler = (math.radians(-16.0), math.radians(turn), 0.0)
        obj.data.materials.append(cloth)
    bpy.ops.mesh.primitive_plane_add(
        size=16.0, location=(0.0, 0.85, 0.0), rotation=(math.pi / 2, 0, 0)
    )
    wall = measured("Wall Paint", "colorchecker/blue-sky", roughness=0.8)
    bpy.context.object.data.materials.append(wall)
    bpy.ops.mesh.primitive_plane_add(size=16.0)
    floor = measured("Floor", "colorchecker/dark-skin", roughness=0.5)
    bpy.context.object.data.materials.append(floor)
    lamp((-0.35, -3.4, 4.0), (0.0, 0.0, 0.6), size=2.4, watts=400.0, name="Lamp")
    camera((0.0, -6.6, 1.55), (0.0, 0.1, 0.68), lens_mm=57.0, f_stop=2.8)
    save(sys.argv[1])


main()
