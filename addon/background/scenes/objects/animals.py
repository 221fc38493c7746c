# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Feathers, fish and shells."""

from __future__ import annotations

import math

import bpy

from ..shape import ellipsoid, flat_uvs, mesh, plain, sheet, spline, tube
from .portrayed import Portrayed, pose


def feather(scene: bpy.types.Scene) -> Portrayed:
    """Its shaft along x, barbs on either side."""
    shaft = spline(
        [
            (-1.25, 0.0, 0.1),
            (-0.8, 0.0, 0.02),
            (0.0, 0.05, 0.0),
            (0.7, 0.04, 0.07),
            (1.2, -0.02, 0.2),
        ],
        60,
    )
    vertices, faces, uvs = [], [], []
    for side in (1.0, -1.0):
        _barbs(shaft, side, vertices, faces, uvs)
    vane = mesh(scene, "Vane", vertices, faces, uvs=uvs)
    quill = tube(scene, "Shaft", shaft[::6], lambda v: 0.03 * (1.0 - v) + 0.004, segments=12)
    quill.data.materials.append(plain("Shaft", (0.22, 0.17, 0.12), roughness=0.4))
    pose([vane, quill], lean_deg=48.0, roll_deg=-44.0, turn_deg=-4.0)
    return Portrayed((vane,), (quill,), elevation_deg=20.0, fill=0.92)


def _barbs(shaft, side: float, vertices, faces, uvs) -> None:
    """Strips that lean towards the tip, each a little over the next, with some gaps in the vane."""
    first, last = 62, len(shaft) - 2
    steps = 10
    for k in range(first, last):
        t = (k - first) / (last - first)
        x0, y0, z0 = shaft[k]
        length = (0.8 if side > 0.0 else 0.62) * math.sin(
            math.pi * min(0.08 + 0.97 * t**0.85, 1.0)
        ) ** 0.6
        length *= 1.0 + 0.03 * math.sin(12.9898 * k * side)
        split = 0.05 * math.sin(0.19 * k + side) ** 9
        angle = math.radians(58.0 - 26.0 * t) + split
        half = 0.0062
        start = len(vertices)
        for i in range(steps + 1):
            s = i / steps
            bend = angle - 0.5 * s * s
            x = x0 + length * s * math.cos(bend)
            y = y0 + side * length * s * math.sin(bend)
            z = z0 + 0.07 * math.sin(math.pi * 0.6 * s) - 0.09 * s * s + 0.003 * (k % 3)
            width = half * (1.0 - 0.55 * s**4)
            for edge in (-1.0, 1.0):
                vertices.append((x + edge * width, y, z - 0.0035 * edge))
        for i in range(steps):
            a = start + 2 * i
            quad = (a, a + 1, a + 3, a + 2) if side > 0.0 else (a + 1, a, a + 2, a + 3)
            faces.append(quad)
            uvs += [(t, 0.5 + 0.5 * side * ((corner - start) // 2) / steps) for corner in quad]


def pigeon(scene: bpy.types.Scene) -> Portrayed:
    """Head and neck; the feathers of the neck, rounded and laid like tiles, take the material."""
    vertices, faces, uvs = [], [], []
    rows = 20
    for row in range(rows):
        v = row / (rows - 1)
        count = round(34 - 8 * v)
        for k in range(count):
            jitter = 0.12 * math.sin(37.7 * row + 91.3 * k)
            _tile((k + 0.5 * (row % 2) + jitter) / count, v, count, vertices, faces, uvs)
    coat = mesh(scene, "Plumage", vertices, faces, uvs=uvs)
    props = [
        sheet(scene, "Skin", lambda u, v: _neck(u, 0.88 * v, -0.02), 64, 48),
        *_pigeon_head(scene),
    ]
    props[0].data.materials.append(plain("Down", (0.03, 0.03, 0.035), roughness=0.8))
    pose([coat, *props], turn_deg=58.0)
    return Portrayed((coat,), tuple(props), elevation_deg=12.0, fill=0.88)


def _pigeon_head(scene: bpy.types.Scene):
    """Looks towards -y."""
    grey = plain("Head", (0.13, 0.15, 0.19), roughness=0.7)
    horn = plain("Beak", (0.05, 0.045, 0.045), roughness=0.4)
    parts = [(ellipsoid(scene, "Head", (0.0, -0.32, 1.79), (0.3, 0.39, 0.31)), grey)]
    beak = spline(
        [(0.0, -0.62, 1.74), (0.0, -0.8, 1.72), (0.0, -0.93, 1.66), (0.0, -0.97, 1.61)], 8
    )
    parts.append(
        (tube(scene, "Beak", beak, lambda v: 0.085 * (1.0 - v) ** 0.7 + 0.008, segments=20), horn)
    )
    cere = plain("Cere", (0.65, 0.63, 0.6), roughness=0.6)
    iris, pupil = (
        plain("Iris", (0.7, 0.2, 0.03), roughness=0.15),
        plain("Pupil", (0.004, 0.004, 0.004), roughness=0.08),
    )
    for side in (-1.0, 1.0):
        parts.append(
            (ellipsoid(scene, "Cere", (0.045 * side, -0.71, 1.785), (0.05, 0.07, 0.045)), cere)
        )
        parts.append(
            (ellipsoid(scene, "Iris", (0.245 * side, -0.46, 1.83), (0.05, 0.068, 0.068)), iris)
        )
        parts.append(
            (ellipsoid(scene, "Pupil", (0.273 * side, -0.462, 1.832), (0.028, 0.038, 0.038)), pupil)
        )
    for part, material in parts:
        part.data.materials.append(material)
    return [part for part, _ in parts]


_NECK = spline(
    [
        (0.86, 0.0),
        (0.8, 0.32),
        (0.62, 0.74),
        (0.42, 1.14),
        (0.33, 1.46),
        (0.31, 1.66),
        (0.29, 1.84),
        (0.2, 2.0),
        (0.02, 2.05),
    ],
    80,
)


def _neck(u: float, v: float, lift: float):
    """From the breast, v = 0, up to the nape."""
    radius, z = _NECK[min(max(round(v * (len(_NECK) - 1)), 0), len(_NECK) - 1)]
    radius += lift
    a = math.tau * u
    return radius * math.cos(a), 0.95 * radius * math.sin(a) - 0.26 * (z / 2.0) ** 2, z


def _tile(u: float, v: float, count: int, vertices, faces, uvs) -> None:
    """One feather, hanging from (u, v) and standing off at its end."""
    across, along = 6, 6
    start = len(vertices)
    for j in range(along + 1):
        t = j / along
        for i in range(across + 1):
            s = 2.0 * i / across - 1.0
            width = (
                0.78
                * math.sqrt(max(1.0 - max(0.0, (t - 0.45) / 0.55) ** 2, 0.0))
                * (0.7 + 0.3 * min(3.0 * t, 1.0))
            )
            lift = 0.04 * t - 0.012 * s * s + 0.006
            down = 0.04 + 0.82 * v - 0.11 * t
            vertices.append(_neck(u + s * width / count, down, lift))
    for j in range(along):
        for i in range(across):
            quad = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
            faces.append([start + a + b * (across + 1) for a, b in quad])
            uvs += [(a / across, 1.0 - b / along) for a, b in quad]


def fish(scene: bpy.types.Scene) -> Portrayed:
    """A neon tetra: its stripe takes the material."""
    back = plain("Back", (0.05, 0.05, 0.03), roughness=0.3)
    silver = plain("Belly", (0.55, 0.55, 0.52), roughness=0.3, metallic=0.6)
    red = plain("Red", (0.55, 0.02, 0.015), roughness=0.3)
    # Around: from the back, 0, over the left side, 0.25, and the belly, 0.5.
    stripes, props = [], []
    for mirror in (False, True):
        for name, (u0, u1), (v0, v1), material in (
            ("Back", (0.0, 0.14), (0.0, 1.0), back),
            ("Stripe", (0.14, 0.265), (0.1, 0.9), None),
            ("Nose", (0.14, 0.265), (0.0, 0.1), back),
            ("Root", (0.14, 0.265), (0.9, 1.0), silver),
            ("Flank", (0.265, 0.5), (0.0, 0.5), silver),
            ("Tail Flank", (0.265, 0.5), (0.5, 1.0), red),
        ):
            part = _side(scene, name, (u0, u1), (v0, v1), mirror)
            if material is None:
                stripes.append(part)
            else:
                part.data.materials.append(material)
                props.append(part)
    props += _eyes(scene) + _fins(scene)
    pose([*stripes, *props], lean_deg=0.0, turn_deg=-16.0, roll_deg=-4.0)
    return Portrayed(tuple(stripes), tuple(props), elevation_deg=14.0, fill=0.9, floats=True)


def _side(scene, name: str, around, along, mirror: bool) -> bpy.types.Object:
    def place(u: float, v: float):
        u = 1.0 - u if mirror else u
        a = around[0] + (around[1] - around[0]) * u
        t = along[0] + (along[1] - along[0]) * v
        # The red reaches forward along the belly.
        t -= 0.8 * max(a - 0.265, 0.0) * (1.0 - abs(2.0 * t - 1.0))
        x, y, z = _fish_at(a, t)
        return x, (y if mirror else -y), z

    return sheet(scene, name, place, 16, round(10 + 50 * (along[1] - along[0])))


def _fish_at(u: float, v: float):
    """Head at -x."""
    high = (
        0.42 * math.sin(math.pi * min(v + 0.02, 1.0) ** 0.72) ** 0.8 * (1.0 - 0.45 * v)
        + 0.075 * v**2
    )
    high = max(high, 0.004) if v < 0.99 else 0.07
    wide = 0.5 * high * (1.0 - 0.5 * v)
    a = math.tau * u
    return (
        -1.1 + 1.85 * v,
        wide * math.sin(a),
        high * math.cos(a) * (1.0 + 0.12 * math.cos(a)) + 0.02 * v,
    )


def _eyes(scene: bpy.types.Scene):
    eyes = []
    for side in (-1.0, 1.0):
        white = ellipsoid(scene, "Eye", (-0.86, 0.075 * side, 0.06), (0.1, 0.045, 0.1))
        pupil = ellipsoid(scene, "Pupil", (-0.86, 0.1 * side, 0.06), (0.06, 0.03, 0.06))
        white.data.materials.append(plain("Iris", (0.4, 0.5, 0.55), roughness=0.2, metallic=0.5))
        pupil.data.materials.append(plain("Pupil", (0.004, 0.004, 0.004), roughness=0.1))
        eyes += [white, pupil]
    return eyes


def _fins(scene: bpy.types.Scene):
    """Fans of rays: root on the body, edge, and how many rays."""
    fins = (
        (((0.68, 0.1), (0.68, -0.05)), ((1.22, 0.42), (0.98, 0.03), (1.2, -0.38)), 18),
        (((-0.2, 0.3), (0.12, 0.26)), ((-0.02, 0.62), (0.2, 0.58), (0.3, 0.4)), 10),
        (((0.0, -0.24), (0.55, -0.12)), ((0.12, -0.56), (0.36, -0.42), (0.7, -0.3)), 14),
    )
    skin = plain("Fin", (0.36, 0.37, 0.36), roughness=0.3)
    made = []
    for (a, b), edge, rays in fins:
        outer = spline(edge, 12)

        def place(u: float, v: float, a=a, b=b, outer=outer, rays=rays):
            x, z = outer[round(u * (len(outer) - 1))]
            x0, z0 = a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1])
            ripple = 0.008 * math.cos(math.tau * rays * u) * v
            return x0 + v * (x - x0), ripple, z0 + v * (z - z0)

        fin = sheet(scene, "Fin", place, len(outer) - 1, 8)
        fin.data.materials.append(skin)
        made.append(fin)
    return made


def shell(scene: bpy.types.Scene) -> Portrayed:
    """An ammonite: a ribbed tube that grows as it winds."""
    turns, growth = 4.1, 2.25  # of the radius for each turn

    def place(u: float, v: float):
        angle = math.tau * turns * (v - 1.0)
        radius = 0.8 * growth ** (angle / math.tau)
        a = math.tau * u
        ribs = 1.0 + 0.055 * (0.5 + 0.5 * math.cos(24.0 * angle + 0.8 * math.cos(a) ** 2)) ** 2 * (
            1.0 - 0.3 * math.cos(a)
        )
        thick = 0.43 * radius * ribs
        out = radius + thick * math.cos(a) * 0.86
        return out * math.cos(angle), out * math.sin(angle), thick * 0.86 * math.sin(a)

    whorl = sheet(scene, "Ammonite", place, 56, 900)
    end = [place(i / 56, 1.0) for i in range(56)]
    middle = tuple(
        sum(p[axis] for p in end) / 56 - (0.06 if axis == 1 else 0.0) for axis in range(3)
    )
    mouth = mesh(scene, "Mouth", [*end, middle], [(i, (i + 1) % 56, 56) for i in range(56)])
    flat_uvs(mouth)
    pose([whorl, mouth], lean_deg=48.0, roll_deg=0.0, turn_deg=-12.0)
    return Portrayed((whorl, mouth), elevation_deg=24.0)
