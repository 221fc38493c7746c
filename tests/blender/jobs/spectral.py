# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectral scenes inside Blender."""

from __future__ import annotations

from pathlib import Path

import bpy

from . import extension
from .pictures import empty_scene


def chart(
    *, reflectances: list[str], lights: list[str], file: str, size: int, samples: int, passes: int
) -> dict:
    """Patches in a row under each light in turn, seen from above; one row of the picture a light.

    A white world of one light cannot be had together with others, so each row is an emission: the
    light times the reflectance, as a furnace would show it.
    """
    groups = extension.module("spectral.groups")
    described = extension.module("spectral.described").Described
    scene = empty_scene()
    columns, rows = len(reflectances), len(lights)
    for row, light in enumerate(lights):
        for column, reflectance in enumerate(reflectances):
            material = bpy.data.materials.new(f"{light} {reflectance}")
            material.use_nodes = True
            tree = material.node_tree
            tree.nodes.clear()
            both = tree.nodes.new("ShaderNodeVectorMath")
            both.operation = "MULTIPLY"
            for socket, name in zip(both.inputs, (light, reflectance), strict=False):
                node = tree.nodes.new("ShaderNodeGroup")
                node.node_tree = groups.spectrum_group(described.named(name))
                tree.links.new(node.outputs[0], socket)
            emission = tree.nodes.new("ShaderNodeEmission")
            out = tree.nodes.new("ShaderNodeOutputMaterial")
            tree.links.new(both.outputs[0], emission.inputs["Color"])
            tree.links.new(emission.outputs[0], out.inputs["Surface"])
            mesh = bpy.data.meshes.new("patch")
            x, y = float(column), -float(row)
            corners = [(x, y, 0), (x + 1, y, 0), (x + 1, y - 1, 0), (x, y - 1, 0)]
            mesh.from_pydata(corners, [], [(3, 2, 1, 0)])
            mesh.materials.append(material)
            scene.collection.objects.link(bpy.data.objects.new("patch", mesh))
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = float(max(columns, rows))
    camera.location = (columns / 2, -rows / 2, 5.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = size * columns, size * rows
    scene.render.filter_size = 0.01
    return rendered(scene, file, samples, passes)


def rendered(scene: bpy.types.Scene, file: str, samples: int, passes: int) -> dict:
    plan = extension.module("spectral.plan")
    groups = extension.module("spectral.groups")
    made = plan.make(groups.found_spectra(), passes or None)
    extension.module("spectral.rendering").render(scene, made, samples, Path(file))
    return {"passes": made.passes, "left": [key for key in scene.keys() if "nacre" in key]}  # noqa: SIM118
