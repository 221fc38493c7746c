# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures on the side: a copy of a scene with a camera of its own, which leaves nothing behind."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import bpy
from mathutils import Matrix

from .view import Frame

NAME = "Nacre Picture"


@contextlib.contextmanager
def scene_aside(
    scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer
) -> Iterator[bpy.types.Scene]:
    """A copy of the scene's settings over the same objects, with this view layer alone."""
    aside = begin_aside(scene, view_layer)
    try:
        yield aside
    finally:
        end_aside(aside)


def begin_aside(scene: bpy.types.Scene, view_layer: bpy.types.ViewLayer) -> bpy.types.Scene:
    aside = scene.copy()
    aside.name = NAME
    for layer in aside.view_layers:
        layer.use = layer.name == view_layer.name
    aside.render.use_compositing = aside.render.use_sequencer = False
    aside.render.use_multiview = False
    aside.render.use_single_layer = False
    aside.render.resolution_percentage = 100
    aside.render.use_file_extension = False
    return aside


def end_aside(aside: bpy.types.Scene) -> None:
    """Also removes the camera that was made for it."""
    camera = aside.camera
    bpy.data.scenes.remove(aside)
    if camera is not None and camera.name.startswith(NAME) and camera.users == 0:
        data = camera.data
        bpy.data.objects.remove(camera)
        if data.users == 0:
            bpy.data.cameras.remove(data)


def use_view(aside: bpy.types.Scene, frame: Frame, view_matrix: Matrix) -> None:
    """Looks through a camera that shows the view's frame."""
    data = bpy.data.cameras.new(NAME)
    data.type = "PERSP" if frame.is_perspective else "ORTHO"
    data.sensor_fit = frame.sensor_fit
    if frame.is_perspective:
        data.lens = frame.lens_mm
        data.sensor_width = data.sensor_height = frame.sensor_mm
    else:
        data.ortho_scale = frame.extent
    data.shift_x, data.shift_y = frame.shift
    data.clip_start, data.clip_end = frame.clip
    camera = bpy.data.objects.new(NAME, data)
    camera.matrix_world = view_matrix.inverted() @ Matrix.Translation((0.0, 0.0, frame.back))
    aside.collection.objects.link(camera)
    aside.camera = camera
    aside.render.pixel_aspect_x = aside.render.pixel_aspect_y = 1.0


def use_sharp_copy(aside: bpy.types.Scene) -> None:
    """The scene's camera without depth of field."""
    camera = aside.camera.copy()
    camera.name = NAME
    camera.data = aside.camera.data.copy()
    camera.data.dof.use_dof = False
    aside.collection.objects.link(camera)
    aside.camera = camera
