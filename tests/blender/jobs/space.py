# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Furnace spheres in files of other scene-linear spaces.

`space` is one of Blender 5's working spaces, or nothing for that of the configuration. `how` the
material comes there: `assigned`; `changed`, assigned before the file gets its space; `appended` or
`linked` from a file of Rec.709. `reflected`: without what passed a film.
"""

from __future__ import annotations

from pathlib import Path

import bpy

from . import extension
from .furnace import film, keep_all_light, light_by_depth
from .pictures import render_picture

SIZE = 16


def written(job: dict, file: Path) -> None:
    """The material in a file of Rec.709."""
    scene = extension.module("background.scenes").build_stage("furnace").scene
    bpy.data.libraries.write(str(file), {film(scene, job)})


def appended(scene: bpy.types.Scene, job: dict, file: Path) -> bpy.types.Material:
    with bpy.data.libraries.load(str(file), link=job["how"] == "linked") as (theirs, ours):
        ours.materials = theirs.materials
    if job["form"] == "osl":
        extension.module("materials.scene").use_osl(scene)
        extension.module("materials.scene").use_wavelengths(scene)
    return ours.materials[0]


def render(**job) -> list[list[float]]:
    """The matrix from the picture's colours to XYZ."""
    follow = extension.module("materials.follow")
    aside = Path(job["file"]).with_suffix(".blend")
    comes_from_a_file = job["how"] in ("appended", "linked")
    follow.register()
    try:
        if comes_from_a_file:
            written(job, aside)
        bpy.ops.wm.read_homefile(use_empty=True)
        stage = extension.module("background.scenes").build_stage("furnace")
        scene = stage.scene
        if job["how"] != "changed":
            extension.set_space(job["space"])
        material = appended(scene, job, aside) if comes_from_a_file else film(scene, job)
        stage.place(material)
        if job["how"] == "changed":
            extension.set_space(job["space"])
        if job["reflected"]:
            light_by_depth(scene.world, 0)
        keep_all_light(scene)
        render_picture(scene, SIZE, SIZE, job["samples"], job["file"])
        return extension.space_to_xyz()
    finally:
        follow.unregister()


def stage_light(stage: str, file: str) -> list[list[float]]:
    """Only the environment of a stage; the matrix from the picture's colours to XYZ."""
    scene = extension.module("background.scenes").build_stage(stage).scene
    for obj in scene.objects:
        obj.hide_render = True
    render_picture(scene, SIZE, SIZE, 64, file)
    return extension.space_to_xyz()
