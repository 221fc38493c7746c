# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Objects that pose for pictures: closed, facing outwards, with surface coordinates, before a camera
that sees all of them."""

from __future__ import annotations

import math

import bmesh
import bpy
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

from jobs.extension import module
from jobs.steps import new_file

OBJECTS = module("background.scenes.objects").OBJECTS
portrait = module("background.scenes.portrait")
corners = module("background.scenes.objects.portrayed").corners
lighting = module("lighting.world")


def size(objects) -> float:
    points = [point for obj in objects for point in corners(obj)]
    return max(max(p[i] for p in points) - min(p[i] for p in points) for i in range(3))


def volume_of_closed(obj: bpy.types.Object) -> float | None:
    """Positive where the faces of a closed mesh look outwards; None of an open one."""
    shape = bmesh.new()
    shape.from_mesh(obj.data)
    closed = all(edge.is_manifold for edge in shape.edges)
    volume = shape.calc_volume(signed=True)
    shape.free()
    return volume if closed else None


def check(name: str) -> None:
    new_file()
    scene = bpy.context.scene
    portrayed = OBJECTS[name](scene)
    parts = (*portrayed.objects, *portrayed.props)
    assert portrayed.objects, name
    assert 1.2 <= size(parts if not portrayed.has_ground else portrayed.objects) <= 2.9, (
        name,
        size(parts),
    )
    count = sum(len(obj.data.vertices) for obj in parts)
    assert 6 <= count <= 60_000, (name, count)
    for obj in portrayed.objects:
        assert obj.data.polygons, name
        assert not obj.data.materials, name
        layer = obj.data.uv_layers.active
        assert layer is not None, (name, obj.name)
        uvs = [uv.vector for uv in layer.uv]
        assert all(-1e-4 <= x <= 1.0001 for uv in uvs for x in uv), (name, obj.name)
        assert len({tuple(round(x, 4) for x in uv) for uv in uvs}) >= 3, (name, obj.name)
    for obj in portrayed.props:
        assert obj.data.materials, (name, obj.name)
    for obj in parts:
        assert (volume_of_closed(obj) or 1.0) > 0.0, (name, obj.name)
    if not portrayed.floats:
        assert min(point.z for obj in parts for point in corners(obj)) > -0.2, name


def check_picture(name: str) -> None:
    """The camera stands where Blender's does, all is in its picture, and the world is the light."""
    new_file()
    scene = bpy.context.scene
    stage = portrait.build(scene, name)
    material = bpy.data.materials.new("Any")
    stage.place(material)
    assert lighting.light_of(scene.world) is not None
    assert not any(obj.type == "LIGHT" for obj in scene.objects)
    scene.render.resolution_x = scene.render.resolution_y = 256
    bpy.context.view_layer.update()
    eye = scene.camera.matrix_world.to_3x3() @ Vector((0.0, 0.0, 1.0))
    assert abs(math.degrees(math.atan2(eye.y, eye.x)) + 42.0) < 0.5, name
    shown = [
        obj for obj in scene.objects if obj.type == "MESH" and material in [*obj.data.materials]
    ]
    seen = [
        world_to_camera_view(scene, scene.camera, corner)
        for obj in shown
        for corner in corners(obj)
    ]
    assert all(0.0 < point.x < 1.0 and 0.0 < point.y < 1.0 for point in seen), name


for each in OBJECTS:
    check(each)
    check_picture(each)
