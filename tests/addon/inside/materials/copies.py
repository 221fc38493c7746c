# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Copies, names and ids that coincide; overrides and linked groups; the extension turned off at work."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
groups = module("materials.group")
stack = module("films.edited")
recipes = module("materials.recipe")
live = module("films.live")
folder = Path(sys.argv[1])


def tree_of(material) -> bpy.types.NodeTree:
    return materials.group_node(material).node_tree


def texels(material) -> np.ndarray:
    nodes = tree_of(material).nodes
    image = next(n.image for n in nodes if n.type == "TEX_IMAGE" and n.image["nacre_table"] == "R")
    values = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(values)
    return values


def assigned(*, edit: bool = True) -> bpy.types.Material:
    cube = new_file()
    bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
    if edit:
        bpy.ops.nacre.edit_stack()
    return cube.active_material


def owned_alone(*some) -> None:
    trees = [tree_of(material) for material in some]
    images = [{n.image for n in tree.nodes if n.type == "TEX_IMAGE"} for tree in trees]
    for index, tree in enumerate(trees):
        assert tree not in trees[:index]
        assert not any(images[index] & others for others in images[:index])


# A copy of an edited material goes its own way, before and after it is compiled.
first = assigned()
first.nacre.substrate = "Au/Johnson"
second = first.copy()  # while the first holds quick tables
gold = texels(first)
second.nacre.substrate = "Ag/Johnson"
assert np.array_equal(texels(first), gold)
assert np.abs(texels(second) - gold).max() > 0.05
live.finish_all()
third = second.copy()
silver = texels(second)
third.nacre.layers[0].medium = "2.2"
live.finish_all()
assert np.array_equal(texels(second), silver)
assert stack.stack_of(first).substrate == "Au/Johnson"
assert stack.stack_of(second).layers[0].medium == "abbe 1.47 50"
owned_alone(first, second, third)
assert not any(map(stack.is_stale, (first, second, third)))

# Two of one recipe and one name: compiled once, shared again, parted by the next edit.
twin = first.copy()
twin.name = first.name
bpy.context.object.active_material = first
bpy.ops.nacre.rebuild_material()
assert np.array_equal(texels(twin), texels(first))
twin.nacre.substrate = "copper"  # by its name
assert twin.nacre.substrate == "Cu/Johnson"
assert stack.stack_of(first).substrate == "Au/Johnson"
owned_alone(first, twin)

# A group that was renamed, or made single user, is still a group of ours.
material = assigned(edit=False)
library_texels = texels(material)
tree_of(material).name = "Mein Öl"
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
assert tree_of(bpy.context.object.active_material) == tree_of(material)
node = materials.group_node(material)
node.node_tree = node.node_tree.copy()
bpy.context.object.active_material = material
assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
material.nacre.substrate = "Au/Johnson"
live.finish_all()
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes", new_slot=True)
assert np.array_equal(texels(bpy.context.object.active_material), library_texels)

# One id, two contents, as from libraries of different versions: told apart by content.
compiled = module("core.library").Library.default().load("oil_on_water")
text = compiled.template.replace("water/Daimon-20C", "Au/Johnson")
assert text != compiled.template
other = recipes.compile_recipe(recipes.Recipe(text), "oil_on_water")
assert other.id == compiled.id
new_file()
ours, theirs = (materials.create_material(item, "nodes") for item in (compiled, other))
assert (ours.name, theirs.name) == (compiled.name, f"{compiled.name}.001")
owned_alone(ours, theirs)
assert np.abs(texels(ours)[:1000] - texels(theirs)[:1000]).max() > 1e-3

# A local material around a linked group: edits make a group of its own.
material = assigned(edit=False)
material.name = "Lent"
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "lent.blend"))
group_name = tree_of(material).name
cube = new_file()
with bpy.data.libraries.load(str(folder / "lent.blend"), link=True) as (_, wanted):
    wanted.node_groups = [group_name]
lent = wanted.node_groups[0]
local = bpy.data.materials.new("Local")
local.use_nodes = True
local.node_tree.nodes.new("ShaderNodeGroup").node_tree = lent
cube.data.materials.append(local)
before = dict(lent.items())
assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
local.nacre.substrate = "Au/Johnson"
assert tree_of(local).library is None
live.finish_all()
assert bpy.ops.nacre.rebuild_material() == {"FINISHED"}
assert dict(lent.items()) == before

# A library override: shown, and refused in words, as its nodes come back from the library.
cube = new_file()
with bpy.data.libraries.load(str(folder / "lent.blend"), link=True) as (_, wanted):
    wanted.materials = ["Lent"]
override = wanted.materials[0].override_create()
cube.data.materials.append(override)
assert override.is_editable
for call in (
    bpy.ops.nacre.edit_stack,
    bpy.ops.nacre.rebuild_material,
    lambda: bpy.ops.nacre.add_thickness(source="drop"),
):
    refused(call, "library override from lent.blend: make it local first")
assert recipes.TEMPLATE not in override

# Turned off while a compilation runs: that is waited for and put in place; nothing is left behind.
material = assigned()
live._has_timers = lambda: True
live.WAIT = 0.0
material.nacre.substrate = "Ti/Johnson"
assert live.progress(material) is not None
time.sleep(0.01)
assert live._tick() is not None
assert live._jobs, "no compilation runs"
extension.unregister()
assert not live._jobs
assert not stack.is_stale(material)
assert not any(map(bpy.app.timers.is_registered, (live._tick, live._resume)))

# Edits that were left quick are taken up again: when it is turned on, and when a file is opened.
extension.register()
assert bpy.app.timers.is_registered(live._resume)
material.nacre.substrate = "Cu/Johnson"
live._forget()
live._resume()
assert live.progress(material) is not None
extension.unregister()
assert stack.is_stale(material)
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "quick.blend"))
extension.register()
bpy.ops.wm.open_mainfile(filepath=str(folder / "quick.blend"))
material = bpy.data.objects["Cube"].active_material
assert live.progress(material) is not None

# An edit that is damaged while it is compiled ends the job, and no more.
live._tick()
assert live._jobs
material[recipes.TEMPLATE] = 7
live._wait()
assert live.progress(material) is None
assert not live._jobs
extension.unregister()
