# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""For scripts that run inside Blender, whether or not it knows the extension."""

from __future__ import annotations

from pathlib import Path

import bpy


def new_file() -> bpy.types.Object:
    """A scene with one cube, which is active."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.object


def refused(call, *messages: str) -> None:
    """Holds that an operator, or a function that touches files, fails with one of these in its words."""
    try:
        call()
    except (RuntimeError, OSError) as error:  # an ERROR report is a RuntimeError
        said = str(error)
    else:
        said = "nothing"
    assert any(message in said for message in messages), said


def render(path: Path) -> None:
    scene = bpy.context.scene
    scene.cycles.samples = 4
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.render.resolution_x = scene.render.resolution_y = 24
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def pixels(path: Path) -> list[float]:
    image = bpy.data.images.load(str(path), check_existing=False)
    values = image.pixels[:]
    bpy.data.images.remove(image)
    return list(values)
