# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Materials linked from another file: shown, refused, left alone; local ones do not lean on them."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
groups = module("materials.group")
stack = module("films.edited")
recipes = module("materials.recipe")
live = module("films.live")
fallback = module("materials.fallback")
folder = Path(sys.argv[1])
source = folder / "shot.blend"


def everything(material) -> tuple:
    tree = materials.group_node(material).node_tree
    images = [node.image for node in tree.nodes if node.type == "TEX_IMAGE"]
    return (
        {key: value for key, value in material.items() if key.startswith("nacre_")},
        {key: value for key, value in tree.items() if key.startswith("nacre_")},
        [(image.name, image.size[:], sum(image.pixels[:64])) for image in images],
        [socket.is_linked for socket in materials.group_node(material).inputs],
    )


new_file()
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
edited = bpy.context.object.active_material
edited.name = "Shot Oil"
bpy.ops.nacre.edit_stack()
edited.nacre.substrate = "Au/Johnson"
bpy.ops.wm.save_as_mainfile(filepath=str(source))  # compiled by that

cube = new_file()
with bpy.data.libraries.load(str(source), link=True) as (_, wanted):
    wanted.materials = ["Shot Oil"]
linked = wanted.materials[0]
assert linked.library is not None
cube.data.materials.append(linked)
before = everything(linked)
for call in (
    bpy.ops.nacre.edit_stack,
    bpy.ops.nacre.add_layer,
    bpy.ops.nacre.revert_stack,
    bpy.ops.nacre.finish_stack,
    lambda: bpy.ops.nacre.vary_layer(index=0),
    lambda: bpy.ops.nacre.load_template(filepath="none.toml"),
    lambda: bpy.ops.nacre.add_thickness(source="drop"),
    bpy.ops.nacre.remove_thickness,
    bpy.ops.nacre.rebuild_material,
):
    refused(call, "linked from shot.blend: make it local first")
live.finish_all()
live._after_undo()
fallback.put_in_place()
assert everything(linked) == before

# A local material of the same kind has a group and tables of its own.
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes", new_slot=True)
local = cube.active_material
tree = materials.group_node(local).node_tree
assert tree.library is None
assert all(node.image.library is None for node in tree.nodes if node.type == "TEX_IMAGE")
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "scene.blend"))
bpy.ops.wm.open_mainfile(filepath=str(folder / "scene.blend"))
linked = bpy.data.materials["Shot Oil"]
assert linked.library is not None
assert everything(linked) == before

# Made local it can be edited, and its source stays as it is.
cube = bpy.data.objects["Cube"]
bpy.context.view_layer.objects.active = cube
cube.active_material_index = 0
assert cube.active_material == linked
local = linked.make_local()
cube.material_slots[0].material = local
assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
local.nacre.substrate = "Ag/Johnson"
assert live.problem(local) == ""
assert bpy.ops.nacre.finish_stack() == {"FINISHED"}
assert materials.group_node(local).node_tree.library is None
with bpy.data.libraries.load(str(source), link=True) as (_, wanted):
    wanted.materials = ["Shot Oil"]
assert '"Au/Johnson"' in wanted.materials[0][recipes.TEMPLATE]

# A linked object says why it takes none; one of its own with linked data, or a library override,
# holds the material itself, and the data stay.
new_file().data.materials.append(bpy.data.materials.new("Paint"))
bpy.ops.mesh.primitive_plane_add()
bpy.context.object.name = "Bare"
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "set.blend"))
bpy.ops.wm.read_homefile(use_empty=True)
with bpy.data.libraries.load(str(folder / "set.blend"), link=True) as (_, wanted):
    wanted.objects = ["Bare", "Cube"]
bare, cube = wanted.objects
collection, active = bpy.context.scene.collection, bpy.context.view_layer.objects
collection.objects.link(bare)
active.active = bare
refused(
    lambda: bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes"),
    "Bare is linked from set.blend: make it local first",
)
plane = bpy.data.objects.new("Plane", bare.data)  # no slot of its own
collection.objects.link(plane)
active.active = plane
refused(
    lambda: bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes"),
    "Plane is linked from set.blend: make it local first",
)
others = list(cube.data.materials)
assert others
for holder in (bpy.data.objects.new("Local", cube.data), cube.override_create()):
    collection.objects.link(holder)
    active.active = holder
    for new_slot in (False, True):  # linked data have no room for another
        assert bpy.ops.nacre.assign_material(
            material="oil_on_water", form="nodes", new_slot=new_slot
        ) == {"FINISHED"}
    assert [slot.link for slot in holder.material_slots] == ["OBJECT"]
    assert materials.describe(holder.active_material).form == "nodes"
    assert list(cube.data.materials) == others
extension.unregister()
