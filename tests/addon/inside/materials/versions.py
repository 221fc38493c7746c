# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Files of other versions, damaged properties, keyframes over a change of sockets, the extension off
and on again."""

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
schema = module("materials.schema")
stack = module("films.edited")
recipes = module("materials.recipe")
traits = module("materials.traits").traits
live = module("films.live")
problems = module("materials.problems")
folder = Path(sys.argv[1])
BLEND = folder / "Älter 薄膜.blend"


def assigned() -> bpy.types.Material:
    cube = new_file()
    bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
    return cube.active_material


def reopened() -> bpy.types.Material:
    bpy.ops.wm.save_as_mainfile(filepath=str(BLEND))
    bpy.ops.wm.open_mainfile(filepath=str(BLEND))
    cube = bpy.data.objects["Cube"]
    bpy.context.view_layer.objects.active = cube
    return cube.active_material


def tree_of(material) -> bpy.types.NodeTree:
    return materials.group_node(material).node_tree


def pictures(tree) -> list[bpy.types.Image]:
    return [node.image for node in tree.nodes if node.type == "TEX_IMAGE"]


# Older: what is missing is filled in, and the stack can be edited.
for before in (None, 1):
    tree = tree_of(assigned())
    template = tree[groups.TEMPLATE_TEXT]
    tables = [image["nacre_table"] for image in pictures(tree)]
    del tree[groups.TEMPLATE_TEXT], tree[groups.SCHEMA]
    if before is not None:
        tree[groups.SCHEMA] = before
    for image in set(pictures(tree)):
        del image["nacre_table"]
    tree = tree_of(reopened())
    assert tree[groups.SCHEMA] == groups.SCHEMA_VERSION
    assert tree[groups.TEMPLATE_TEXT] == template
    assert [image["nacre_table"] for image in pictures(tree)] == tables
    assert schema.migrate() == []
    assert bpy.ops.nacre.edit_stack() == {"FINISHED"}

# Older ones do not say what may be asked of them: their template tells, or else the library's.
for damage in (None, 7, "{ broken", {"a": 1}, '{"closures": []}'):
    for has_template in (True, False):
        material = assigned()
        tree = tree_of(material)
        said = traits(material)
        assert said.editable_stack
        del tree[groups.TRAITS]
        if damage is not None:
            tree[groups.TRAITS] = damage
        if not has_template:
            del tree[groups.TEMPLATE_TEXT]
        assert traits(material) == said
        assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
material = assigned()
tree = tree_of(material)
del tree[groups.TRAITS]
tree[groups.TEMPLATE_TEXT] = "[grooves]\npitch_nm = 1600.0\n"
assert not traits(material).editable_stack
refused(bpy.ops.nacre.edit_stack, "not a film")

# Made from a template that the library has no longer: as it is, and editing says what to do.
tree = tree_of(assigned())
del tree[groups.TEMPLATE_TEXT]
tree[groups.SCHEMA], tree[groups.TEMPLATE] = 1, "0" * 64
tree = tree_of(reopened())
assert groups.TEMPLATE_TEXT not in tree

# Newer: said in words, refused, left alone.
material = assigned()
tree = tree_of(material)
tree[groups.SCHEMA] = groups.SCHEMA_VERSION + 1
material = reopened()
tree = tree_of(material)
contents = dict(tree.items())
state = module("materials.scene").state(bpy.context.scene, ())
first = problems.find_problems(materials.describe(material), state)[0]
assert "newer Nacre" in first.text
assert first.operator is None
for call in (
    bpy.ops.nacre.edit_stack,
    bpy.ops.nacre.rebuild_material,
    lambda: bpy.ops.nacre.add_thickness(source="drop"),
):
    refused(call, "newer Nacre")
live.finish_all()
assert dict(tree_of(material).items()) == contents
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
assert tree_of(bpy.context.object.active_material) != tree  # not taken for one of ours

# Damaged names of sockets: mended, with the values.
material = assigned()
materials.set_values(material, {"thickness_nm": 123.0})
tree_of(material)[groups.SOCKETS] = "{ broken"
assert materials.input_socket(material, "thickness_nm") is None
assert bpy.ops.nacre.rebuild_material() == {"FINISHED"}
assert materials.input_socket(material, "thickness_nm").default_value == 123.0

# A damaged stack: said, kept out of every handler, reverted.
for damaged in (7, "schema = ["):
    material = assigned()
    bpy.ops.nacre.edit_stack()
    material[recipes.TEMPLATE] = damaged
    assert stack.damage(material) != ""
    assert not stack.is_stale(material)
    live.finish_all()
    live._after_undo()
    assert bpy.ops.nacre.revert_stack() == {"FINISHED"}
    assert not recipes.is_edited(material)

# Keyframes and drivers go with their sockets, whose numbers change.
material = assigned()
roughness = materials.input_socket(material, "roughness")
coverage = materials.input_socket(material, "coverage")
roughness.default_value = 0.1
roughness.keyframe_insert("default_value", frame=1)
roughness.default_value = 0.5
roughness.keyframe_insert("default_value", frame=11)
coverage.driver_add("default_value").driver.expression = "frame / 20"
bpy.ops.nacre.edit_stack()
assert bpy.ops.nacre.vary_layer(index=0) == {"FINISHED"}  # one thickness: its socket goes
stack.finish(material)
assert materials.input_socket(material, "thickness_nm") is None
for form in ("osl", "nodes"):
    assert bpy.ops.nacre.rebuild_material(form=form) == {"FINISHED"}
    bpy.context.scene.frame_set(6)
    evaluated = material.evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert abs(materials.input_socket(evaluated, "coverage").default_value - 0.3) < 1e-6
    seen = materials.input_socket(evaluated, "roughness").default_value
    assert 0.1 < seen < 0.5, seen

# Off with an edit that was not compiled, opened without the extension, on again.
material.nacre.substrate = "Au/Johnson"
assert stack.is_stale(material)
name = material.name
extension.unregister()
bpy.ops.wm.save_as_mainfile(filepath=str(BLEND))
bpy.ops.wm.open_mainfile(filepath=str(BLEND))
extension.register()
material = bpy.data.materials[name]
bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]
assert '"Au/Johnson"' in material[recipes.TEMPLATE]
assert stack.is_stale(material)
assert bpy.ops.nacre.finish_stack() == {"FINISHED"}
assert not stack.is_stale(material)
extension.unregister()
