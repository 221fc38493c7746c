# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A table that is gone: flat grey when the file is opened, named in the panel, mended by the operator."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, pixels, render

extension = load()
extension.register()
materials = module("materials.material")
folder, form = Path(sys.argv[1]), sys.argv[2]

cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
world = bpy.data.worlds.new("White")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
scene.world = world
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.location.z = 5.0
camera.data.type = "ORTHO"
camera.data.ortho_scale = 1.0
scene.collection.objects.link(camera)
scene.camera = camera
bpy.ops.nacre.assign_material(material="test_film", form=form)
whole = folder / "whole.exr"
render(whole)
material = cube.active_material
assert materials.missing_tables(material) == ()
for node in materials.group_node(material).node_tree.nodes:
    if node.type == "TEX_IMAGE":
        bpy.data.images.remove(node.image)
name = material.name
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "gone.blend"))
bpy.ops.wm.open_mainfile(filepath=str(folder / "gone.blend"))

material = bpy.data.materials[name]
bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]
gone = materials.missing_tables(material)
assert gone, gone
flat = folder / "flat.exr"
render(flat)
red, green, blue = pixels(flat)[:3]
assert abs(red - green) < 0.02, (red, green, blue)
assert abs(red - 1.0) < 0.02, red  # half reflected and half let through, all of it white
state = module("materials.scene").state(bpy.context.scene, gone)
problems = module("materials.problems").find_problems(materials.describe(material), state)
assert any("Shown flat" in problem.text for problem in problems)

# Opened once more it stays so; mended it is as it was.
bpy.ops.wm.save_mainfile()
bpy.ops.wm.open_mainfile(filepath=str(folder / "gone.blend"))
material = bpy.data.materials[name]
bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]
assert materials.missing_tables(material) == gone
assert bpy.ops.nacre.rebuild_material() == {"FINISHED"}
assert materials.missing_tables(material) == ()
again = folder / "again.exr"
render(again)
assert all(abs(a - b) < 1e-6 for a, b in zip(pixels(whole), pixels(again), strict=True))
extension.unregister()
