# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A material of a kind that the extension has never heard of: what its manifest says is what is done."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
traits = module("materials.traits").traits
Closure = module("core.traits").Closure
build_stage = module("background.scenes").build_stage
mist = module("core.manifest").load_folder(Path(sys.argv[1], "test_mist"))


def fed(material, place: str) -> set[str]:
    """The outputs of the material's group that lead there, through sums."""
    pending = [material.node_tree.get_output_node("CYCLES").inputs[place]]
    found = set()
    while pending:
        for link in pending.pop().links:
            if link.from_node.type == "ADD_SHADER":
                pending += link.from_node.inputs
            else:
                assert link.from_node == materials.group_node(material)
                found.add(link.from_socket.name)
    return found


def of_closures(*closures: tuple[str, str]):
    said = dataclasses.replace(mist.traits, closures=tuple(Closure(*pair) for pair in closures))
    return dataclasses.replace(mist, traits=said, digest=str(closures))


# Each closure goes where its role belongs, also after the group was made anew.
material = materials.create_material(mist, "nodes")
for _ in range(2):
    assert fed(material, "Surface") == {"BSDF", "Glow"}
    assert fed(material, "Volume") == {"Inside"}
    assert not fed(material, "Displacement")
    materials.rebuild_material(material, mist, "nodes")
for closures, surface, volume in (
    ([("Inside", "volume")], set(), {"Inside"}),
    ([("Glow", "emission")], {"Glow"}, set()),
    ([("Glow", "emission"), ("Inside", "volume")], {"Glow"}, {"Inside"}),
):
    material = materials.create_material(of_closures(*closures), "nodes")
    assert (fed(material, "Surface"), fed(material, "Volume")) == (surface, volume), closures

# What was linked by hand stays.
tree = material.node_tree
by_hand = tree.nodes.new("ShaderNodeBsdfTransparent")
surface = tree.get_output_node("CYCLES").inputs["Surface"]
tree.links.new(by_hand.outputs[0], surface)
materials.rebuild_material(material, mist, "nodes")
assert [link.from_node for link in surface.links] == [by_hand]

# It has no layers to edit and nothing to probe, and is shown as it says.
cube = new_file()
material = materials.create_material(mist, "nodes")
cube.data.materials.append(material)
assert materials.kind(material) == "mist"
assert traits(material) == mist.traits
refused(bpy.ops.nacre.edit_stack, "The active material is not a film")
for name in ("NACRE_PT_stack", "NACRE_PT_shader_editor_stack"):
    assert not getattr(bpy.types, name).poll(bpy.context)
assert module("viewer.field_nodes").thickness_of(material).unit_nm == 0.0
assert module("variations.pictures").subject(material) is None
for furnace, is_mesh in (("body", True), ("surface", False)):
    stage = build_stage("furnace")
    said = dataclasses.replace(mist.traits, furnace=furnace)
    stage.place(
        materials.create_material(dataclasses.replace(mist, traits=said, digest=furnace), "nodes")
    )
    sphere = stage.scene.objects["Sphere"]
    assert (bool(sphere.data.polygons), not sphere.modifiers) == (is_mesh, is_mesh)
extension.unregister()
