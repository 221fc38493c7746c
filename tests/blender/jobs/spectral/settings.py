# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Bands with whatever else a scene of Cycles may have set."""

from __future__ import annotations

from pathlib import Path

import bpy

from .. import extension
from ..pictures import render_picture
from .scenes import rendered, room


def settings(*, folder: str, size: int, samples: int, passes: int) -> dict:
    """A box in bands (plain.exr), denoised (clean.exr), with many samples (truth.exr), and with all that
    gets in the way of passes (awkward.exr); which of the settings were not put back."""
    convert = extension.module("spectral.convert")
    scene = room()
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.cycles.use_adaptive_sampling = False
    convert.make_spectral()
    place = {n: str(Path(folder) / f"{n}.exr") for n in ("plain", "clean", "truth", "awkward")}
    rendered(scene, place["plain"], samples, passes)
    rendered(scene, place["clean"], samples, passes, denoise=True)
    rendered(scene, place["truth"], 64 * samples, passes)
    other = scene.view_layers.new("Other")
    cycles, render = scene.cycles, scene.render
    wanted = [
        (cycles, "use_adaptive_sampling", True),
        (cycles, "use_denoising", True),
        (cycles, "use_animated_seed", True),
        (cycles, "time_limit", 0.001),
        (cycles, "samples", 5),
        (render, "use_compositing", True),
        (render, "use_sequencer", True),
        (render, "use_persistent_data", False),
        (render, "film_transparent", True),
        (other, "use", True),
    ]
    for owner, name, value in wanted:
        setattr(owner, name, value)
    rendered(scene, place["awkward"], samples, passes)
    return {
        "changed": [name for owner, name, value in wanted if getattr(owner, name) != value and
                    abs(getattr(owner, name) - value) > 1e-6],
    }  # fmt: skip


def tried(*, what: str, folder: str, size: int, samples: int, triples: int) -> dict:
    """A room in RGB (before.exr), with another seed (again.exr), and in bands (bands.exr)."""
    scene = room()
    _TRIED[what](scene)
    places = {name: str(Path(folder) / f"{name}.exr") for name in ("before", "again", "bands")}
    render_picture(scene, size, size, samples, places["before"])
    scene.cycles.seed += 1
    render_picture(scene, size, size, samples, places["again"])
    scene.cycles.seed -= 1
    report = extension.module("spectral.convert").make_spectral()
    said = rendered(scene, places["bands"], samples, triples)
    return {**said, "remarks": [remark.text for remark in report.remarks]}


def _guided(scene) -> None:
    scene.cycles.use_guiding = True
    scene.cycles.guiding_training_samples = 16


def _clamped(scene) -> None:
    scene.cycles.sample_clamp_direct, scene.cycles.sample_clamp_indirect = 1.0, 0.5


def _fog(scene) -> None:
    """Warm mist that fills the room."""
    bpy.ops.mesh.primitive_cube_add(size=1.9, location=(0.0, 0.0, 1.0))
    material = bpy.data.materials.new("mist")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    mist = tree.nodes.new("ShaderNodeVolumePrincipled")
    mist.inputs["Color"].default_value = (0.9, 0.6, 0.3, 1.0)
    mist.inputs["Density"].default_value = 0.4
    out = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(mist.outputs[0], out.inputs["Volume"])
    bpy.context.object.data.materials.append(material)


def _moving(scene) -> None:
    ball = next(item for item in scene.objects if item.type == "MESH" and "Sphere" in item.name)
    for frame, x in ((1, -0.4), (2, 0.4)):
        ball.location.x = x
        ball.keyframe_insert("location", frame=frame)
    scene.render.use_motion_blur = True
    scene.render.motion_blur_shutter = 1.0


def _layered(scene) -> None:
    """The first of two view layers lacks the ball."""
    ball = next(item for item in scene.objects if item.type == "MESH" and "Sphere" in item.name)
    kept = bpy.data.collections.new("kept")
    scene.collection.children.link(kept)
    kept.objects.link(ball)
    scene.collection.objects.unlink(ball)
    scene.view_layers[0].layer_collection.children["kept"].exclude = True
    scene.view_layers.new("With Ball").use = False


def _deep(scene) -> None:
    scene.camera.data.dof.use_dof = True
    scene.camera.data.dof.aperture_fstop = 0.5
    scene.camera.data.dof.focus_distance = 4.0


_TRIED = {
    "path guiding": _guided,
    "clamping": _clamped,
    "volumes": _fog,
    "motion blur": _moving,
    "view layers": _layered,
    "depth of field": _deep,
}
