# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Glass and ceramics: what is turned, blown and pressed."""

from __future__ import annotations

import math

import bpy

from ..shape import join, lathe, plain, sheet, sphere, spline, tube
from .portrayed import Portrayed, heated, pose

Profile = list[tuple[float, float]]


def _walled(outside: Profile, thick: float, floor: float) -> Profile:
    """A vessel's whole section: up its outside, over a round lip, down to its floor."""
    inside = [(r - thick, z) for r, z in reversed(outside) if z > floor]
    (r, z), steps = outside[-1], 6
    middle = r - 0.5 * thick
    turns = [math.pi * i / steps for i in range(1, steps)]
    lip = [(middle + 0.5 * thick * math.cos(a), z + 0.5 * thick * math.sin(a)) for a in turns]
    return [(0.0, outside[0][1]), *outside, *lip, *inside, (0.0, floor)]


def vase(scene: bpy.types.Scene) -> Portrayed:
    """Tall, with a narrow neck and a flared lip."""
    points = [
        (0.36, 0.0), (0.39, 0.03), (0.36, 0.1), (0.5, 0.32), (0.7, 0.68), (0.72, 0.95), (0.55, 1.28),
        (0.27, 1.58), (0.2, 1.82), (0.26, 2.03), (0.42, 2.18),
    ]  # fmt: skip
    body = lathe(scene, "Vase", _walled(spline(points, 8), 0.03, 0.1), segments=192)
    pose([body])
    return Portrayed((body,), elevation_deg=14.0)


def jar(scene: bpy.types.Scene) -> Portrayed:
    """Thrown by hand: squat, with the rings of the fingers, and a lid."""
    points = [
        (0.42, 0.0), (0.46, 0.02), (0.62, 0.22), (0.86, 0.6), (0.9, 0.9), (0.74, 1.18), (0.5, 1.3),
        (0.46, 1.38), (0.5, 1.44),
    ]  # fmt: skip
    thrown = [
        (r * (1.0 + 0.012 * math.sin(34.0 * z) * math.sin(2.2 * z)), z)
        for r, z in spline(points, 12)
    ]
    body = lathe(scene, "Jar", _walled(thrown, 0.05, 0.1), segments=192)
    lid_points = [
        (0.42, 1.42), (0.45, 1.45), (0.4, 1.5), (0.2, 1.56), (0.07, 1.6), (0.06, 1.65), (0.11, 1.72),
        (0.1, 1.79), (0.0, 1.82),
    ]  # fmt: skip
    lid = lathe(scene, "Lid", [(0.0, 1.42), *spline(lid_points, 6)[:-1], (0.0, 1.82)], segments=96)
    whole = join((body, lid))
    pose([whole])
    return Portrayed((whole,), elevation_deg=16.0)


def bowl(scene: bpy.types.Scene) -> Portrayed:
    """Pressed glass on a foot, fluted, with a crimped rim."""
    outside = spline(
        [
            (0.42, 0.0),
            (0.44, 0.05),
            (0.3, 0.14),
            (0.34, 0.22),
            (0.72, 0.42),
            (1.0, 0.72),
            (1.22, 0.96),
        ],
        10,
    )
    profile = _walled(outside, 0.045, 0.24)
    last = len(profile) - 1

    def place(u: float, v: float):
        radius, z = profile[round(v * last)]
        a = math.tau * u
        rise = min(max((z - 0.24) / 0.72, 0.0), 1.0)
        flute = 1.0 + 0.03 * min(rise * 3.0, 1.0) * abs(math.cos(10.0 * a)) - 0.02
        crimp = rise**3 * 0.085 * math.cos(10.0 * a)
        radius *= flute + 0.6 * crimp
        return radius * math.cos(a), radius * math.sin(a), z + crimp

    body = sheet(scene, "Bowl", place, 320, last)
    pose([body], turn_deg=9.0)
    return Portrayed((body,), elevation_deg=26.0)


def cup(scene: bpy.types.Scene) -> Portrayed:
    """A tea cup on its saucer."""
    outside = spline(
        [
            (0.28, 0.13),
            (0.3, 0.15),
            (0.28, 0.19),
            (0.42, 0.3),
            (0.6, 0.6),
            (0.66, 0.9),
            (0.72, 1.08),
        ],
        8,
    )
    body = lathe(scene, "Cup", _walled(outside, 0.028, 0.2), segments=160)
    dish = spline([(0.36, 0.0), (0.38, 0.02), (0.4, 0.05), (0.8, 0.12), (1.12, 0.23)], 8)
    saucer = lathe(scene, "Saucer", _walled(dish, 0.03, 0.07), segments=160)
    path = spline(
        [(0.6, 0.0, 0.92), (0.78, 0.0, 1.0), (0.95, 0.0, 0.86), (0.9, 0.0, 0.6), (0.7, 0.0, 0.46),
         (0.5, 0.0, 0.42)], 8,
    )  # fmt: skip
    handle = tube(
        scene, "Handle", path, lambda v: 0.042 + 0.012 * math.cos(math.tau * v), segments=16
    )
    whole = join((body, saucer, handle))
    pose([whole], turn_deg=-22.0)
    return Portrayed((whole,), elevation_deg=24.0)


def bauble(scene: bpy.types.Scene) -> Portrayed:
    """For a tree: a ball with its cap and loop."""
    steps = 96
    angles = [math.pi * i / steps for i in range(1, steps)]
    profile = [(0.95 * math.sin(a), 0.95 - 0.95 * math.cos(a)) for a in angles]
    ball = lathe(scene, "Bauble", [(0.0, 0.0), *profile, (0.0, 1.9)], segments=160)
    crimped = [(0.2, 1.83), (0.215, 1.87), (0.2, 2.02), (0.18, 2.05), (0.0, 2.055)]
    last = len(crimped) - 1

    def place(u: float, v: float):
        radius, z = crimped[round(v * last)]
        a = math.tau * u
        radius *= 1.0 + (0.05 * math.cos(18.0 * a) if z < 2.0 else 0.0)
        return radius * math.cos(a), radius * math.sin(a), z

    cap = sheet(scene, "Cap", place, 144, last)
    turns = [math.tau * i / 40 for i in range(40)]
    loop = tube(
        scene, "Loop", [(0.11 * math.sin(a), 0.0, 2.13 - 0.11 * math.cos(a)) for a in turns], 0.014,
        segments=12, closed=True,
    )  # fmt: skip
    metal = plain("Cap", (0.75, 0.75, 0.76), roughness=0.25, metallic=1.0)
    for part in (cap, loop):
        part.data.materials.append(metal)
    pose([ball, cap, loop], lean_deg=8.0, roll_deg=14.0)
    return Portrayed((ball,), (cap, loop), elevation_deg=16.0)


def saucepan(scene: bpy.types.Scene) -> Portrayed:
    """Of polished steel, with a long handle."""
    outside = [
        (0.68, 0.0),
        (0.72, 0.01),
        *spline([(0.75, 0.04), (0.79, 0.1), (0.8, 0.2)], 6),
        (0.8, 0.62),
        (0.83, 0.66),
    ]
    body = heated(lathe(scene, "Pan", _walled(outside, 0.03, 0.03), segments=80))
    body.data.set_sharp_from_angle(angle=math.radians(60.0))
    path = spline([(0.78, 0.0, 0.52), (0.95, 0.0, 0.55), (1.3, 0.0, 0.66), (1.85, 0.0, 0.74)], 10)
    handle = tube(
        scene, "Handle", path, lambda v: 0.06 * math.sqrt(max(1.0 - v**12, 0.0)), segments=24
    )
    handle.data.materials.append(plain("Handle", (0.012, 0.012, 0.013), roughness=0.4))
    pose([body, handle], turn_deg=-28.0)
    return Portrayed((body,), (handle,), elevation_deg=13.0, fill=0.9)


def pearls(scene: bpy.types.Scene) -> Portrayed:
    """A strand of them, laid in a spiral, largest in its middle."""
    beads, angle, far = [], 0.3, 0.16
    while far < 1.02:
        radius = 0.105 + 0.045 * math.exp(-(((far - 0.6) / 0.3) ** 2))
        place = (far * math.cos(angle), far * math.sin(angle), radius)
        bead = sphere(scene, "Pearl", place, radius, rings=24)
        beads.append(bead)
        turn = 2.0 * radius / far
        angle += turn
        far += 0.3 * turn / math.tau
    pose(beads)
    return Portrayed(tuple(beads), elevation_deg=40.0, fill=0.9)
