# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A thousand materials of one kind share what they can; and after any order of edits, undo and redo
what is stored, shown and rendered agrees."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()
materials = module("materials.material")
stack = module("films.edited")
recipes = module("materials.recipe")
live = module("films.live")
thickness = module("thickness.nodes")
folder = Path(sys.argv[1])
SEED, STEPS, COUNT = 20261125, 60, 1000


def red_mean(material) -> float:
    """Of the table R, wherever the edit is compiled or quick."""
    nodes = materials.group_node(material).node_tree.nodes
    image = next(n.image for n in nodes if n.type == "TEX_IMAGE" and n.image["nacre_table"] == "R")
    values = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(values)
    return float(values[::4].mean())


def assert_agreement(material) -> None:
    stored = stack.stack_of(material)
    shown = material.nacre
    if recipes.is_edited(material):
        assert [layer.medium for layer in shown.layers] == [x.medium for x in stored.layers]
        assert shown.substrate == stored.substrate
        assert shown.varying == (-1 if stored.varying is None else stored.varying)
        assert live.problem(material) == "", live.problem(material)
    assert materials.missing_tables(material) == ()
    tree = materials.group_node(material).node_tree
    names = materials.groups.socket_identifiers(tree)
    assert ("thickness_nm" in names) == (
        stack.read_stack(tree["nacre_template"]).varying is not None
    )


cube = new_file()
compiled = module("core.library").Library.default().load("oil_on_water")
for _ in range(COUNT):
    materials.create_material(compiled, "nodes")
assert len(bpy.data.materials) == COUNT
assert len(bpy.data.node_groups) == 1
read = {node.table for node in compiled.graphs["nodes"].nodes if node.table}
assert len(bpy.data.images) == len(read)
for material in bpy.data.materials:
    material.use_fake_user = True
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "many.blend"))
bpy.ops.wm.open_mainfile(filepath=str(folder / "many.blend"))
assert len(bpy.data.materials) == COUNT
# An edit of one leaves the others' group as it is.
cube = bpy.data.objects["Cube"]
bpy.context.view_layer.objects.active = cube
first, second = bpy.data.materials[0], bpy.data.materials[1]
cube.data.materials.append(first)
before = red_mean(second)
bpy.ops.nacre.edit_stack()
first.nacre.substrate = "Au/Johnson"
assert abs(red_mean(first) - before) > 0.1
assert red_mean(second) == before
assert len(bpy.data.node_groups) == 2

# Handlers read no template and compile nothing where nothing changed; of many, only what did.
live.finish_all()
others = [material for material in bpy.data.materials if material != first]
for number, material in enumerate(others[:100]):
    own = recipes.Recipe(f"# {number}\n{recipes.recipe(material).template}")
    node = materials.group_node(material)
    node.node_tree = node.node_tree.copy()
    node.node_tree["nacre_recipe"] = own.digest
    material[recipes.TEMPLATE] = own.template
calls = []
real_read, real_compile = stack.read_stack, stack.compile_recipe
stack.read_stack = lambda *a: calls.append("read") or real_read(*a)
stack.compile_recipe = lambda *a: calls.append("compile") or real_compile(*a)
stack._damage.cache_clear()
live._after_undo()
live.finish_all()
assert calls == [], calls
first.nacre.substrate = "Ag/Johnson"
calls.clear()
live.finish_all()
assert calls.count("compile") == 1, calls
assert calls.count("read") <= 4, calls
stack.read_stack, stack.compile_recipe = real_read, real_compile

# Icons of materials seen before make room; the one in use stays.
icons = module("blender.icons")
drawn = []


def blank(*key):
    drawn.append(key)
    return np.zeros((4, 4, 4), np.float32)


for number in range(3 * icons.MOST_ICONS):
    icons.drawn("in use", ("in use",), blank)
    icons.drawn(f"{number}", (number,), blank)
assert len(icons._collections[0]) == len(icons._shown) == icons.MOST_ICONS
assert drawn.count(("in use",)) == 1
assert len(drawn) == 3 * icons.MOST_ICONS + 1

cube = new_file()
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
name = cube.active_material.name
bpy.ops.nacre.edit_stack()
bpy.ops.ed.undo_push(message="start")
chance = random.Random(SEED)
print("seed", SEED)
depth, most = 0, 0
for step in range(STEPS):
    material = bpy.data.materials[name]
    bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]
    what = chance.choice(
        (
            "substrate",
            "thickness",
            "layer",
            "remove",
            "vary",
            "form",
            "source",
            "undo",
            "undo",
            "redo",
        )
    )
    layers = material.nacre.layers
    if what == "undo" and depth > 0:
        bpy.ops.ed.undo()
        depth -= 1
    elif what == "redo" and depth < most:
        bpy.ops.ed.redo()
        depth += 1
    elif what not in ("undo", "redo"):
        if what == "substrate":
            material.nacre.substrate = chance.choice(
                ("Au/Johnson", "Ag/Johnson", "1.5", "Ti/Johnson")
            )
        elif what == "thickness":
            layers[chance.randrange(len(layers))].thickness_nm = chance.uniform(10.0, 400.0)
        elif what == "layer" and len(layers) < 4:
            bpy.ops.nacre.add_layer()
        elif what == "remove" and len(layers) > 1:
            bpy.ops.nacre.remove_layer()
        elif what == "vary":
            bpy.ops.nacre.vary_layer(index=chance.randrange(len(layers)))
        elif what == "form":
            bpy.ops.nacre.rebuild_material(form=chance.choice(("osl", "nodes")))
        elif what == "source" and thickness.thickness_socket(material) is not None:
            bpy.ops.nacre.add_thickness(source=chance.choice(("drop", "swirl")))
        bpy.ops.ed.undo_push(message=what)
        depth += 1
        most = depth
    print(step, what, depth, most)
    assert_agreement(bpy.data.materials[name])

# At rest: what was last asked for, compiled, is what another material of that stack has.
material = bpy.data.materials[name]
live.finish_all()
assert not stack.is_stale(material)
wanted = recipes.recipe(material)
other = recipes.compile_recipe(wanted, "other")
expected = float(np.asarray(other.texels["R"])[..., 0].mean())
assert abs(red_mean(material) - expected) < 1e-6, (red_mean(material), expected)
extension.unregister()
