# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lenses, panes, mirrors and discs."""

from __future__ import annotations

import math

import bmesh
import bpy
from mathutils import Matrix

from ..shape import (
    box_uvs,
    circle,
    flat_uvs,
    lathe,
    mesh,
    plain,
    plate,
    sheet,
    sphere,
    spline,
    tube,
)
from .portrayed import FOR_CLEAR, Portrayed, pose


def lens(scene: bpy.types.Scene) -> Portrayed:
    """A camera's, in its barrel: a front element and one deep inside."""
    elements = [
        _cap(scene, 0.72, 0.2, 0.98),
        _cap(scene, 0.52, 0.1, 0.62),
        _cap(scene, 0.36, 0.09, 0.36),
    ]
    ribs = [(1.0 + 0.02 * (i % 2), 0.3 + 0.02 * (i // 2 + i % 2)) for i in range(28)]
    outside = [
        (0.0, 0.0),
        (0.92, 0.0),
        (0.95, 0.03),
        (0.95, 0.26),
        *ribs,
        (0.98, 0.62),
        (1.0, 0.64),
        (1.0, 1.02),
        (0.98, 1.05),
        (0.94, 1.06),
    ]
    inside = [
        (0.88, 1.05),
        (0.84, 1.0),
        (0.76, 0.97),
        (0.73, 0.95),
        (0.7, 0.9),
        (0.6, 0.64),
        (0.52, 0.62),
        (0.48, 0.55),
        (0.4, 0.37),
        (0.34, 0.34),
        (0.2, 0.2),
        (0.0, 0.2),
    ]
    barrel = lathe(scene, "Barrel", [*outside, *inside], segments=160)
    barrel.data.set_sharp_from_angle(angle=math.radians(30.0))
    barrel.data.materials.append(plain("Barrel", (0.012, 0.012, 0.013), roughness=0.38))
    line = lathe(
        scene, "Line", ((1.002, 0.74), (1.004, 0.742), (1.004, 0.765), (1.002, 0.767)), segments=160
    )
    line.data.materials.append(plain("Line", (0.6, 0.03, 0.02), roughness=0.4))
    pose([*elements, barrel, line], lean_deg=44.0, turn_deg=18.0)
    return Portrayed(tuple(elements), (barrel, line), elevation_deg=22.0, light=FOR_CLEAR)


def _cap(scene: bpy.types.Scene, radius: float, rise: float, z: float) -> bpy.types.Object:
    """The front of an element, as a sheet."""
    sphere_radius = (radius * radius + rise * rise) / (2.0 * rise)
    edge = math.asin(radius / sphere_radius)
    steps = 32
    angles = [edge * (1.0 - i / steps) for i in range(steps)]
    profile = [
        (sphere_radius * math.sin(a), z + sphere_radius * (math.cos(a) - math.cos(edge)))
        for a in angles
    ]
    cap = lathe(scene, "Element", [*profile, (0.0, z + rise)], segments=128)
    flat_uvs(cap)
    return cap


def spectacles(scene: bpy.types.Scene) -> Portrayed:
    """Upright on the floor, their temples spread behind."""
    rim = spline(
        [(0.1, 0.12), (0.22, 0.32), (0.55, 0.4), (0.92, 0.32), (1.04, 0.1), (0.96, -0.22),
         (0.62, -0.4), (0.28, -0.3)],
        12, closed=True,
    )  # fmt: skip
    lenses, props = [], []
    for side in (1.0, -1.0):
        edge = [(side * x, _wrap(x, z), z) for x, z in rim]

        def place(u: float, v: float, side=side):
            i = round((u if side > 0.0 else 1.0 - u) * len(rim)) % len(rim)
            x, z = 0.58 + v * (rim[i][0] - 0.58), v * rim[i][1]
            return side * x, _wrap(x, z), z

        lens = sheet(scene, "Lens", place, len(rim), 16)
        lenses.append(lens)
        props.append(tube(scene, "Rim", edge, 0.028, segments=14, closed=True))
        temple = [
            (1.04, _wrap(1.04, 0.1), 0.14),
            (1.12, 0.3, 0.15),
            (1.1, 0.9, 0.14),
            (1.02, 1.5, 0.08),
            (0.98, 1.85, -0.24),
        ]
        props.append(
            tube(
                scene,
                "Temple",
                spline([(side * x, y, z) for x, y, z in temple], 8),
                0.03,
                segments=12,
            )
        )
    bridge = [(-0.12, _wrap(0.12, 0.0), 0.14), (0.0, -0.04, 0.2), (0.12, _wrap(0.12, 0.0), 0.14)]
    props.append(tube(scene, "Bridge", spline(bridge, 10), 0.028, segments=12))
    frame = plain("Frame", (0.014, 0.011, 0.01), roughness=0.2)
    for part in props:
        part.data.materials.append(frame)
    for part in lenses:
        _front_uvs(part)
    pose([*lenses, *props], lean_deg=-7.0, turn_deg=-24.0)
    return Portrayed(tuple(lenses), tuple(props), elevation_deg=18.0, fill=0.88)


def _wrap(x: float, z: float) -> float:
    return 0.16 * x * x + 0.08 * z * z


def _front_uvs(obj: bpy.types.Object) -> None:
    """As flat_uvs does, of what is seen from -y."""
    turn = Matrix.Rotation(-math.pi / 2.0, 4, "X")
    obj.data.transform(turn)
    flat_uvs(obj)
    obj.data.transform(turn.inverted())


def pane(scene: bpy.types.Scene) -> Portrayed:
    """Panes that stand around an axis like the leaves of a book, on a round foot."""
    panes, props = [], []
    glass = plain("Edge", (0.5, 0.6, 0.58), roughness=0.2, metallic=0.4)
    for turn in (-70.0, -34.0, 2.0, 38.0, 74.0):
        film = sheet(
            scene, "Pane", lambda u, v: (0.06 + 0.94 * u, 0.0, 0.08 + 1.62 * v), 1, 1, smooth=False
        )
        if turn < 0.0:
            film.data.flip_normals()
        corners = [(0.06, 0.08), (1.0, 0.08), (1.0, 1.7), (0.06, 1.7)]
        edge = [(x, 0.0, z) for x, z in _rounded(corners)]
        rim = tube(scene, "Edge", edge, 0.01, segments=8, closed=True)
        rim.data.materials.append(glass)
        for part in (film, rim):
            part.matrix_basis = Matrix.Rotation(math.radians(turn - 90.0), 4, "Z")
        panes.append(film)
        props.append(rim)
    foot = lathe(
        scene,
        "Foot",
        ((0.0, 0.0), (1.06, 0.0), (1.08, 0.02), (1.08, 0.05), (1.06, 0.07), (0.0, 0.07)),
    )
    foot.data.set_sharp_from_angle(angle=math.radians(50.0))
    foot.data.materials.append(plain("Foot", (0.55, 0.55, 0.55), roughness=0.5))
    pose([*panes, *props, foot], turn_deg=8.0)
    return Portrayed(tuple(panes), (*props, foot), elevation_deg=24.0, light=FOR_CLEAR)


def lantern(scene: bpy.types.Scene) -> Portrayed:
    """Sheets of glass along the faces of an icosahedron, lead-framed at its edges."""
    shape = bmesh.new()
    bmesh.ops.create_icosphere(shape, subdivisions=1, radius=1.0)
    body = mesh(scene, "Lantern", [], [], smooth=False)
    shape.to_mesh(body.data)
    shape.free()
    down = min(body.data.polygons, key=lambda face: face.normal.z).normal
    body.data.transform(down.rotation_difference((0.0, 0.0, -1.0)).to_matrix().to_4x4())
    box_uvs(body)
    lead = plain("Lead", (0.05, 0.05, 0.055), roughness=0.35, metallic=0.8)
    at = [vertex.co for vertex in body.data.vertices]
    bars = [
        tube(scene, "Lead", (at[a], at[b]), 0.014, segments=8)
        for a, b in (edge.vertices for edge in body.data.edges)
    ]
    knots = [sphere(scene, "Knot", tuple(point), 0.022, rings=12) for point in at]
    for part in (*bars, *knots):
        part.data.materials.append(lead)
    pose([body, *bars, *knots], turn_deg=20.0, floats=True)
    # It hangs before a softbox, which shines through; the others are mirrored.
    return Portrayed(
        (body,),
        (*bars, *knots),
        elevation_deg=-14.0,
        light=FOR_CLEAR,
        light_turn_deg=106.0,
        floats=True,
    )


def _rounded(corners):
    points = []
    for i, (x, y) in enumerate(corners):
        (ax, ay), (bx, by) = corners[i - 1], corners[(i + 1) % len(corners)]
        for t in (0.0, 0.25, 0.5, 0.75, 1.0):
            p, s = 0.04 * (1 - t) ** 2, 0.04 * t * t
            points.append((x + p * (ax - x) + s * (bx - x), y + p * (ay - y) + s * (by - y)))
    return points


def filter(scene: bpy.types.Scene) -> Portrayed:
    """A round one in its mount, and a loose one that leans on it."""
    discs, props = [], []
    dark = plain("Mount", (0.016, 0.016, 0.018), roughness=0.3)
    for radius, lean, turn, at in (
        (0.86, 66.0, -12.0, (0.0, 0.1)),
        (0.5, 38.0, 22.0, (0.42, -0.42)),
    ):
        disc = lathe(
            scene, "Filter", ((radius, 0.0), (0.5 * radius, 0.004), (0.0, 0.005)), segments=128
        )
        flat_uvs(disc)
        a, b = radius - 0.02, radius + 0.09
        section = (
            (a, -0.09),
            (b - 0.02, -0.09),
            (b, -0.07),
            (b, 0.07),
            (b - 0.02, 0.09),
            (a + 0.02, 0.09),
            (a, 0.06),
            (a, -0.09),
        )
        mount = lathe(scene, "Mount", section, segments=128)
        mount.data.set_sharp_from_angle(angle=math.radians(30.0))
        mount.data.materials.append(dark)
        pose([disc, mount], lean_deg=lean, turn_deg=turn)
        slide = Matrix.Translation(
            (0.743 * -at[1] + 0.669 * at[0], 0.669 * at[1] + 0.743 * at[0], 0.0)
        )
        for part in (disc, mount):
            part.matrix_basis = slide @ part.matrix_basis
        discs.append(disc)
        props.append(mount)
    return Portrayed(tuple(discs), tuple(props), elevation_deg=20.0, light=FOR_CLEAR)


def window(scene: bpy.types.Scene) -> Portrayed:
    """Two panes in a white frame."""
    panes, props = [], []
    white = plain("Frame", (0.72, 0.72, 0.7), roughness=0.4)
    for x in (-0.44, 0.44):
        film = sheet(
            scene,
            "Pane",
            lambda u, v, x=x: (x + 0.84 * (u - 0.5), 0.0, 0.09 + 1.72 * v),
            1,
            1,
            smooth=False,
        )
        panes.append(film)
    bars = (
        ((-0.96, 0.0), (-0.85, 1.9)), ((0.85, 0.0), (0.96, 1.9)), ((-0.05, 0.11), (0.05, 1.79)),
        ((-0.85, 0.0), (0.85, 0.11)), ((-0.85, 1.79), (0.85, 1.9)),
    )  # fmt: skip
    for (x0, z0), (x1, z1) in bars:
        bar = plate(
            scene, "Bar", [(x0, z0), (x1, z0), (x1, z1), (x0, z1)],
            [(0.012, -0.075), (0.0, -0.063), (0.0, 0.063), (0.012, 0.075)],
        )  # fmt: skip
        bar.matrix_basis = Matrix.Rotation(math.pi / 2.0, 4, "X")
        props.append(bar)
    sill = plate(
        scene,
        "Sill",
        [(-1.06, -0.2), (1.06, -0.2), (1.06, 0.14), (-1.06, 0.14)],
        [(0.0, -0.08), (0.0, -0.012), (0.012, 0.0)],
    )
    props.append(sill)
    for part in props:
        part.data.materials.append(white)
    pose([*panes, *props], turn_deg=39.0)
    return Portrayed(tuple(panes), tuple(props), elevation_deg=12.0)


def mirror(scene: bpy.types.Scene) -> Portrayed:
    """Of a telescope: hollow, on a thick disc of glass, in a cell."""
    steps = 48
    face = [(0.96 * (1.0 - i / steps), 0.3 * (1.0 - i / steps) ** 2) for i in range(steps)]
    disc = lathe(scene, "Mirror", [(0.98, 0.3), *face, (0.0, 0.0)], segments=192)
    flat_uvs(disc)
    side = lathe(
        scene,
        "Glass",
        ((0.0, -0.2), (0.97, -0.2), (1.0, -0.17), (1.0, 0.28), (0.98, 0.3)),
        segments=192,
    )
    side.data.set_sharp_from_angle(angle=math.radians(40.0))
    side.data.materials.append(plain("Ground Glass", (0.35, 0.42, 0.4), roughness=0.45))
    pose([disc, side], lean_deg=62.0, turn_deg=-14.0)
    return Portrayed((disc,), (side,), elevation_deg=20.0)


def ball(scene: bpy.types.Scene) -> Portrayed:
    """Of clear glass, with two small ones."""
    places = (((0.0, 0.1), 0.82), ((0.86, -0.55), 0.3), ((-0.66, -0.72), 0.22))
    balls = []
    for (x, y), r in places:
        made = sphere(scene, "Ball", (x, y, r), r, rings=80 if r > 0.5 else 48)
        balls.append(made)
    pose(balls)
    return Portrayed(tuple(balls), elevation_deg=18.0, light=FOR_CLEAR, floats=True)


# Radii of a 120 mm disc in units of its own: hole, clamping ring, data, rim (IEC 60908).
_HOLE, _RING, _DATA, _RIM, _THICK = 0.125, 0.38, 0.967, 1.0, 0.02


def disc(scene: bpy.types.Scene) -> Portrayed:
    """An optical disc leaning back; its tracks run around its own z."""
    data = lathe(scene, "Data", ((_DATA, 0.0), (_RING, 0.0)), segments=256)
    flat_uvs(data)
    ring = lathe(
        scene, "Ring", ((_RING, 0.0), (_HOLE, 0.0), (_HOLE, -_THICK)), segments=128, smooth=False
    )
    stack = ((_HOLE, -_THICK), (_RIM, -_THICK), (_RIM, 0.0), (_DATA, 0.0))
    rim = lathe(scene, "Rim", stack, segments=256, smooth=False)
    lip = tube(
        scene, "Lip", circle(0.27),
        0.012, segments=8, closed=True,
    )  # fmt: skip
    clear = plain("Polycarbonate", (0.32, 0.33, 0.35), roughness=0.12, metallic=0.85)
    for part in (ring, rim, lip):
        part.data.materials.append(clear)
    pose([data, ring, rim, lip], lean_deg=68.0, turn_deg=-10.0)
    return Portrayed((data,), (ring, rim, lip), elevation_deg=24.0)
