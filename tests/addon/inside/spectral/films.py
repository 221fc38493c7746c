# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films in a spectral file: those that are there, that are assigned, edited, copied; and what is animated."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()
marks, films, plan = module("spectral.marks"), module("spectral.films"), module("spectral.plan")
groups, materials = module("materials.group"), module("materials.material")
spectral_groups, operators = module("spectral.groups"), module("spectral.operators")
stack = module("films.edited")
folder = Path(sys.argv[1])


def tree_of(material: bpy.types.Material) -> bpy.types.NodeTree:
    return materials.group_node(material).node_tree


def readers(tree: bpy.types.NodeTree) -> list[bpy.types.NodeTree]:
    return [node.node_tree for node in tree.nodes if node.type == "GROUP"]


def picture_of(reader: bpy.types.NodeTree) -> bpy.types.Image | None:
    return next(node.image for node in reader.nodes if node.type == "TEX_IMAGE")


cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
assert bpy.ops.nacre.assign_material(material="oil_on_water", form="osl") == {"FINISHED"}
in_osl = cube.active_material
former = tree_of(in_osl)
former_name, names = former.name, (in_osl.name, "Moving")
assert former.get(groups.FORM) == "osl"
materials.set_values(in_osl, {"thickness_nm": 77.0})

# Keyframes on a colour, and a driver on another.
moving = bpy.data.materials.new("Moving")
moving.use_nodes = True
principled = next(node for node in moving.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
colour = principled.inputs["Base Color"]
for frame, red in ((1, 0.1), (10, 0.9)):
    colour.default_value = (red, 0.2, 0.1, 1.0)
    colour.keyframe_insert("default_value", frame=frame)
tint = principled.inputs["Coat Tint"]
driver = tint.driver_add("default_value", 0).driver
driver.expression = "0.25"
cube.data.materials.append(moving)
path, tint_path = (socket.path_from_id("default_value") for socket in (colour, tint))
animation = module("blender.animation")
assert animation.is_animated(colour)
assert animation.is_animated(tint)

lamp = bpy.data.lights.new("Lamp", "POINT")
lamp.color = (1.0, 0.5, 0.2)
lamp.keyframe_insert("color", frame=1)
scene.collection.objects.link(bpy.data.objects.new("Lamp", lamp))

assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
assert [(remark.kind, remark.name) for remark in operators.remarks()] == [("lamp", "Lamp")]

# What was in OSL is in nodes, of the same values, and reads its tables in bands.
in_nodes = tree_of(in_osl)
assert in_nodes.get(groups.FORM) == "nodes"
assert films.is_banded(in_nodes)
assert materials.input_socket(in_osl, "thickness_nm").default_value == 77.0
assert len(readers(in_nodes)) > 2
assert all(picture_of(reader) is None for reader in readers(in_nodes))

# Keyframes and drivers go where their colour is now, and work there.
assert not animation.is_animated(colour)
source = colour.links[0].from_node
assert animation.is_animated(source.inputs["Color"])
scene.frame_set(10)
assert abs(source.inputs["Color"].default_value[0] - 0.9) < 1e-6
assert animation.is_animated(tint.links[0].from_node.inputs["Color"])

# One that is assigned now is spectral at once; a group that is copied has tables of its own.
bpy.ops.mesh.primitive_cube_add()
assert bpy.ops.nacre.assign_material(material="tempered_steel", form="nodes") == {"FINISHED"}
steel = bpy.context.object.active_material
assert films.is_banded(tree_of(steel))
copy = steel.copy()
materials.group_node(copy).node_tree = tree_of(steel).copy()
bpy.context.object.data.materials.append(copy)

# So is one whose stack is edited; what is made of it is the edited one.
before = {film.tree: film.optical_thickness_nm for film in films.films()}
assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
steel.nacre.layers[0].medium = "abbe 1.9 30"
stack.finish(steel)
assert not stack.is_stale(steel)
edited = tree_of(steel)
assert films.is_banded(edited)
thickness = {film.tree: film.optical_thickness_nm for film in films.films()}
assert abs(thickness[edited] / thickness[tree_of(copy)] - 1.0) > 0.1
assert thickness[tree_of(copy)] == before[tree_of(copy)]

# While a plan is rendered each has a picture of all passes of its own, and none afterwards.
made = plan.make(spectral_groups.found_spectra(), 8, films=films.fringes())
with films.in_bands(made, at_once=True):
    pictures = []
    for tree in (edited, tree_of(copy), in_nodes):
        smooth = next(r for r in readers(tree) if r[marks.BANDED] == "R")
        image = picture_of(smooth)
        original = next(
            node.image for node in tree.nodes
            if node.type == "TEX_IMAGE" and node.image.get("nacre_table") == "R"
        )  # fmt: skip
        assert tuple(image.size) == (original.size[0], 8 * original.size[1])
        assert image.colorspace_settings.is_data
        values = np.empty(4 * image.size[0] * image.size[1], np.float32)
        image.pixels.foreach_get(values)
        pictures.append(values)
    of_edited = readers(edited)
    assert len({picture_of(r).name for r in of_edited}) == len({r.name for r in of_edited}) == 2
    assert pictures[0].shape != pictures[1].shape or np.abs(pictures[0] - pictures[1]).max() > 0.05
    assert all(values.min() >= 0.0 and values.max() <= 1.0 for values in pictures)
assert not [image.name for image in bpy.data.images if "in bands" in image.name]
for tree in (edited, tree_of(copy), in_nodes):
    assert all(picture_of(reader) is None for reader in readers(tree))

# The file is the same another day, and on a machine without the extension nothing is missing.
file = folder / "films.blend"
bpy.ops.wm.save_as_mainfile(filepath=str(file))
bpy.ops.wm.open_mainfile(filepath=str(file))
assert marks.is_spectral()
assert len(films.films()) == 3
assert not [image.name for image in bpy.data.images if image.name.startswith("nacre_missing")]

assert bpy.ops.nacre.make_rgb() == {"FINISHED"}
assert not marks.is_spectral()
in_osl, moving = (bpy.data.materials[name] for name in names)
assert tree_of(in_osl).get(groups.FORM) == "osl"
assert tree_of(in_osl).name == former_name
assert materials.input_socket(in_osl, "thickness_nm").default_value == 77.0
assert groups.FORMER not in materials.group_node(in_osl)
principled = next(node for node in moving.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
colour, tint = principled.inputs["Base Color"], principled.inputs["Coat Tint"]
assert [socket.path_from_id("default_value") for socket in (colour, tint)] == [path, tint_path]
assert animation.is_animated(colour)
assert animation.is_animated(tint)
assert not colour.is_linked
bpy.context.scene.frame_set(10)
assert abs(colour.default_value[0] - 0.9) < 1e-6
assert not [group.name for group in bpy.data.node_groups if group.get(groups.FORM) == "nodes"
            and group.get(groups.MATERIAL) == "oil_on_water"]  # fmt: skip
extension.unregister()
