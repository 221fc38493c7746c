# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Camera, lamps and environment of the stages."""

from __future__ import annotations

import math

import bpy
from mathutils import Vector

from ...blender.space import here
from ...lighting.world import environment_picture

Point = tuple[float, float, float]


def environment(
    scene: bpy.types.Scene,
    name: str,
    *,
    strength: float,
    turn_deg: float = 0.0,
    seen: float | None = None,
    small_lamps: bool = False,
) -> None:
    """One of the environments that come with Blender (CC0); `seen` is its strength for the camera.
    Lamps of a few pixels are noisy unless they are said to be there."""
    world = bpy.data.worlds.new(name.title())
    world.use_nodes = True
    scene.world = world
    nodes, links = world.node_tree.nodes, world.node_tree.links
    background = next(node for node in nodes if node.type == "BACKGROUND")
    coordinates = nodes.new("ShaderNodeTexCoord")
    mapping = nodes.new("ShaderNodeMapping")
    mapping.inputs["Rotation"].default_value[2] = math.radians(turn_deg)
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = environment_picture(f"{name}.exr")
    # Left to itself, Cycles looks in 16 times as many directions as there are pixels before each
    # render, which takes longer than a small render does.
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = (2 if small_lamps else 1) * picture.image.size[0]
    links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], picture.inputs["Vector"])
    links.new(picture.outputs["Color"], background.inputs["Color"])
    background.inputs["Strength"].default_value = strength
    if seen is None:
        return
    path = nodes.new("ShaderNodeLightPath")
    choice = nodes.new("ShaderNodeMapRange")
    choice.inputs["To Min"].default_value = strength
    choice.inputs["To Max"].default_value = seen
    links.new(path.outputs["Is Camera Ray"], choice.inputs["Value"])
    links.new(choice.outputs["Result"], background.inputs["Strength"])


def camera(
    scene: bpy.types.Scene,
    eye: Point,
    target: Point,
    *,
    lens_mm: float = 85.0,
    f_stop: float | None = None,
) -> None:
    data = bpy.data.cameras.new("Camera")
    data.lens = lens_mm
    if f_stop is not None:
        data.dof.use_dof = True
        data.dof.aperture_fstop = f_stop
        data.dof.focus_distance = (Vector(target) - Vector(eye)).length
    obj = _aimed("Camera", data, eye, target)
    scene.collection.objects.link(obj)
    scene.camera = obj


def area_lamp(
    scene: bpy.types.Scene,
    location: Point,
    target: Point,
    *,
    size: tuple[float, float],
    watts: float,
    colour: Point = (1.0, 1.0, 1.0),
) -> bpy.types.Object:
    data = bpy.data.lights.new("Lamp", "AREA")
    data.shape = "RECTANGLE"
    data.size, data.size_y = size
    data.energy, data.color = watts, here(colour)
    obj = _aimed("Lamp", data, location, target)
    scene.collection.objects.link(obj)
    return obj


def _aimed(name: str, data, location: Point, target: Point) -> bpy.types.Object:
    obj = bpy.data.objects.new(name, data)
    obj.location = location
    direction = Vector(target) - Vector(location)
    obj.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()
    return obj
