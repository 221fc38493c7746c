# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and plain materials of the stages."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import bmesh
import bpy
from mathutils import Vector

from ...blender.space import here

Point = tuple[float, float, float]
Outline = Sequence[tuple[float, float]]


def mesh(
    scene: bpy.types.Scene,
    name: str,
    vertices: Sequence[Point],
    faces: Sequence[Sequence[int]],
    *,
    smooth: bool = True,
    uvs: Sequence[tuple[float, float]] = (),
) -> bpy.types.Object:
    """`uvs`: one for each corner of each face, in their order."""
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    if uvs:
        layer = data.uv_layers.new(name="UVMap")
        layer.data.foreach_set("uv", [x for uv in uvs for x in uv])
    data.validate()
    if smooth:
        data.shade_smooth()
    obj = bpy.data.objects.new(name, data)
    scene.collection.objects.link(obj)
    return obj


def lathe(
    scene: bpy.types.Scene,
    name: str,
    profile: Sequence[tuple[float, float]],
    *,
    segments: int = 160,
    smooth: bool = True,
) -> bpy.types.Object:
    """Turns `profile`, points (radius, z) from the bottom up with the outside to the right; u goes
    around, v along the profile."""
    angles = [math.tau * i / segments for i in range(segments)]
    circle = [(math.cos(angle), math.sin(angle)) for angle in angles]
    vertices: list[Point] = []
    firsts = []
    for radius, z in profile:
        firsts.append(len(vertices))
        vertices += [(radius * x, radius * y, z) for x, y in circle[: segments if radius else 1]]
    faces, uvs = [], []
    # The last step ends at u = 1, where the first begins at 0.
    around = [(i, (i + 1) % segments, i / segments, (i + 1) / segments) for i in range(segments)]
    last = len(profile) - 1
    for ring in range(last):
        low, high = firsts[ring], firsts[ring + 1]
        below, above = ring / last, (ring + 1) / last
        for i, j, u, next_u in around:
            if profile[ring][0] == 0.0:
                faces.append((low, high + j, high + i))
                uvs += ((u, below), (next_u, above), (u, above))
            elif profile[ring + 1][0] == 0.0:
                faces.append((low + i, low + j, high))
                uvs += ((u, below), (next_u, below), (next_u, above))
            else:
                faces.append((low + i, low + j, high + j, high + i))
                uvs += ((u, below), (next_u, below), (next_u, above), (u, above))
    return mesh(scene, name, vertices, faces, smooth=smooth, uvs=uvs)


def sphere(
    scene: bpy.types.Scene, name: str, centre: Point, radius: float, rings: int = 96
) -> bpy.types.Object:
    profile = [
        (radius * math.sin(math.pi * i / rings), -radius * math.cos(math.pi * i / rings))
        for i in range(1, rings)
    ]
    obj = lathe(scene, name, [(0.0, -radius), *profile, (0.0, radius)], segments=2 * rings)
    obj.location = centre
    return obj


def sheet(
    scene: bpy.types.Scene,
    name: str,
    place: Callable[[float, float], Point],
    columns: int,
    rows: int,
    *,
    smooth: bool = True,
) -> bpy.types.Object:
    """The surface place(u, v) for u and v from 0 to 1, seen from where u × v points. Sides that meet
    are joined."""
    vertices = [
        tuple(place(i / columns, j / rows)) for j in range(rows + 1) for i in range(columns + 1)
    ]
    faces, uvs = [], []
    for j in range(rows):
        for i in range(columns):
            corners = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
            faces.append([column + row * (columns + 1) for column, row in corners])
            uvs += [(column / columns, row / rows) for column, row in corners]
    obj = mesh(scene, name, vertices, faces, smooth=smooth, uvs=uvs)
    shape = bmesh.new()
    shape.from_mesh(obj.data)
    bmesh.ops.remove_doubles(shape, verts=shape.verts, dist=1e-5)
    shape.to_mesh(obj.data)
    shape.free()
    return obj


def tube(
    scene: bpy.types.Scene,
    name: str,
    path: Sequence[Point],
    radius: Callable[[float], float] | float,
    *,
    segments: int = 24,
    closed: bool = False,
) -> bpy.types.Object:
    """Around a path; u goes around, v from its start to its end, which is where `closed` joins them.
    The radius may depend on v."""
    points = [Vector(point) for point in path]
    if closed:
        points.append(points[0])
    last = len(points) - 1
    ahead = [
        points[1 if closed and i == last else min(i + 1, last)]
        - points[last - 1 if closed and i == 0 else max(i - 1, 0)]
        for i in range(last + 1)
    ]
    side = ahead[0].orthogonal().normalized()
    frames = []
    for direction in ahead:
        forward = direction.normalized()
        side = (side - side.dot(forward) * forward).normalized()
        frames.append((side, forward.cross(side)))

    def place(u: float, v: float) -> Point:
        i = round(v * last)
        x, y = frames[i]
        r = radius(v) if callable(radius) else radius
        return points[i] + r * (math.cos(math.tau * u) * x + math.sin(math.tau * u) * y)

    return sheet(scene, name, place, segments, last)


def plate(
    scene: bpy.types.Scene,
    name: str,
    outline: Outline,
    profile: Sequence[tuple[float, float]],
    *,
    sharp_deg: float = 35.0,
) -> bpy.types.Object:
    """An outline, counter-clockwise, raised along `profile`: points (inset, z) from the bottom up. Both
    ends are flat; u and v are x and y in the square around it."""
    count = len(outline)
    vertices = [(*point, z) for inset, z in profile for point in _inset(outline, inset)]
    top = count * (len(profile) - 1)
    faces: list[Sequence[int]] = [range(count - 1, -1, -1), range(top, top + count)]
    for start in range(0, top, count):
        for i in range(count):
            j = (i + 1) % count
            faces.append((start + i, start + j, start + count + j, start + count + i))
    obj = mesh(scene, name, vertices, faces)
    obj.data.set_sharp_from_angle(angle=math.radians(sharp_deg))
    flat_uvs(obj)
    return obj


def _inset(outline: Outline, inset: float) -> list[tuple[float, float]]:
    points = [Vector(point) for point in outline]
    moved = []
    for before, point, after in zip(
        points[-1:] + points[:-1], points, points[1:] + points[:1], strict=True
    ):
        a, b = (point - before).normalized(), (after - point).normalized()
        normal = Vector((-a.y - b.y, a.x + b.x)).normalized()
        slant = max(normal.dot(Vector((-a.y, a.x))), 0.5)
        moved.append(tuple(point + inset / slant * normal))
    return moved


def circle(radius: float, z: float = 0.0, count: int = 96) -> list[Point]:
    angles = [math.tau * i / count for i in range(count)]
    return [(radius * math.cos(a), radius * math.sin(a), z) for a in angles]


def join(objects: Sequence[bpy.types.Object]) -> bpy.types.Object:
    """Meshes as one, which keeps the name of the first: one bounding box for generated coordinates."""
    first, *others = objects
    shape = bmesh.new()
    for obj in objects:
        obj.data.transform(obj.matrix_basis)
        shape.from_mesh(obj.data)
    shape.to_mesh(first.data)
    shape.free()
    first.matrix_basis.identity()
    for obj in others:
        data = obj.data
        bpy.data.objects.remove(obj)
        bpy.data.meshes.remove(data)
    return first


def flat_uvs(obj: bpy.types.Object) -> None:
    """u and v are x and y in the square around the mesh, whose middle is at (0.5, 0.5)."""
    data = obj.data
    layer = data.uv_layers.active or data.uv_layers.new(name="UVMap")
    xs, ys = ([vertex.co[axis] for vertex in data.vertices] for axis in (0, 1))
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    x, y = 0.5 * (max(xs) + min(xs) - size), 0.5 * (max(ys) + min(ys) - size)
    for loop, corner in zip(data.loops, layer.data, strict=True):
        at = data.vertices[loop.vertex_index].co
        corner.uv = ((at.x - x) / size, (at.y - y) / size)


def box_uvs(obj: bpy.types.Object) -> None:
    """Each face seen along the axis that it looks along."""
    data = obj.data
    layer = data.uv_layers.active or data.uv_layers.new(name="UVMap")
    low = [min(v.co[i] for v in data.vertices) for i in range(3)]
    size = max(max(v.co[i] for v in data.vertices) - low[i] for i in range(3))
    for face in data.polygons:
        axis = max(range(3), key=lambda i: abs(face.normal[i]))
        x, y = (i for i in range(3) if i != axis)
        for loop in face.loop_indices:
            at = data.vertices[data.loops[loop].vertex_index].co
            layer.data[loop].uv = ((at[x] - low[x]) / size, (at[y] - low[y]) / size)


def spline(points: Sequence[Sequence[float]], steps: int, *, closed: bool = False) -> list[tuple]:
    """A curve through the points (Catmull and Rom), `steps` to each stretch."""
    at = [Vector(point) for point in points]
    count = len(at)
    if not closed:
        at = [2.0 * at[0] - at[1], *at, 2.0 * at[-1] - at[-2]]
    curve = []
    for i in range(count if closed else count - 1):
        a, b, c, d = (at[(i - 1 + k) % count] if closed else at[i + k] for k in range(4))
        for step in range(steps):
            t = step / steps
            curve.append(
                tuple(
                    0.5
                    * (
                        2.0 * b
                        + (c - a) * t
                        + (2.0 * a - 5.0 * b + 4.0 * c - d) * t**2
                        + (3.0 * (b - c) + d - a) * t**3
                    )
                )
            )
    return curve if closed else [*curve, tuple(at[-2])]


def ellipsoid(
    scene: bpy.types.Scene, name: str, centre: Point, radii: Point, rings: int = 32
) -> bpy.types.Object:
    obj = sphere(scene, name, centre, 1.0, rings)
    obj.scale = radii
    return obj


def backdrop(
    scene: bpy.types.Scene, colour: Point, *, roughness: float = 0.5, depth: float = 5.0
) -> bpy.types.Object:
    """A floor at z = 0 that bends up into a wall behind the scene."""
    bend, height, half_width = 2.5, 9.0, 16.0
    profile = [(-10.0, 0.0), (depth - bend, 0.0)]
    for step in range(1, 24):
        angle = math.pi / 2.0 * step / 24
        profile.append((depth - bend + bend * math.sin(angle), bend - bend * math.cos(angle)))
    profile += [(depth, bend), (depth, height)]
    vertices = [(x, y, z) for y, z in profile for x in (-half_width, half_width)]
    faces = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(len(profile) - 1)]
    obj = mesh(scene, "Backdrop", vertices, faces)
    obj.data.materials.append(plain("Backdrop", colour, roughness=roughness))
    return obj


def plain(
    name: str, colour: Point, *, roughness: float = 0.5, metallic: float = 0.0
) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = principled(material)
    shader.inputs["Base Color"].default_value = (*here(colour), 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    return material


def principled(material: bpy.types.Material) -> bpy.types.Node:
    return next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")


def glow(name: str, colour: Point, strength: float) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = principled(material)
    shader.inputs["Base Color"].default_value = (0.0, 0.0, 0.0, 1.0)
    shader.inputs["Emission Color"].default_value = (*here(colour), 1.0)
    shader.inputs["Emission Strength"].default_value = strength
    return material
