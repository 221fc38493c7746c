# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An object in the studio of *Light the Scene*, on a floor that fades into the grey of that world."""

from __future__ import annotations

import math

import bpy
from mathutils import Vector

from ...lighting.world import light_scene
from .light import camera
from .objects import OBJECTS
from .objects.portrayed import EYE_AZIMUTH_DEG, Portrayed, corners
from .shape import lathe, plain, principled
from .stage import Stage, StageError, place_on

_LENS_MM, _SENSOR_MM = 85.0, 36.0
_FLOOR = (0.075, 0.075, 0.075)  # about as bright in the studio as the studio's own ground
_FLOOR_RADII = (1.4, 5.0)  # where it begins to fade, and is gone


def build(scene: bpy.types.Scene, object_name: str = "bauble") -> Stage:
    if object_name not in OBJECTS:
        raise StageError(f"no object {object_name!r}; there are: {', '.join(sorted(OBJECTS))}")
    portrayed = OBJECTS[object_name](scene)
    light_scene(scene, portrayed.light, 1.0, math.radians(portrayed.light_turn_deg))
    if not (portrayed.has_ground or portrayed.floats):
        _floor(scene)
    _aim(scene, portrayed)
    scene.cycles.max_bounces = scene.cycles.transmission_bounces = 24
    scene.cycles.transparent_max_bounces = 32
    return Stage(scene, place_on(*portrayed.objects), size=(512, 512))


def _aim(scene: bpy.types.Scene, portrayed: Portrayed) -> None:
    """Puts the camera so far away that the object fills its part of a square picture."""
    azimuth, elevation = math.radians(EYE_AZIMUTH_DEG), math.radians(portrayed.elevation_deg)
    towards = Vector(
        (
            math.cos(elevation) * math.cos(azimuth),
            math.cos(elevation) * math.sin(azimuth),
            math.sin(elevation),
        )
    )
    right = Vector((-math.sin(azimuth), math.cos(azimuth), 0.0))
    up = towards.cross(right)
    points = [p for obj in (*portrayed.objects, *portrayed.props) for p in corners(obj)]
    middle = Vector()
    for axis in (right, up, towards):
        along = [point.dot(axis) for point in points]
        middle += 0.5 * (min(along) + max(along)) * axis
    slope = portrayed.fill * 0.5 * _SENSOR_MM / _LENS_MM
    distance = max(
        (point - middle).dot(towards) + abs((point - middle).dot(axis)) / slope
        for point in points
        for axis in (right, up)
    )
    camera(scene, tuple(middle + distance * towards), tuple(middle), lens_mm=_LENS_MM)


def _floor(scene: bpy.types.Scene) -> None:
    near, far = _FLOOR_RADII
    floor = lathe(scene, "Floor", ((far, -0.002), (0.0, -0.002)), segments=64)
    material = plain("Floor", _FLOOR, roughness=0.6)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    place = nodes.new("ShaderNodeTexCoord")
    distance = nodes.new("ShaderNodeVectorMath")
    distance.operation = "LENGTH"
    fade = nodes.new("ShaderNodeMapRange")
    fade.interpolation_type = "SMOOTHERSTEP"
    for name, value in (("From Min", near), ("From Max", far), ("To Min", 1.0), ("To Max", 0.0)):
        fade.inputs[name].default_value = value
    links.new(place.outputs["Object"], distance.inputs[0])
    links.new(distance.outputs["Value"], fade.inputs["Value"])
    links.new(fade.outputs["Result"], principled(material).inputs["Alpha"])
    floor.data.materials.append(material)
