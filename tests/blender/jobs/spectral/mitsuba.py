# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes as support/mitsuba_scenes.py describes them, inside Blender."""

from __future__ import annotations

import math
from pathlib import Path

import bpy
from mathutils import Vector

from .. import extension
from ..furnace import film, keep_all_light
from ..pictures import empty_scene, render_picture
from .scenes import matt, rendered


def render(*, described: dict, folder: str, samples: int) -> dict:
    """In RGB with an eighth of the samples (rgb.exr), and in as many bands as the scene needs (bands.exr)."""
    scene = empty_scene()
    surfaces = {
        name: _material(scene, name, surface) for name, surface in described["surfaces"].items()
    }
    for item in described["meshes"]:
        mesh = bpy.data.meshes.new(item["surface"])
        mesh.from_pydata(item["vertices"], [], item["faces"])
        mesh.materials.append(surfaces[item["surface"]])
        scene.collection.objects.link(bpy.data.objects.new(item["surface"], mesh))
    _look(scene, **described["camera"])
    _keep_everything(scene)
    render_picture(scene, *described["size"], samples // 8, str(Path(folder) / "rgb.exr"))
    report = extension.module("spectral.convert").make_spectral()
    said = rendered(scene, str(Path(folder) / "bands.exr"), samples, 0)
    return {**said, "remarks": [remark.text for remark in report.remarks]}


def _material(scene: bpy.types.Scene, name: str, surface: dict) -> bpy.types.Material:
    if surface["kind"] == "matt":
        return matt(surface["reflectance"])
    if surface["kind"] == "film":
        return film(scene, {**surface, "form": "nodes"})
    return _light(name, surface["light"], surface["luminance"])


def _light(name: str, light: str, luminance: float) -> bpy.types.Material:
    described = extension.module("spectral.described").Described.named(light)
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.cycles.emission_sampling = "FRONT"
    tree = material.node_tree
    tree.nodes.clear()
    spectrum, emission, out = (
        tree.nodes.new(f"ShaderNode{kind}") for kind in ("Group", "Emission", "OutputMaterial")
    )
    spectrum.node_tree = extension.module("spectral.groups").spectrum_group(described)
    spectrum.inputs["Luminance"].default_value = luminance
    tree.links.new(spectrum.outputs[0], emission.inputs["Color"])
    tree.links.new(emission.outputs[0], out.inputs["Surface"])
    return material


def _look(scene: bpy.types.Scene, *, at: list, to: list, angle_deg: float) -> None:
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = at
    camera.rotation_euler = (Vector(to) - Vector(at)).to_track_quat("-Z", "Y").to_euler()
    camera.data.sensor_fit, camera.data.angle = "HORIZONTAL", math.radians(angle_deg)
    camera.data.clip_start = 1e-3
    scene.collection.objects.link(camera)
    scene.camera = camera


def _keep_everything(scene: bpy.types.Scene) -> None:
    """Nothing is cut off, or blurred to find light the sooner; a pixel is what falls into it."""
    keep_all_light(scene)
    cycles = scene.cycles
    cycles.diffuse_bounces = 64
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = cycles.light_sampling_threshold = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
