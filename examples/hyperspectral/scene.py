# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Two pots: a plant, and one of plastic that is as green to the eye. Between them a grey ball."""

from __future__ import annotations

import math
import random
import sys

import bpy
from mathutils import Euler, Matrix, Vector
from spectra import even_sky, measured
from staging import camera, lamp, lathe, mesh_object, new_scene, plain_material, save

# A green leaf: little in blue and red, where chlorophyll absorbs, and the red edge at 700 nm.
LEAF = (
    *((360, 0.04), (400, 0.045), (450, 0.05), (500, 0.06), (525, 0.11), (550, 0.145)),
    *((570, 0.12), (600, 0.08), (640, 0.06), (672, 0.045), (685, 0.06), (700, 0.14)),
    *((715, 0.28), (730, 0.38), (750, 0.44), (780, 0.46), (830, 0.47)),
)


def leaf_spectrum():
    import nacre

    points = nacre.shapes.Points(*zip(*LEAF, strict=True), "smooth")
    return nacre.shapes.define([points], "reflectance", key="examples/leaf", name="Leaf")


def as_green(spectrum) -> tuple[float, float, float]:
    """The colour under D65, which *Make Spectral* gives a smooth spectrum."""
    import nacre

    return tuple(nacre.spectrum_to_colour(spectrum.wavelength_nm, spectrum.values).rgb)


def leaf(length: float, width: float, droop: float):
    """Points and faces of a blade that bends down towards its tip."""
    along, across = 24, 10
    vertices, faces = [], []
    for i in range(along + 1):
        t = i / along
        half = 0.5 * width * math.sin(math.pi * t**0.75) ** 0.9 + 0.004
        angle = droop * t
        x, z = length * t * math.cos(0.6 * angle), -length * t * math.sin(0.6 * angle)
        for j in range(across + 1):
            s = 2.0 * j / across - 1.0
            wave = 0.012 * math.sin(9.0 * t + 1.0) * s
            vertices.append(Vector((x, s * half, z + 0.28 * half * abs(s) ** 1.2 + wave)))
    for i in range(along):
        for j in range(across):
            a = i * (across + 1) + j
            faces.append((a, a + across + 1, a + across + 2, a + 1))
    return vertices, faces


def plant(name: str, x: float, material, seed: int) -> None:
    chance = random.Random(seed)
    vertices, faces = [], []
    for number in range(34):
        share = number / 33
        size = 0.68 - 0.24 * share + chance.uniform(-0.05, 0.05)
        blade, sides = leaf(size, 0.5 * size, chance.uniform(0.7, 1.3) * (1.2 - 0.7 * share))
        lean = math.radians(-12.0 - 55.0 * share + chance.uniform(-8.0, 8.0))
        turn = number * math.radians(137.5) + chance.uniform(-0.2, 0.2)
        place = Matrix.Translation(
            (0.03 * math.cos(turn), 0.03 * math.sin(turn), 0.62 + 0.55 * share)
        )
        place = place @ Euler((chance.uniform(-0.25, 0.25), lean, turn)).to_matrix().to_4x4()
        first = len(vertices)
        vertices += [place @ v for v in blade]
        faces += [tuple(first + i for i in side) for side in sides]
    obj = mesh_object(name, vertices, faces)
    obj.location.x = x
    obj.data.materials.append(material)
    bpy.ops.mesh.primitive_cylinder_add(radius=0.025, depth=0.8, location=(x, 0.0, 0.75))
    bpy.context.object.data.materials.append(material)


def pot(x: float) -> None:
    outside = [(0.0, 0.0), (0.25, 0.0), (0.27, 0.02), (0.34, 0.42), (0.375, 0.43), (0.385, 0.56)]
    inside = [(0.37, 0.575), (0.345, 0.565), (0.33, 0.5), (0.0, 0.5)]
    obj = lathe("Pot", outside + inside)
    obj.location.x = x
    obj.data.materials.append(measured("Terracotta", "colorchecker/orange", roughness=0.8))
    bpy.ops.mesh.primitive_cylinder_add(radius=0.335, depth=0.02, location=(x, 0.0, 0.51))
    soil = measured("Soil", "colorchecker/dark-skin", roughness=1.0)
    bpy.context.object.data.materials.append(soil)


def main() -> None:
    new_scene("interior")
    even_sky(0.2)
    spectrum = leaf_spectrum()
    alive = measured("Leaf", spectrum, roughness=0.55)
    plastic = plain_material("Plastic", as_green(spectrum), roughness=0.55)
    for x, name, material in ((-0.78, "Plant", alive), (0.78, "Plastic Plant", plastic)):
        pot(x)
        plant(name, x, material, 5)
    bpy.ops.mesh.primitive_uv_sphere_add(
        radius=0.2, segments=96, ring_count=64, location=(0.0, -0.45, 0.2)
    )
    bpy.ops.object.shade_smooth()
    grey = measured("Grey", "colorchecker/neutral-6-5", roughness=0.9)
    bpy.context.object.data.materials.append(grey)
    bpy.ops.mesh.primitive_plane_add(size=12.0)
    wood = plain_material("Table", (0.2, 0.11, 0.06), roughness=0.4)
    bpy.context.object.data.materials.append(wood)
    bpy.ops.mesh.primitive_plane_add(
        size=12.0, location=(0.0, 1.3, 0.0), rotation=(math.pi / 2.0, 0.0, 0.0)
    )
    wall = measured("Wall", "colorchecker/neutral-8", roughness=0.9)
    bpy.context.object.data.materials.append(wall)
    lamp((-3.6, -7.5, 5.4), (0.0, 0.0, 0.7), size=2.6, watts=1500.0, name="Lamp")
    camera((0.0, -6.6, 1.5), (0.0, 0.0, 0.8), lens_mm=78.0, f_stop=2.8)
    save(sys.argv[1])


main()
