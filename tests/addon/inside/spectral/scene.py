# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A scene is made spectral, its lamps get spectra, it is saved, rendered, and brought back without a
trace."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
marks, operators = module("spectral.marks"), module("spectral.operators")
folder = Path(sys.argv[1])

BLOCKS = ("worlds", "node_groups", "images", "texts", "materials", "lights")


def blocks() -> set[str]:
    return {f"{kind} {block.name}" for kind in BLOCKS for block in getattr(bpy.data, kind)}


def lamp(name: str, kind: str, colour: tuple) -> bpy.types.Object:
    data = bpy.data.lights.new(name, kind)
    data.color = colour
    placed = bpy.data.objects.new(name, data)
    placed.location = (2.0, -2.0, 3.0)
    bpy.context.scene.collection.objects.link(placed)
    return placed


def state() -> dict:
    """Everything that colours come from: links and values of all shaders, and lamps."""
    found = {}
    for tree in marks.trees():
        for node in tree.nodes:
            for socket in node.inputs:
                key = (tree.id_data.name, tree.name, node.name, socket.identifier)
                links = [
                    (link.from_node.name, link.from_socket.identifier) for link in socket.links
                ]
                value = getattr(socket, "default_value", None)
                try:
                    value = tuple(value)
                except TypeError:
                    value = value if isinstance(value, (int, float, str)) else None
                found[key] = (tuple(links), value)
    for light in bpy.data.lights:
        found[light.name] = tuple(light.color)
    return found


cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.render.resolution_x = scene.render.resolution_y = 16
scene.cycles.samples = 16
scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
scene.camera.location, scene.camera.rotation_euler = (0.0, -6.0, 0.0), (1.5708, 0.0, 0.0)
scene.collection.objects.link(scene.camera)
red = bpy.data.materials.new("Red")
red.use_nodes = True
principled = next(node for node in red.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
principled.inputs["Base Color"].default_value = (0.8, 0.05, 0.02, 1.0)
cube.data.materials.clear()
cube.data.materials.append(red)
# A group of the artist's own, with a colour on its outside.
group = bpy.data.node_groups.new("Paint", "ShaderNodeTree")
group.interface.new_socket("Colour", in_out="INPUT", socket_type="NodeSocketColor")
group.interface.new_socket("Surface", in_out="OUTPUT", socket_type="NodeSocketShader")
inside, paint, out = (
    group.nodes.new(kind) for kind in ("NodeGroupInput", "ShaderNodeBsdfDiffuse", "NodeGroupOutput")
)
group.links.new(inside.outputs[0], paint.inputs["Color"])
group.links.new(paint.outputs[0], out.inputs[0])
painted = bpy.data.materials.new("Painted")
painted.use_nodes = True
painted.node_tree.nodes.new("ShaderNodeGroup").node_tree = group
cube.data.materials.append(painted)
sun, spot = lamp("Sun", "SUN", (1.0, 0.8, 0.6)), lamp("Spot", "SPOT", (0.2, 0.4, 1.0))
with_nodes = lamp("Tinted", "POINT", (1.0, 0.5, 0.5))
with_nodes.data.use_nodes = True
tree = with_nodes.data.node_tree
emission = next(node for node in tree.nodes if node.type == "EMISSION")
body = tree.nodes.new("ShaderNodeBlackbody")
tree.links.new(body.outputs[0], emission.inputs["Color"])
scene.world = bpy.data.worlds.new("Sky")
scene.world.use_nodes = True

refused(bpy.ops.nacre.make_rgb, "No colour of the file has a spectrum")
refused(bpy.ops.nacre.render_spectral, "Make Spectral first")
start, before = blocks(), state()

assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
assert marks.is_spectral()
# A lamp whose colour multiplies what its nodes make cannot have one spectrum for both.
said = [(remark.kind, remark.name) for remark in operators.remarks()]
assert said == [("lamp", "Tinted")], said
assert bpy.ops.nacre.show_rgb(kind="lamp", name="Tinted") == {"FINISHED"}
assert bpy.context.view_layer.objects.active == with_nodes
assert [item.name for item in bpy.context.selected_objects] == ["Tinted"]
assert bpy.ops.nacre.show_rgb(kind="node group", name="Paint") == {"FINISHED"}
assert bpy.context.view_layer.objects.active == cube
refused(lambda: bpy.ops.nacre.give_light(lamp="Cube", light="A"), "is no lamp of the scene")
assert {node.node_tree.name for node in group.nodes if node.type == "GROUP"} == {
    "Mixed Colour as Spectrum"
}
made = state()
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
assert state() == made  # nothing twice

for name, light, shown in (("Sun", "lamp/hps", "high-pressure sodium"), ("World", "D50", "D50")):
    assert bpy.ops.nacre.give_light(lamp=name, light=light) == {"FINISHED"}
    owner = scene.world if name == "World" else scene.objects[name].data
    assert marks.lit_by(owner.node_tree) == shown
assert marks.lit_by(spot.data.node_tree) == ""
# It is the same file on another day, and says so without the extension's help.
file = folder / "spectral.blend"
bpy.ops.wm.save_as_mainfile(filepath=str(file))
bpy.ops.wm.open_mainfile(filepath=str(file))
scene = bpy.context.scene
assert marks.is_spectral()
assert marks.lit_by(scene.objects["Sun"].data.node_tree) == "high-pressure sodium"

picture = folder / "picture.exr"
saved_as = scene.render.image_settings
saved_as.file_format, saved_as.color_mode = "JPEG", "BW"
settings = [scene.cycles.samples, scene.cycles.use_sample_subset, scene.render.use_persistent_data]
assert bpy.ops.nacre.render_spectral(filepath=str(picture)) == {"FINISHED"}
assert settings == [
    scene.cycles.samples, scene.cycles.use_sample_subset, scene.render.use_persistent_data,
]  # fmt: skip
assert (saved_as.file_format, saved_as.color_mode) == ("JPEG", "BW")
assert picture.read_bytes()[:4] == b"\x76\x2f\x31\x01"
assert [path.name for path in folder.iterdir() if "passes" in path.name] == []
shown = bpy.data.images[module("spectral.render_job").RESULT]
assert tuple(shown.size) == (16, 16)
assert max(shown.pixels) > 0.0
assert [key for key in scene.keys() if key.startswith("nacre_")] == []  # noqa: SIM118 of an ID

# In one render, whose paths draw their wavelengths.
by_paths = folder / "by_paths.exr"
assert bpy.ops.nacre.render_spectral(filepath=str(by_paths), mode="PATHS") == {"FINISHED"}
assert by_paths.read_bytes()[:4] == b"\x76\x2f\x31\x01"
assert [
    node for group in bpy.data.node_groups for node in group.nodes if node.type == "SCRIPT"
] == []
assert not scene.render.use_motion_blur

# An animation has a file for each frame; those that are there are left out where the scene says so.
cube = scene.objects["Cube"]
for frame, x in ((1, 0.0), (5, 1.0)):
    cube.location.x = x
    cube.keyframe_insert("location", frame=frame)
scene.frame_start, scene.frame_end, scene.frame_step = 1, 5, 2
scene.frame_set(4)
moving = {"filepath": str(folder / "moving_##.exr"), "bands": 7, "animation": True}
assert bpy.ops.nacre.render_spectral(**moving) == {"FINISHED"}
frames = [folder / f"moving_{frame:02d}.exr" for frame in (1, 3, 5)]
assert sorted(folder.glob("moving*")) == frames
assert scene.frame_current == 4
first, second, third = (frame.read_bytes() for frame in frames)
assert first != second != third
frames[1].unlink()
frames[2].write_bytes(b"kept")
scene.render.use_overwrite = False
assert bpy.ops.nacre.render_spectral(**moving) == {"FINISHED"}
assert [frame.read_bytes() for frame in frames] == [first, second, b"kept"]
refused(lambda: bpy.ops.nacre.render_spectral(**moving), "All frames are there already")
cube.animation_data_clear()
cube.location.x = 0.0
bpy.data.images.remove(shown)

assert bpy.ops.nacre.make_rgb() == {"FINISHED"}
assert not marks.is_spectral()
assert not operators.remarks()
after = state()
# Lamps that had no nodes keep those that Blender made, which it does not look at.
extra = {key for key in after if key not in before}
assert all(isinstance(key, tuple) and key[0] in ("Sun", "Spot") for key in extra), extra
assert {key: after[key] for key in before} == before
assert [bpy.data.lights[name].use_nodes for name in ("Tinted",)] == [True]
assert blocks() - start <= {"images Render Result"}, blocks() ^ start
assert start <= blocks()
extension.unregister()
