# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Light for an empty world: offered while there is nothing to mirror, removed without a trace."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
from steps import new_file, refused

from jobs.extension import load, module

extension = load()
extension.register()
lighting = module("nodes.lighting")
LIGHTS = [key for key, _, _ in module("core.lighting").LIGHTS]
folder = Path(sys.argv[1])


def blocks() -> dict[str, int]:
    kinds = ("worlds", "node_groups", "images", "texts", "materials")
    return {kind: len(getattr(bpy.data, kind)) for kind in kinds}


# What is of one colour all around, and what is not.
new_file()
scene = bpy.context.scene
assert scene.world is None
assert lighting.is_plain(None)
grey = bpy.data.worlds.new("Grey")
assert lighting.is_plain(grey)
grey.use_nodes = True
assert lighting.is_plain(grey)
tree = grey.node_tree
sky = tree.nodes.new("ShaderNodeTexSky")
assert lighting.is_plain(grey)
background = next(node for node in tree.nodes if node.type == "BACKGROUND")
tree.links.new(sky.outputs[0], background.inputs["Color"])
assert not lighting.is_plain(grey)
tree.nodes.remove(sky)
tree.nodes.remove(next(node for node in tree.nodes if node.type == "OUTPUT_WORLD"))
assert lighting.is_plain(grey)

# Each of them, one after the other: the first world stays in mind, and nothing else is left.
refused(bpy.ops.nacre.remove_light, "no light of Nacre's")
for before in (grey, None):
    scene.world = before
    start = blocks()
    for light in LIGHTS:
        assert bpy.ops.nacre.light_scene(light=light, strength=1.5, rotation=0.25) == {"FINISHED"}
        node = lighting.light_of(scene.world)
        assert (scene.world != before, scene.world["nacre_light"]) == (True, light)
        assert not lighting.is_plain(scene.world)
        assert node.inputs["Strength"].default_value == 1.5
        assert abs(node.inputs["Rotation"].default_value - 0.25) < 1e-6
        assert len(bpy.data.worlds) == start["worlds"] + 1
        assert all(link.is_valid for link in node.node_tree.links)
    assert bpy.ops.nacre.remove_light() == {"FINISHED"}
    assert scene.world == before
    assert blocks() == start, (blocks(), start)

# A scene beside this one goes on in its light.
scene.world = grey
bpy.ops.nacre.light_scene(light="WINDOW")
other = bpy.data.scenes.new("Other")
other.world = scene.world
bpy.ops.nacre.remove_light()
assert scene.world == grey
assert lighting.light_of(other.world) is not None

# Undone in one step; in files it knows what was there before.
bpy.ops.ed.undo_push(message="before")
assert bpy.ops.nacre.light_scene("EXEC_DEFAULT", True, light="SKY") == {"FINISHED"}
bpy.ops.ed.undo()
scene = bpy.context.scene
assert scene.world.name == "Grey"
bpy.ops.nacre.light_scene(light="STUDIO")
file = str(folder / "lit.blend")
bpy.ops.wm.save_as_mainfile(filepath=file)
bpy.ops.wm.open_mainfile(filepath=file)
scene = bpy.context.scene
assert lighting.light_of(scene.world) is not None
assert bpy.ops.nacre.remove_light() == {"FINISHED"}
assert scene.world.name == "Grey"

# A light whose node was taken out by hand is a world as any other.
bpy.ops.nacre.light_scene(light="STUDIO")
scene.world.node_tree.nodes.clear()
assert lighting.light_of(scene.world) is None
assert lighting.is_plain(scene.world)
assert bpy.ops.nacre.light_scene(light="SKY") == {"FINISHED"}
