# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The operator in both forms, reuse of groups and tables, mends, reports."""

from __future__ import annotations

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
groups = module("materials.group")


# Under EEVEE the automatic form is nodes, and the engine stays.
cube = new_file()
engine = bpy.context.scene.render.engine
assert bpy.ops.nacre.assign_material(material="test_film") == {"FINISHED"}
first = cube.active_material
assert materials.describe(first).form == "nodes"
assert bpy.context.scene.render.engine == engine

# Under Cycles it is OSL, which is turned on; interpolation and packing of the tables.
bpy.context.scene.render.engine = "CYCLES"
assert bpy.ops.nacre.assign_material(material="test_film", new_slot=True) == {"FINISHED"}
second = cube.active_material
assert len(cube.material_slots) == 2
assert second != first
assert bpy.context.scene.cycles.shading_system
tree = materials.group_node(second).node_tree
image_nodes = [node for node in tree.nodes if node.type == "TEX_IMAGE"]
assert len(image_nodes) == 2
for node in image_nodes:
    assert (node.interpolation, node.extension) == ("Linear", "EXTEND")
    assert node.image.packed_file
    assert node.image.is_float
    assert node.image.colorspace_settings.is_data
    assert tuple(node.image.size) == (8, 4)
script = next(node for node in tree.nodes if node.type == "SCRIPT")
assert script.mode == "INTERNAL"
assert script.bytecode.startswith("OpenShadingLanguage")
assert [s.identifier for s in script.inputs][:3] == ["R_in", "T_in", "thickness_nm"]
assert {s.identifier for s in script.inputs if s.is_linked} == {s.identifier for s in script.inputs}

# The interface carries defaults, ranges, labels.
item = next(i for i in tree.interface.items_tree if i.name == "Thickness (nm)")
assert (item.default_value, item.min_value, item.max_value) == (400.0, 0.0, 1200.0)
for owner in (first, second, tree):
    assert owner[groups.SCHEMA] == groups.SCHEMA_VERSION == 2
    assert owner[groups.MATERIAL] == "test_film"

# Assigning again shares the group and the tables.
counts = len(bpy.data.node_groups), len(bpy.data.images)
bpy.ops.nacre.assign_material(material="test_film")
assert materials.group_node(cube.active_material).node_tree == tree
assert (len(bpy.data.node_groups), len(bpy.data.images)) == counts

# Rebuilding in the other form keeps values and links.
material = cube.active_material
materials.set_values(material, {"thickness_nm": 777.0})
value = material.node_tree.nodes.new("ShaderNodeValue")
material.node_tree.links.new(value.outputs[0], materials.input_socket(material, "roughness"))
assert bpy.ops.nacre.rebuild_material(form="nodes") == {"FINISHED"}
assert materials.describe(material).form == "nodes"
assert materials.input_socket(material, "thickness_nm").default_value == 777.0
assert materials.input_socket(material, "roughness").links[0].from_node == value

# A table that is gone is found out and made again.
broken = materials.group_node(material).node_tree
next(node for node in broken.nodes if node.type == "TEX_IMAGE").image = None
assert materials.missing_tables(material) == ("R",)
assert bpy.ops.nacre.rebuild_material() == {"FINISHED"}
assert materials.missing_tables(material) == ()

# A wavelength per path: motion blur with a shutter of 0; a shutter that is in use is kept.
cube = new_file()
scene = bpy.context.scene
bpy.ops.nacre.assign_material(material="test_grating")
assert scene.render.engine == "CYCLES"
assert scene.cycles.shading_system
assert scene.render.use_motion_blur
assert scene.render.motion_blur_shutter == 0.0
scene.render.motion_blur_shutter = 0.5
curve = scene.render.motion_blur_shutter_curve
curve.curves[0].points[0].location.y = 0.0
curve.update()
assert bpy.ops.nacre.use_wavelengths() == {"FINISHED"}
assert scene.render.motion_blur_shutter == 0.5
assert all(point.location.y == 1.0 for point in curve.curves[0].points)

# The mends.
problems = module("materials.problems")
state = module("materials.scene").state
scene.render.engine = engine
scene.cycles.shading_system = False
scene.render.use_motion_blur = False
found = problems.find_problems(materials.describe(cube.active_material), state(scene))
assert [p.operator for p in found] == ["nacre.use_cycles", "nacre.use_osl", "nacre.use_wavelengths"]
for problem in found:
    assert getattr(bpy.ops.nacre, problem.operator.split(".")[1])() == {"FINISHED"}
assert problems.find_problems(materials.describe(cube.active_material), state(scene)) == []

# Refusals report and leave everything as it was.
before = [slot.material for slot in cube.material_slots], len(bpy.data.materials)
refused(
    lambda: bpy.ops.nacre.assign_material(material="test_grating", form="nodes"), "no form as nodes"
)
assert before == ([slot.material for slot in cube.material_slots], len(bpy.data.materials))
bpy.ops.object.empty_add()
for obj in bpy.context.selected_objects:
    obj.select_set(False)
refused(lambda: bpy.ops.nacre.assign_material(material="test_film"), "Select an object")
extension.unregister()
