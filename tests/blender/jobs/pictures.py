# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders the scene at hand into a file."""

from __future__ import annotations

from pathlib import Path

import bpy

from . import extension


def empty_scene(space: str = "") -> bpy.types.Scene:
    """For Cycles, in a file of that working space, if not what it has."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.context.scene.render.engine = "CYCLES"
    extension.set_space(space)
    return bpy.context.scene


def render_picture(
    scene: bpy.types.Scene, width: int, height: int, samples: int, file: str
) -> None:
    """Every pixel gets all its samples, and nothing is smoothed."""
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.cycles.samples = samples
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    bpy.ops.render.render()
    extension.module("blender.output").Writer(scene).save(Path(file))
