# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes whose paths draw their wavelengths."""

from __future__ import annotations

from pathlib import Path

import bpy

from .. import extension
from ..furnace import film
from .scenes import by_paths, rendered, room


def full_room(*, folder: str, size: int, samples: int, moves: bool) -> dict:
    """A room with a film, a soap bubble and a ball of dense flint in it, in bands (bands.exr) and by paths
    (paths.exr); what was changed by that. `moves`: a glowing ball moves while the shutter is open."""
    scene = room()
    sphere = extension.module("background.scenes.shape").sphere
    for number, (material, form) in enumerate(
        (("tempered_steel", "nodes"), ("soap_film", "nodes"), ("sf11", "osl"))
    ):
        place = (-0.55 + 0.35 * number, -0.5, 0.4 + 0.5 * number)
        item = sphere(scene, material, place, 0.28, rings=48)
        made = film(scene, {"material": material, "form": form, "values": {}})
        item.data.materials.append(made)
    if moves:
        ball = next(item for item in scene.objects if "Sphere" in item.name)
        for frame, x in ((1, 0.0), (2, 0.6)):
            ball.location.x = x
            ball.keyframe_insert("location", frame=frame)
        scene.render.use_motion_blur, scene.render.motion_blur_shutter = True, 1.0
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.caustics_refractive = scene.cycles.caustics_reflective = False
    extension.module("spectral.convert").make_spectral()
    rendered(scene, str(Path(folder) / "bands.exr"), samples, 0)
    before = _state(scene)
    said = by_paths(scene, str(Path(folder) / "paths.exr"), samples)
    after = _state(scene)
    return {**said, "changed": [name for name in before if before[name] != after[name]]}


def _state(scene: bpy.types.Scene) -> dict:
    render, curve = scene.render, scene.render.motion_blur_shutter_curve.curves[0]
    links = sorted(
        (group.name, link.from_node.name, link.to_node.name, link.to_socket.identifier)
        for group in bpy.data.node_groups
        for link in group.links
    )
    return {
        "links": links,
        "tables": sorted(image.name for image in bpy.data.images if image.source == "GENERATED"),
        "shutter": (render.use_motion_blur, render.motion_blur_shutter),
        "curve": [tuple(point.location) for point in curve.points],
        "osl": scene.cycles.shading_system,
        "compositing": render.use_compositing,
    }
