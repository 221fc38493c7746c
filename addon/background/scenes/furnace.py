# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Orthographic unit sphere that fills a square frame under a uniform white world.

For a surface the sphere is a point of radius 1, which Cycles intersects exactly: the cosine
at a pixel's centre is sqrt(1 - r^2) within 4e-4 at 128 pixels, where a mesh of 512 x 256 faces is
off by 1.4e-3. Cycles sees a point from outside only: light that passes its front goes on to the
world. A body needs its far side, so there the sphere is that mesh.
"""

from __future__ import annotations

import bpy

from ...core.traits import BODY
from ...materials.traits import traits
from .shape import sphere
from .stage import Stage, place_on


def build(scene: bpy.types.Scene) -> Stage:
    _add_world(scene)
    _add_camera(scene)
    # The least there is: a pixel samples its centre. (Cycles makes a box one pixel wide, always.)
    scene.cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    scene.cycles.filter_width = 0.01
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    scene.cycles.blur_glossy = 0.0
    # Light that a body keeps inside for long would else be missing from the white.
    for kind_of_bounce in ("max", "transmission", "glossy", "transparent_max"):
        setattr(scene.cycles, f"{kind_of_bounce}_bounces", 128)

    def place(material: bpy.types.Material) -> None:
        if traits(material).furnace == BODY:
            place_on(sphere(scene, "Sphere", (0.0, 0.0, 0.0), 1.0, rings=256))(material)
        else:
            _add_point_sphere(scene, material)

    return Stage(scene, place, size=(256, 256), samples=64)


def _add_world(scene: bpy.types.Scene) -> None:
    world = bpy.data.worlds.new("White")
    world.use_nodes = True
    background = next(node for node in world.node_tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    background.inputs["Strength"].default_value = 1.0
    scene.world = world


def _add_camera(scene: bpy.types.Scene) -> None:
    data = bpy.data.cameras.new("Camera")
    data.type = "ORTHO"
    data.ortho_scale = 2.0
    camera = bpy.data.objects.new("Camera", data)
    camera.location = (0.0, 0.0, 4.0)
    scene.collection.objects.link(camera)
    scene.camera = camera


def _add_point_sphere(scene: bpy.types.Scene, material: bpy.types.Material) -> None:
    tree = bpy.data.node_groups.new("Point Sphere", "GeometryNodeTree")
    tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    points = tree.nodes.new("GeometryNodePoints")
    points.inputs["Radius"].default_value = 1.0
    surface = tree.nodes.new("GeometryNodeSetMaterial")
    surface.inputs["Material"].default_value = material
    output = tree.nodes.new("NodeGroupOutput")
    tree.links.new(points.outputs[0], surface.inputs["Geometry"])
    tree.links.new(surface.outputs[0], output.inputs[0])
    sphere = bpy.data.objects.new("Sphere", bpy.data.meshes.new("Sphere"))
    scene.collection.objects.link(sphere)
    sphere.modifiers.new("Point Sphere", "NODES").node_group = tree
