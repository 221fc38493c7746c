# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Light for an empty world: offered while there is nothing to mirror, removed without a trace."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy
from mathutils import Vector

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
lighting = module("lighting.world")
LIGHTS = [key for key, _, _ in module("lighting.rooms").LIGHTS]
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

# Cards that things mirror, and that are not seen themselves: towards one the world is as dark as beside it,
# in a mirror it is bright.
scene = bpy.context.scene
seen = module("lighting.rooms").ROOMS["WINDOW"].softboxes[-1]
assert seen.is_hidden
bpy.ops.nacre.light_scene(light="WINDOW")
for obj in list(scene.objects):
    bpy.data.objects.remove(obj)
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.data.lens = 300.0
scene.collection.objects.link(camera)
scene.camera = camera


def looking(azimuth_deg: float, elevation_deg: float) -> float:
    around, up = math.radians(azimuth_deg), math.radians(elevation_deg)
    towards = Vector(
        (math.cos(up) * math.cos(around), math.cos(up) * math.sin(around), math.sin(up))
    )
    camera.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()
    return pixel(scene)


def pixel(scene) -> float:
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 4
    scene.render.resolution_x = scene.render.resolution_y = 4
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.filepath = str(folder / "pixel.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath, check_existing=False)
    value = image.pixels[0]
    bpy.data.images.remove(image)
    return value


direct = looking(seen.azimuth_deg, seen.elevation_deg)
assert direct < 0.1, direct
# A mirror across the view, which turns it to the other side.
bpy.ops.mesh.primitive_plane_add(size=4.0)
mirror = bpy.context.object
shiny = bpy.data.materials.new("Mirror")
shiny.use_nodes = True
shader = shiny.node_tree.nodes["Principled BSDF"]
shader.inputs["Metallic"].default_value, shader.inputs["Roughness"].default_value = 1.0, 0.0
shader.inputs["Base Color"].default_value = (1.0, 1.0, 1.0, 1.0)
mirror.data.materials.append(shiny)
around = math.radians(seen.azimuth_deg)
out = Vector((math.cos(around), math.sin(around), 0.0))
mirror.rotation_euler = out.to_track_quat("Z", "Y").to_euler()
mirror.location = -3.0 * out + Vector((0.0, 0.0, -3.0 * math.tan(math.radians(30.0))))
mirrored = looking(seen.azimuth_deg + 180.0, seen.elevation_deg)
assert mirrored > 5.0 * direct, (direct, mirrored)
