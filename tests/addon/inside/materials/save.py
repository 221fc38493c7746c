# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Saves a file with both forms and renders it: arguments FOLDER FORM MATERIAL."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs.extension import load
from jobs.steps import new_file, render

folder, form, name = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
extension = load()
extension.register()
cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.world = bpy.data.worlds.new("World")
scene.world.color = (1.0, 0.8, 0.6)
bpy.ops.object.camera_add(location=(2.5, -3.0, 2.0), rotation=(1.1, 0.0, 0.69))
scene.camera = bpy.context.object
bpy.context.view_layer.objects.active = cube
cube.select_set(True)
bpy.ops.nacre.assign_material(material=name, form=form)
bpy.ops.object.light_add(type="SUN", rotation=(0.6, 0.3, 0.0))
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "saved.blend"))
render(folder / "with.exr")
extension.unregister()
