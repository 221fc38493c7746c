# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is forged, bent, turned and struck."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix, Vector

from ..shape import circle, flat_uvs, join, lathe, mesh, plain, plate, sheet, spline, tube
from .outline import round_edges, softened
from .portrayed import Portrayed, heated, pose


def blade(scene: bpy.types.Scene) -> Portrayed:
    """A knife; heat comes from the handle."""
    steel, props = heated(_steel(scene)), _handle(scene)
    pose([steel, *props], lean_deg=36.0, roll_deg=-30.0, turn_deg=6.0)
    return Portrayed((steel,), tuple(props), elevation_deg=24.0, fill=0.9)


def _steel(scene: bpy.types.Scene) -> bpy.types.Object:
    back = spline([(-0.28, 0.13), (0.4, 0.16), (0.9, 0.1), (1.3, -0.18)], 16)
    edge = spline([(-0.28, -0.36), (0.4, -0.36), (0.9, -0.3), (1.3, -0.18)], 16)
    last = len(back) - 1
    # Half the thickness: at the back, over the flat, along the bevel down to the edge.
    section = ((0.0, 0.03), (0.03, 0.036), (0.3, 0.034), (0.58, 0.028), (0.62, 0.026), (1.0, 0.0))
    around = [(down, -half) for down, half in section] + [(d, h) for d, h in reversed(section)]

    def place(u: float, v: float):
        (x, top), (_, bottom) = back[round(v * last)], edge[round(v * last)]
        down, half = around[round(u * (len(around) - 1))]
        taper = min(1.0, 0.15 + 3.0 * (1.0 - v))
        return x, top + (bottom - top) * down, half * taper

    steel = sheet(scene, "Blade", place, len(around) - 1, last)
    steel.data.set_sharp_from_angle(angle=math.radians(9.0))
    flat_uvs(steel)
    return steel


def _handle(scene: bpy.types.Scene) -> list[bpy.types.Object]:
    """Black, with a bolster and pins of brass."""
    outline = [
        (-0.3, 0.13), (-0.6, 0.12), (-1.0, 0.15), (-1.22, 0.1), (-1.26, -0.08), (-1.12, -0.16),
        (-0.85, -0.11), (-0.55, -0.12), (-0.3, -0.16),
    ]  # fmt: skip
    handle = plate(scene, "Handle", spline(outline, 8), round_edges(-0.075, 0.075, 0.035))
    handle.data.materials.append(plain("Handle", (0.016, 0.013, 0.012), roughness=0.35))
    band = [(-0.34, -0.17), (-0.26, -0.165), (-0.26, 0.135), (-0.34, 0.14)]
    parts = [plate(scene, "Bolster", band, round_edges(-0.08, 0.08, 0.015))]
    section = ((0.0, -0.08), (0.035, -0.08), (0.035, 0.078), (0.0, 0.082))
    for x in (-0.55, -0.95):
        parts.append(lathe(scene, "Pin", section, segments=32))
        parts[-1].location.x = x
    brass = plain("Brass", (0.72, 0.5, 0.22), roughness=0.25, metallic=1.0)
    for part in parts:
        part.data.set_sharp_from_angle(angle=math.radians(40.0))
        part.data.materials.append(brass)
    return [handle, *parts]


def ring(scene: bpy.types.Scene) -> Portrayed:
    """Two wedding bands, one leaning on the other."""
    steps, half, inner, thick = 64, 0.21, 0.8, 0.12
    section = []
    for i in range(steps):
        a = math.tau * i / steps
        # Nearly flat inside, domed outside, well rounded between.
        x = math.copysign(abs(math.cos(a)) ** 0.6, math.cos(a))
        y = math.copysign(abs(math.sin(a)) ** 0.5, math.sin(a))
        section.append((inner + 0.5 * thick * (1.0 + x * (1.0 if x > 0 else 0.85)), half * y))
    section.append(section[0])
    bands = [lathe(scene, "Band", section, segments=192) for _ in "ab"]
    pose([bands[0]], turn_deg=12.0)
    pose([bands[1]], lean_deg=62.0, turn_deg=-24.0)
    bands[1].matrix_basis.translation.x -= 0.35
    bands[1].matrix_basis.translation.y += 0.15
    for band in bands:
        band.matrix_basis @= Matrix.Scale(0.8, 4)
    return Portrayed(tuple(bands), elevation_deg=24.0)


def bolt(scene: bpy.types.Scene) -> Portrayed:
    """A bolt that stands on its hexagonal head."""
    corner = [(x, y) for x, y, _ in circle(0.62, count=6)]
    head = plate(
        scene, "Head", softened(corner, 0.05), round_edges(0.0, 0.46, 0.03), sharp_deg=28.0
    )
    pitch, turns, r = 0.13, 10.5, 0.31
    rows = int(turns * 12)

    def place(u: float, v: float):
        z = 0.72 + pitch * turns * v
        height = abs(2.0 * ((turns * v - u) % 1.0) - 1.0)
        fade = min(1.0, 12.0 * v, 10.0 * (1.0 - v))
        radius = r - 0.075 * fade * min(max(1.35 * height - 0.2, 0.0), 1.0)
        radius *= 1.0 - 0.12 * max(0.0, 1.0 - 16.0 * (1.0 - v))
        return radius * math.cos(math.tau * u), radius * math.sin(math.tau * u), z

    thread = sheet(scene, "Thread", place, 96, rows)
    top = 0.72 + pitch * turns
    shank = ((0.0, 0.4), (0.36, 0.4), (0.36, 0.46), (r, 0.5), (r, 0.72))
    neck = lathe(scene, "Shank", shank, segments=96)
    tip = lathe(
        scene, "Tip", ((0.88 * r, top), (0.7 * r, top + 0.03), (0.0, top + 0.035)), segments=96
    )
    for part in (neck, tip):
        part.data.set_sharp_from_angle(angle=math.radians(40.0))
    whole = join((head, thread, neck, tip))
    pose([whole], lean_deg=-74.0, turn_deg=58.0)
    return Portrayed((whole,), elevation_deg=24.0)


def exhaust(scene: bpy.types.Scene) -> Portrayed:
    """A bent pipe with its flange, welds and tip."""
    path = spline(
        [(-0.95, 0.0, 0.0), (-0.5, 0.0, 0.02), (-0.1, 0.0, 0.2), (0.12, 0.0, 0.62), (0.3, 0.0, 1.02),
         (0.72, 0.0, 1.2), (1.12, 0.0, 1.22)], 14,
    )  # fmt: skip
    outside = tube(scene, "Pipe", path, lambda v: 0.27 + 0.05 * _step(v, 0.86, 0.9), segments=72)
    inside = tube(
        scene, "Bore", path[::-1], lambda v: 0.245 + 0.05 * _step(1.0 - v, 0.86, 0.9), segments=72
    )
    lip = tube(scene, "Lip", _circle((1.12, 0.0, 1.22), 0.308), 0.018, segments=12, closed=True)
    welds = [
        tube(
            scene,
            "Weld",
            _circle(path[i], 0.276, ahead=path[i + 1], waves=30),
            0.018,
            segments=10,
            closed=True,
        )
        for i in (28, 56)
    ]
    flange = lathe(
        scene,
        "Flange",
        ((0.25, -0.06), (0.48, -0.06), (0.5, -0.04), (0.5, 0.04), (0.48, 0.06), (0.25, 0.06)),
    )
    flange.data.set_sharp_from_angle(angle=math.radians(50.0))
    flange.matrix_basis = Matrix.Translation((-0.9, 0.0, 0.0)) @ Matrix.Rotation(
        math.pi / 2, 4, "Y"
    )
    whole = heated(join((outside, inside, lip, *welds, flange)))
    pose([whole], turn_deg=-30.0)
    return Portrayed((whole,), elevation_deg=16.0)


def _step(x: float, low: float, high: float) -> float:
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def _circle(centre, radius: float, ahead=None, waves: int = 0):
    """In the plane across the direction to `ahead`, which is x where there is none."""
    middle = Vector(centre)
    forward = (Vector(ahead) - middle).normalized() if ahead else Vector((1.0, 0.0, 0.0))
    side = Vector((0.0, 1.0, 0.0))
    up = forward.cross(side)
    points = []
    count = 8 * waves or 96
    for i in range(count):
        a = math.tau * i / count
        r = radius + (0.006 * math.cos(waves * a) if waves else 0.0)
        points.append(tuple(middle + r * (math.cos(a) * side + math.sin(a) * up)))
    return points


def coin(scene: bpy.types.Scene) -> Portrayed:
    """Of two metals: the core takes the material, the ring is silver."""
    core = lathe(
        scene,
        "Core",
        (
            (0.0, -0.04),
            (0.66, -0.04),
            (0.66, 0.04),
            (0.655, 0.043),
            (0.5, 0.046),
            (0.35, 0.052),
            (0.2, 0.055),
            (0.0, 0.056),
        ),
        segments=160,
    )
    core.data.set_sharp_from_angle(angle=math.radians(40.0))
    core = join([core, *_star(scene)])
    flat_uvs(core)
    band = _coin_ring(scene)
    silver = plain("Silver", (0.2, 0.2, 0.195), roughness=0.4, metallic=1.0)
    band.data.materials.append(silver)
    dots = [_dot(scene, math.tau * i / 24) for i in range(24)]
    for part in dots:
        part.data.materials.append(silver)
    pose([core, band, *dots], lean_deg=54.0, turn_deg=-8.0)
    return Portrayed((core,), (band, *dots), elevation_deg=24.0)


def _star(scene: bpy.types.Scene):
    """Eight rays around a domed centre, and a thin ring."""
    rays = []
    for i in range(8):
        a = math.tau * i / 8
        long = 0.52 if i % 2 == 0 else 0.36
        corners = [(0.1, -0.075), (long, 0.0), (0.1, 0.075)]
        c, s = math.cos(a), math.sin(a)
        base = [(c * x - s * y, s * x + c * y, 0.04) for x, y in corners]
        ridge = [(0.0, 0.0, 0.1), (c * long, s * long, 0.046)]
        vertices = [*base, *ridge]
        ray = mesh(
            scene, "Ray", vertices, [(0, 1, 4), (0, 4, 3), (3, 4, 2), (4, 1, 2)], smooth=False
        )
        rays.append(ray)
    rim = tube(scene, "Rim", circle(0.585, 0.045, 128), 0.012, segments=10, closed=True)
    return [*rays, rim]


def _coin_ring(scene: bpy.types.Scene) -> bpy.types.Object:
    """With a raised rim and a reeded edge."""
    profile = [(0.66, -0.06), (0.98, -0.06), (1.0, -0.045), (1.0, 0.055), (0.985, 0.075), (0.94, 0.075),
               (0.92, 0.045), (0.69, 0.045), (0.66, 0.05), (0.66, -0.06)]  # fmt: skip
    last = len(profile) - 1

    def place(u: float, v: float):
        r, z = profile[round(v * last)]
        a = math.tau * u
        r -= 0.008 * (1.0 + math.cos(160.0 * a)) if r == 1.0 else 0.0
        return r * math.cos(a), r * math.sin(a), z

    band = sheet(scene, "Coin", place, 960, last)
    band.data.set_sharp_from_angle(angle=math.radians(30.0))
    return band


def _dot(scene: bpy.types.Scene, angle: float) -> bpy.types.Object:
    steps = 6
    turns = [0.5 * math.pi * i / steps for i in range(steps)]
    profile = [(0.035 * math.cos(a), 0.025 * math.sin(a)) for a in turns]
    dot = lathe(scene, "Dot", [*profile, (0.0, 0.025)], segments=20)
    dot.matrix_basis.translation = (0.8 * math.cos(angle), 0.8 * math.sin(angle), 0.045)
    return dot


def carabiner(scene: bpy.types.Scene) -> Portrayed:
    """Of bent rod, with its gate."""
    bow = spline(
        [(0.3, 0.55), (0.28, 0.85), (0.0, 1.02), (-0.34, 0.9), (-0.46, 0.5), (-0.42, 0.0), (-0.34, -0.55),
         (-0.2, -0.85), (0.06, -0.92), (0.26, -0.76), (0.3, -0.45)], 12,
    )  # fmt: skip
    body = tube(
        scene,
        "Bow",
        [(x, y, 0.0) for x, y in bow],
        lambda v: 0.105 - 0.012 * math.cos(math.tau * v),
        segments=32,
    )
    rod = [
        (0.3, 0.56, 0.0),
        (0.305, 0.3, 0.0),
        (0.31, 0.0, 0.0),
        (0.305, -0.3, 0.0),
        (0.3, -0.46, 0.0),
    ]
    gate = tube(scene, "Gate", spline(rod, 8), 0.07, segments=24)
    sleeve = lathe(
        scene,
        "Sleeve",
        ((0.075, 0.0), (0.1, 0.0), (0.105, 0.01), (0.105, 0.4), (0.1, 0.41), (0.075, 0.41)),
    )
    sleeve.matrix_basis = Matrix.Translation((0.306, -0.35, 0.0)) @ Matrix.Rotation(
        -math.pi / 2, 4, "X"
    )
    sleeve.data.set_sharp_from_angle(angle=math.radians(50.0))
    for part in (gate, sleeve):
        part.data.materials.append(plain("Gate", (0.6, 0.6, 0.61), roughness=0.3, metallic=1.0))
    pose([body, gate, sleeve], lean_deg=58.0, turn_deg=20.0)
    return Portrayed((body,), (gate, sleeve), elevation_deg=22.0)


def spring(scene: bpy.types.Scene) -> Portrayed:
    """A coil under pressure, its ends drawn flat."""
    turns, steps = 7.5, 540

    def at(t: float):
        a = math.tau * turns * t
        # The first and the last turn lie flat.
        rise = min(max((t - 0.09) / 0.82, 0.0), 1.0)
        return 0.62 * math.cos(a), 0.62 * math.sin(a), 1.75 * rise + 0.1

    wire = tube(scene, "Spring", [at(i / steps) for i in range(steps + 1)], 0.095, segments=24)
    ends = [
        _disc_at(scene, at(t), at(t + step), 0.095) for t, step in ((0.0, 0.002), (1.0, -0.002))
    ]
    coil = heated(join((wire, *ends)))
    pose([coil], lean_deg=-72.0, turn_deg=-54.0)
    return Portrayed((coil,), elevation_deg=26.0)


def _disc_at(scene: bpy.types.Scene, centre, inwards, radius: float) -> bpy.types.Object:
    """Closes the end of a rod."""
    outwards = (Vector(centre) - Vector(inwards)).normalized()
    cap = lathe(scene, "End", ((radius, 0.0), (0.9 * radius, 0.012), (0.0, 0.014)), segments=24)
    flat_uvs(cap)
    turn = outwards.to_track_quat("Z", "Y").to_matrix().to_4x4()
    cap.matrix_basis = Matrix.Translation(centre) @ turn
    return cap
