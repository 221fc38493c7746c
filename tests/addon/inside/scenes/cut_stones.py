# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The output for EEVEE: of stones as nodes alone, through edits and views, and without a trace in Cycles."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs import eevee
from jobs.extension import load, module
from jobs.steps import new_file, pixels, render

folder = Path(sys.argv[1])
extension = load()
extension.register()
library = module("core.library").Library.default()
materials, cut_stone = module("materials.material"), module("gems.cut_stone")


def outputs(material) -> dict[str, str]:
    """By the engine's name, the socket that it shows."""
    found = {}
    for engine in ("CYCLES", "EEVEE"):
        links = material.node_tree.get_output_node(engine).inputs["Surface"].links
        found[engine] = links[0].from_socket.name if links else ""
    return found


# Lenses, windows, bubbles and opaque gems have none; nor have stones as OSL, which EEVEE does not run.
new_file()
with_output = set()
for material_id in library.entries():
    compiled = library.load(material_id)
    for form in compiled.forms:
        material = materials.create_material(compiled, form)
        shown = outputs(material)
        assert shown["CYCLES"] != cut_stone.SHADER
        if shown["EEVEE"] == cut_stone.SHADER:
            with_output.add((material_id, form))
        else:
            assert shown["EEVEE"] == shown["CYCLES"]
            nodes = material.node_tree.nodes
            assert len([n for n in nodes if n.type == "OUTPUT_MATERIAL"]) == 1, material_id
        materials.discard_material(material, compiled)
assert with_output == {("diamond", "nodes"), ("mystic_topaz", "nodes")}, with_output

for stone in ("diamond", "mystic_topaz"):
    compiled = library.load(stone)
    cube = new_file()
    bpy.context.scene.render.engine = "CYCLES"
    material = materials.create_material(compiled, "nodes")
    cube.data.materials.append(material)
    as_made = outputs(material)
    assert as_made["EEVEE"] == cut_stone.SHADER
    node = materials.group_node(material)
    assert (
        materials.create_material(compiled, "nodes").node_tree.nodes[node.name].node_tree
        == node.node_tree
    )

    # Cycles: every bit as without it.
    module("lighting.world").light_scene(bpy.context.scene, "SOFTBOXES", 1.0, 0.0)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location, camera.rotation_euler = (3.0, -3.0, 2.5), (1.05, 0.0, 0.785)
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera
    render(folder / "with.exr")
    nodes = material.node_tree.nodes
    nodes.remove(nodes[cut_stone.SHADER])
    render(folder / "without.exr")
    assert pixels(folder / "with.exr") == pixels(folder / "without.exr")
    assert max(pixels(folder / "with.exr")) > 0.5

    # Rebuilt, it is back; as OSL it goes; where something lies in between, EEVEE is left to show that.
    materials.rebuild_material(material, compiled, "nodes")
    assert outputs(material) == as_made
    materials.rebuild_material(material, compiled, "osl")
    assert outputs(material)["EEVEE"] == outputs(material)["CYCLES"]
    materials.rebuild_material(material, compiled, "nodes")
    assert outputs(material) == as_made

    # A field is seen in both engines, and goes without a trace.
    scene = bpy.context.scene
    field = module("viewer.fields").FIELDS[0].id
    for engine in ("CYCLES", eevee.engine(scene)):
        scene.render.engine = engine
        module("viewer.views").show(scene, field)
        assert set(outputs(material).values()) == {"Emission"}
        module("viewer.views").show(scene, module("viewer.fields").SHADED)
        assert outputs(material) == as_made

    nodes = material.node_tree.nodes
    mix = nodes.new("ShaderNodeMixShader")
    surface = material.node_tree.get_output_node("CYCLES")
    material.node_tree.links.new(materials.group_node(material).outputs[0], mix.inputs[1])
    material.node_tree.links.new(mix.outputs[0], surface.inputs["Surface"])
    nodes.remove(nodes[cut_stone.SHADER])
    materials.rebuild_material(material, compiled, "nodes")
    assert outputs(material) == {"CYCLES": "Shader", "EEVEE": "Shader"}
extension.unregister()
