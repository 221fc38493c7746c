# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a source of a thickness gives, for scripts that run inside Blender."""

from __future__ import annotations

from pathlib import Path

import bpy

from .steps import new_file


def camera_over_cube() -> bpy.types.Object:
    """A scene whose camera looks down on the top of a cube, which it is within."""
    cube = new_file()
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location.z = 5.0
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = 1.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    return cube


def close(a: float, b: float, tolerance: float = 1e-3) -> bool:
    return abs(a - b) <= tolerance * max(1.0, abs(b))


def measure(node, values: dict, at=(0.0, 0.0, 0.0)) -> float:
    """What a source gives at a place."""
    return measure_all(node, values, 4, at)[0]


def measure_all(node, values: dict, size: int, at=(0.0, 0.0, 0.0)) -> list[float]:
    """What a source gives at each pixel of a square: rendered as emission, one sample each."""
    for name, value in values.items():
        node.inputs[name].default_value = value
    tree = node.id_data
    for name in ("probe", "probe out", "probe at"):
        if name in tree.nodes:
            tree.nodes.remove(tree.nodes[name])
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.name = "probe"
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.name = "probe out"
    output.is_active_output = True
    tree.links.new(node.outputs[0], emission.inputs["Strength"])
    tree.links.new(emission.outputs[0], output.inputs["Surface"])
    if "Vector" in node.inputs:
        place = tree.nodes.new("ShaderNodeCombineXYZ")
        place.name = "probe at"
        for socket, value in zip(place.inputs, at, strict=True):
            socket.default_value = value
        tree.links.new(place.outputs[0], node.inputs["Vector"])
    scene = bpy.context.scene
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.shading_system = False
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(Path(bpy.app.tempdir) / "probe.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath, check_existing=False)
    reds = list(image.pixels[:])[::4]
    bpy.data.images.remove(image)
    return reds
