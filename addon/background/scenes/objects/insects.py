# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Beetles, wings and butterflies."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix

from ..shape import ellipsoid, flat_uvs, join, lathe, plain, principled, sheet, spline, tube
from .portrayed import Portrayed, pose


def beetle(scene: bpy.types.Scene) -> Portrayed:
    """Broad, as chafers are."""
    return _beetle(scene, long=1.25, wide=0.66, high=0.5, taper=2.6)


def jewel_beetle(scene: bpy.types.Scene) -> Portrayed:
    """Slender and pointed."""
    return _beetle(scene, long=1.5, wide=0.5, high=0.36, taper=1.7)


def _beetle(scene, long: float, wide: float, high: float, taper: float) -> Portrayed:
    """Its head towards -y, the seam between the elytra on y."""
    wings = [_elytron(scene, side, long, wide, high, taper) for side in (-1.0, 1.0)]
    shield = sheet(scene, "Pronotum", lambda u, v: _pronotum(u, v, wide, high), 48, 40)
    scutellum = sheet(scene, "Scutellum", lambda u, v: _scutellum(u, v, wide, high), 16, 12)
    head = ellipsoid(scene, "Head", (0.0, -0.64, 0.12), (0.46 * wide, 0.19, 0.3 * high))
    dark = plain("Horn", (0.012, 0.012, 0.013), roughness=0.25)
    props = []
    for side in (-1.0, 1.0):
        eye = ellipsoid(scene, "Eye", (0.4 * side * wide, -0.66, 0.17), (0.06, 0.08, 0.075))
        feeler = [
            (0.2 * side * wide, -0.78, 0.14),
            (0.4 * side * wide, -0.94, 0.2),
            (0.75 * side * wide, -0.96, 0.16),
        ]
        props += [eye, tube(scene, "Feeler", spline(feeler, 8), 0.018, segments=8)]
        for reach, foot in ((-0.5, -0.98), (-0.05, 0.05), (0.3, 0.85)):
            leg = [(0.5 * side * wide, reach, 0.05), (1.16 * side * wide, 0.5 * (reach + foot), 0.1),
                   (1.3 * side * wide, 0.2 * reach + 0.8 * foot, -0.13),
                   (1.45 * side * wide, foot, -0.16)]  # fmt: skip
            props.append(
                tube(scene, "Leg", spline(leg, 8), lambda v: 0.045 - 0.028 * v, segments=10)
            )
    belly = ellipsoid(scene, "Belly", (0.0, 0.2, 0.02), (0.9 * wide, 0.5 * long, 0.16))
    props.append(belly)
    for part in props:
        part.data.materials.append(dark)
    armour = join((*wings, shield, scutellum, head))
    pose([armour, *props], turn_deg=-38.0)
    return Portrayed((armour,), tuple(props), elevation_deg=44.0, fill=0.92, light_turn_deg=180.0)


def _elytron(scene, side: float, long: float, wide: float, high: float, taper: float):
    """From the seam, u = 0, to the margin; v from the shoulders to the tip."""

    def place(u: float, v: float):
        u = 1.0 - u if side < 0.0 else u
        width = (
            wide
            * (1.0 - v**taper) ** (1.0 / taper)
            * (0.9 + 0.1 * math.sin(math.pi * min(1.6 * v, 1.0)))
        )
        height = high * math.sqrt(max(1.0 - (abs(v - 0.35) / 0.66) ** 2.2, 0.0))
        shoulder = math.sqrt(1.0 - (1.0 - min(v / 0.07, 1.0)) ** 2)
        width, height = width * (0.86 + 0.14 * shoulder), height * (0.6 + 0.4 * shoulder)
        a = math.radians(104.0) * u
        fade = min(1.0, 14.0 * u, 9.0 * (1.0 - u)) * min(1.0, 9.0 * v, 4.0 * (1.0 - v))
        stria = 1.0 - 0.013 * fade * (0.5 + 0.5 * math.cos(math.tau * 9.0 * u)) ** 3
        seam = 0.035 * math.exp(-u / 0.035)
        x = side * (0.006 + width * math.sin(a) * stria)
        return x, -0.32 + long * v, height * (math.cos(a) * stria - seam) + 0.02

    return sheet(scene, "Elytron", place, 108, 90)


def _pronotum(u: float, v: float, wide: float, high: float):
    """A shield, narrower in front, which bulges over its hind edge."""
    a = math.radians(104.0) * (2.0 * u - 1.0)
    round_ends = math.sqrt(max(1.0 - (2.0 * v - 1.0) ** 6, 0.0))
    width = wide * (0.55 + 0.4 * v**0.8) * (0.8 + 0.2 * round_ends)
    height = high * (0.56 + 0.34 * v) * (0.25 + 0.75 * round_ends)
    lobe = 0.06 * v * (1.0 - abs(2.0 * u - 1.0)) ** 2
    return width * math.sin(a), -0.7 + 0.4 * v + lobe, height * math.cos(a) + 0.02


def _scutellum(u: float, v: float, wide: float, high: float):
    """The triangle between pronotum and elytra."""
    x = 0.26 * wide * (2.0 * u - 1.0) * (1.0 - v) ** 0.8
    dome = 0.035 * (1.0 - (2.0 * u - 1.0) ** 2) * (1.0 - v)
    return x, -0.3 + 0.2 * v, high * (0.88 + 0.07 * v) + dome


Outline = list[tuple[float, float]]


def wing(scene: bpy.types.Scene) -> Portrayed:
    """Long, and stalked, with many cross veins: a damselfly's."""
    lead = [(0.0, 0.03), (0.5, 0.12), (1.1, 0.22), (1.7, 0.24), (2.08, 0.15), (2.2, 0.06)]
    trail = [(0.0, -0.02), (0.45, -0.09), (0.95, -0.28), (1.5, -0.38), (1.95, -0.28), (2.17, -0.1)]
    membranes, props = [], []
    for fold in (15.0, -13.0):
        film, veins = _wing(scene, lead, trail, lengthwise=6, across=15, fold_deg=fold)
        membranes.append(film)
        props += veins
    pose([*membranes, *props], lean_deg=40.0, roll_deg=-36.0, turn_deg=-6.0)
    return Portrayed(tuple(membranes), tuple(props), elevation_deg=20.0, fill=0.92)


def fly_wing(scene: bpy.types.Scene) -> Portrayed:
    """Short and broad, with few veins."""
    lead = [(0.0, 0.05), (0.3, 0.2), (0.8, 0.37), (1.3, 0.38), (1.66, 0.27), (1.86, 0.1)]
    trail = [(0.0, -0.05), (0.1, -0.34), (0.52, -0.52), (1.08, -0.56), (1.5, -0.42), (1.78, -0.2)]
    film, veins = _wing(scene, lead, trail, lengthwise=5, across=3, fold_deg=0.0)
    pose([film, *veins], lean_deg=44.0, roll_deg=-30.0)
    return Portrayed((film,), tuple(veins), elevation_deg=20.0, fill=0.92)


def _wing(scene, lead: Outline, trail: Outline, lengthwise: int, across: int, fold_deg: float):
    """A membrane with the veins that hold it; folded around z at its root."""
    place = _membrane(spline(lead, 24), spline(trail, 24))
    film = sheet(scene, "Membrane", place, 120, 32)
    flat_uvs(film)
    veins = []
    for k in range(lengthwise + 1):
        v = k / lengthwise
        thick = 0.014 if k == lengthwise else 0.007
        path = [place(i / 48, v) for i in range(49)]
        veins.append(tube(scene, "Vein", path, lambda t, r=thick: r * (1.0 - 0.75 * t), segments=6))
    tip = [place(1.0, i / 12) for i in range(13)]
    veins.append(tube(scene, "Vein", tip, 0.0045, segments=6))
    for k in range(across):
        u = 0.16 + 0.76 * (k + 0.5) / across
        for cell in range(lengthwise):
            shift = 0.4 / across * math.sin(12.9 * k + 7.7 * cell)
            if across < 10 and (k + cell) % 3:
                continue
            path = [place(u + shift, (cell + t) / lengthwise) for t in (0.0, 0.5, 1.0)]
            veins.append(tube(scene, "Vein", path, 0.0038, segments=6))
    brown = plain("Vein", (0.03, 0.018, 0.01), roughness=0.4)
    fold = Matrix.Rotation(math.radians(fold_deg), 4, "Z")
    for part in (film, *veins):
        part.matrix_basis = fold
    for vein in veins:
        vein.data.materials.append(brown)
    return film, veins


def _membrane(lead: Outline, trail: Outline):
    """Between two edges, gently corrugated from vein to vein."""
    last = len(lead) - 1
    length = lead[-1][0]

    def place(u: float, v: float):
        i = min(int(u * last), last - 1)
        t = u * last - i
        (x0, y0), (x1, y1) = (
            [a + t * (b - a) for a, b in zip(edge[i], edge[i + 1], strict=True)]
            for edge in (trail, lead)
        )
        x, y = x0 + v * (x1 - x0), y0 + v * (y1 - y0)
        z = 0.006 * math.sin(3.0 * math.tau * v) * math.sin(math.pi * u)
        return x, y, z - 0.12 * (x / length - 0.5) ** 2 + 0.1 * (v - 0.5) ** 2

    return place


def butterfly(scene: bpy.types.Scene) -> Portrayed:
    """Wings half raised, with black margins."""
    fore = [
        (0.06, 0.06),
        (0.35, 0.52),
        (0.8, 0.95),
        (1.12, 1.06),
        (1.2, 0.9),
        (1.1, 0.55),
        (0.98, 0.2),
        (0.6, -0.02),
        (0.06, -0.04),
    ]
    hind = [
        (0.06, -0.02),
        (0.5, 0.06),
        (0.9, 0.04),
        (1.0, -0.3),
        (0.92, -0.62),
        (0.62, -0.88),
        (0.36, -0.86),
        (0.2, -0.6),
        (0.06, -0.2),
    ]
    black = plain("Margin", (0.006, 0.005, 0.005), roughness=0.9)
    principled(black).inputs["Specular IOR Level"].default_value = 0.1
    wings, props = [], []
    for side in (1.0, -1.0):
        for outline, lift, hub in ((fore, 0.02, (0.62, 0.5)), (hind, 0.0, (0.52, -0.3))):
            blue, margin = _scaled_wing(scene, outline, hub, side, lift)
            wings.append(blue)
            props.append(margin)
            props += _wing_veins(scene, outline, side, lift)
    props += _butterfly_body(scene)
    for part in props:
        part.data.materials.append(black)
    scales = join(wings)
    flat_uvs(scales)
    pose([scales, *props], lean_deg=42.0, turn_deg=-14.0)
    return Portrayed((scales,), tuple(props), elevation_deg=22.0, fill=0.9)


def _raised(x: float, y: float, side: float, lift: float):
    """The wing's plane raised from the body, bent a little."""
    z = 0.34 * x + 0.1 * math.sin(2.4 * x) * math.cos(1.3 * y) + 0.02 * math.sin(9.0 * y + 3.0 * x)
    return side * x, y, z + lift


def _scaled_wing(scene, outline: Outline, hub, side: float, lift: float):
    """The part with scales, and its dark margin."""
    edge = spline(outline, 12, closed=True)
    edge.append(edge[0])
    last = len(edge) - 1

    def ring(low: float, high: float):
        def place(u: float, v: float):
            x, y = edge[round((u if side > 0.0 else 1.0 - u) * last)]
            t = low + (high - low) * v
            # Narrow near the root.
            near = max(0.0, 1.0 - math.hypot(x - 0.06, y) / 0.7)
            t += near * (1.0 - t) * t**4
            return _raised(hub[0] + t * (x - hub[0]), hub[1] + t * (y - hub[1]), side, lift)

        return place

    blue = sheet(scene, "Scales", ring(0.0, 0.86), last, 20)
    margin = sheet(scene, "Margin", ring(0.86, 1.0), last, 4)
    return blue, margin


def _wing_veins(scene, outline: Outline, side: float, lift: float):
    veins = []
    for x, y in outline[2:7]:
        start = (0.1, 0.0)
        path = []
        for i in range(17):
            t = i / 16
            bow = 0.06 * math.sin(math.pi * t)
            px, py = (
                start[0] + t * 0.95 * (x - start[0]),
                start[1] + t * 0.95 * (y - start[1]) + bow,
            )
            vx, vy, vz = _raised(px, py, side, lift)
            path.append((vx, vy, vz + 0.004))
        veins.append(tube(scene, "Vein", path, lambda v: 0.009 - 0.004 * v, segments=6))
    return veins


def _butterfly_body(scene: bpy.types.Scene):
    profile = [
        (0.0, -0.7),
        (0.04, -0.66),
        (0.06, -0.4),
        (0.05, -0.1),
        (0.085, 0.02),
        (0.09, 0.16),
        (0.055, 0.28),
        (0.07, 0.34),
        (0.05, 0.42),
        (0.0, 0.45),
    ]
    body = lathe(scene, "Body", [(0.0, -0.7), *spline(profile, 6)[1:-1], (0.0, 0.45)], segments=32)
    body.matrix_basis = Matrix.Translation((0.0, 0.0, 0.04)) @ Matrix.Rotation(-math.pi / 2, 4, "X")
    feelers = []
    for side in (-1.0, 1.0):
        path = [(0.03 * side, 0.42, 0.06), (0.16 * side, 0.72, 0.14), (0.32 * side, 0.98, 0.16)]
        feelers.append(tube(scene, "Feeler", spline(path, 8), _club, segments=8))
    return [body, *feelers]


def _club(v: float) -> float:
    """How thick a feeler is, which ends in a knob."""
    return 0.007 + 0.08 * max(v - 0.85, 0.0)
