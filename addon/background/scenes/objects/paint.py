# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is lacquered and printed."""

from __future__ import annotations

import math

import bpy
from mathutils import Matrix

from ..shape import flat_uvs, lathe, plain, plate, sheet, spline, tube
from .outline import round_edges
from .portrayed import Portrayed, pose


def speedform(scene: bpy.types.Scene) -> Portrayed:
    """The shape on which car makers judge paint: a car without its parts. Its nose is at -x."""
    body = sheet(scene, "Speedform", _speedform, 200, 120)
    pose([body], turn_deg=28.0)
    return Portrayed((body,), elevation_deg=24.0, fill=0.92)


def _bump(x: float, centre: float, width: float) -> float:
    return math.exp(-(((x - centre) / width) ** 2))


def _speedform(u: float, v: float):
    """u from the nose to the tail, v over it from one sill to the other."""
    x = -1.16 * math.cos(math.pi * u)
    s = x / 1.16
    ends = math.sqrt(max(1.0 - abs(s) ** 4.5, 0.0))
    a = math.pi * v
    across, up = math.cos(a), math.sin(a)
    square = 0.62  # between an ellipse, 1, and a box, 0
    across = math.copysign(abs(across) ** square, across)
    arches = _bump(x, -0.74, 0.26) + _bump(x, 0.74, 0.3)
    wide = 0.54 * ends * (1.0 + 0.05 * s) + 0.035 * arches * ends
    belt = 0.42 * ends * (0.9 + 0.22 * _bump(s, 0.5, 0.7))
    cabin = 0.4 * _bump(x, 0.16, 0.52) * max(0.0, (up - 0.42) / 0.58) ** 1.4
    roof = belt * up**0.55
    crease = 0.03 * ends * _bump(up**0.55, 0.72, 0.1)
    y = wide * across * (1.0 - 0.5 * max(0.0, cabin / 0.4) ** 0.8 * 0.35) + math.copysign(
        crease, across
    ) * min(1.0, abs(across) * 3.0)
    fender = 0.05 * arches * ends * _bump(abs(across), 0.82, 0.16)
    hollow = -0.03 * ends * _bump(s, -0.45, 0.3) * _bump(across, 0.0, 0.35)
    return x, -y, 0.1 * (1.0 - ends) + roof + cabin + fender + hollow


def guitar(scene: bpy.types.Scene) -> Portrayed:
    """An electric one, without most of its neck."""
    outline = spline(
        [(-0.02, -1.12), (0.46, -1.06), (0.76, -0.76), (0.74, -0.36), (0.54, -0.06), (0.57, 0.2),
         (0.68, 0.5), (0.6, 0.7),
         (0.44, 0.62), (0.32, 0.42), (0.14, 0.3), (-0.16, 0.3), (-0.34, 0.52), (-0.44, 0.82),
         (-0.6, 0.92), (-0.72, 0.78),
         (-0.66, 0.4), (-0.56, 0.06), (-0.66, -0.28), (-0.84, -0.62), (-0.68, -0.96), (-0.4, -1.1)],
        8, closed=True,
    )  # fmt: skip
    body = plate(scene, "Body", outline, round_edges(-0.12, 0.12, 0.05), sharp_deg=60.0)
    parts = _hardware(scene)
    pose([body, *parts], lean_deg=58.0, roll_deg=-14.0, turn_deg=-16.0)
    return Portrayed((body,), tuple(parts), elevation_deg=20.0, fill=0.92)


def _hardware(scene: bpy.types.Scene) -> list[bpy.types.Object]:
    cream = plain("Pickguard", (0.62, 0.6, 0.54), roughness=0.35)
    chrome = plain("Bridge", (0.55, 0.55, 0.56), roughness=0.2, metallic=1.0)
    guard = [
        (-0.3, 0.26), (-0.4, 0.4), (-0.5, 0.3), (-0.42, -0.1), (-0.34, -0.5), (0.0, -0.56),
        (0.34, -0.72), (0.56, -0.62), (0.46, -0.3), (0.3, -0.06), (0.34, 0.2), (0.1, 0.22),
    ]  # fmt: skip
    bridge = [(-0.2, -0.74), (0.2, -0.74), (0.2, -0.6), (-0.2, -0.6)]
    neck = [(-0.13, 0.18), (0.13, 0.18), (0.12, 1.2), (-0.12, 1.2)]
    parts = [
        (plate(scene, "Pickguard", spline(guard, 8, closed=True), _slab(0.11, 0.134)), cream),
        (plate(scene, "Bridge", bridge, _slab(0.11, 0.165)), chrome),
        (
            plate(scene, "Neck", neck, _slab(0.1, 0.2)),
            plain("Neck", (0.42, 0.24, 0.1), roughness=0.35),
        ),
    ]
    for i in range(6):
        x = -0.09 + 0.036 * i
        string = [(1.3 * x, -0.66, 0.2), (x, 1.2, 0.225)]
        parts.append((tube(scene, "String", string, 0.005, segments=6), chrome))
    for x, y in ((0.34, -0.54), (0.45, -0.7), (0.54, -0.86)):
        knob = lathe(
            scene, "Knob", ((0.06, 0.11), (0.055, 0.19), (0.045, 0.2), (0.0, 0.2)), segments=32
        )
        knob.data.set_sharp_from_angle(angle=math.radians(40.0))
        knob.location = (x, y, 0.0)
        parts.append((knob, cream))
    black = plain("Pickup", (0.012, 0.012, 0.012), roughness=0.4)
    parts += [
        (_pickup(scene, *place), black) for place in ((0.14, 0.0), (-0.14, 0.0), (-0.42, 0.16))
    ]
    for part, material in parts:
        part.data.materials.append(material)
    return [part for part, _ in parts]


def _pickup(scene: bpy.types.Scene, y: float, turn: float) -> bpy.types.Object:
    box = [(-0.2, -0.05), (0.2, -0.05), (0.2, 0.05), (-0.2, 0.05)]
    pickup = plate(scene, "Pickup", box, _slab(0.12, 0.175))
    pickup.matrix_basis = Matrix.Translation((0.0, y, 0.0)) @ Matrix.Rotation(turn, 4, "Z")
    return pickup


def _slab(bottom: float, top: float) -> list[tuple[float, float]]:
    """Profile of a plate with its upper edge broken."""
    return [(0.0, bottom), (0.0, top - 0.01), (0.01, top)]


def banknote(scene: bpy.types.Scene) -> Portrayed:
    """A numeral in ink on curved paper."""
    paper = sheet(scene, "Paper", lambda u, v: _note(2.6 * (u - 0.5), 1.3 * (v - 0.5), 0.0), 64, 16)
    paper.data.materials.append(plain("Paper", (0.5, 0.5, 0.44), roughness=0.8))
    lines = plain("Print", (0.16, 0.2, 0.22), roughness=0.8)
    print_ = [_guilloche(scene, k) for k in range(5)]
    for part in print_:
        part.data.materials.append(lines)
    ink = [_numeral(scene)]
    pose([*ink, paper, *print_], lean_deg=34.0, roll_deg=-8.0, turn_deg=-8.0)
    return Portrayed(tuple(ink), (paper, *print_), elevation_deg=22.0, fill=0.95)


def _note(x: float, y: float, lift: float):
    return x, y, 0.12 * math.sin(1.9 * x + 0.4) + lift


def _guilloche(scene: bpy.types.Scene, k: int) -> bpy.types.Object:
    points = []
    for i in range(241):
        t = i / 240
        y = (
            0.5
            * math.sin(math.tau * (2.0 * t + k / 5.0))
            * (0.6 + 0.4 * math.cos(math.tau * 3.0 * t))
        )
        points.append(_note(2.4 * (t - 0.5), y, 0.001))
    return tube(scene, "Print", points, 0.0045, segments=6)


def _numeral(scene: bpy.types.Scene) -> bpy.types.Object:
    data = bpy.data.curves.new("Numeral", "FONT")
    data.body, data.size, data.extrude, data.bevel_depth = "100", 1.15, 0.008, 0.01
    data.align_x, data.align_y = "CENTER", "CENTER"
    text = bpy.data.objects.new("Numeral", data)
    numeral = bpy.data.objects.new("Numeral", bpy.data.meshes.new_from_object(text))
    bpy.data.objects.remove(text)
    bpy.data.curves.remove(data)
    scene.collection.objects.link(numeral)
    flat_uvs(numeral)
    for vertex in numeral.data.vertices:
        vertex.co = _note(vertex.co.x, vertex.co.y, vertex.co.z + 0.012)
    return numeral
