# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The stack editor: edits are seen at once, compiled later, stored, undone, saved, reverted."""

from __future__ import annotations

import sys
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
form = sys.argv[2]
folder = Path(sys.argv[1])


def image_of(material, name):
    nodes = materials.group_node(material).node_tree.nodes
    return next(n.image for n in nodes if n.type == "TEX_IMAGE" and n.image["nacre_table"] == name)


def texels(material, name="R"):
    image = image_of(material, name)
    width, height = image.size
    values = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(height, width, 4)[..., :3].copy()


cube = new_file()
bpy.context.scene.render.engine = "CYCLES"
bpy.ops.nacre.assign_material(material="oil_on_water", form=form)
material = cube.active_material
bystander = material.copy()  # shares the group
refused(bpy.ops.nacre.add_layer, "Start with Edit Stack")
library_texels = texels(material)

# Taken out of the library as it is: nothing is stale, nothing changes.
assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
shown = material.nacre
assert [layer.medium for layer in shown.layers] == ["abbe 1.47 50"]
assert (shown.ambient, shown.substrate) == ("air", "water/Daimon-20C")
assert (shown.varying, shown.low_nm, shown.high_nm) == (0, 0.0, 200.0)
assert not stack.is_stale(material)
assert live.problem(material) == ""

# Values and links are the artist's.
socket = module("thickness.nodes").thickness_socket(material)
socket.default_value = 111.0
value = material.node_tree.nodes.new("ShaderNodeValue")
roughness = materials.input_socket(material, "roughness")
material.node_tree.links.new(value.outputs[0], roughness)

# An edit is in the texels at once, and only in this material's.
shown.substrate = "Au/Johnson"
assert live.problem(material) == "", live.problem(material)
assert stack.is_stale(material)
quick = texels(material)
assert np.abs(quick - library_texels).max() > 0.2
assert np.array_equal(texels(bystander), library_texels)
assert materials.group_node(bystander).node_tree != materials.group_node(material).node_tree
assert '"Au/Johnson"' in material["nacre_template"]

# The whole material: close to the quick tables, values and links kept, old data gone.
assert bpy.ops.nacre.finish_stack() == {"FINISHED"}
assert not stack.is_stale(material)
node = materials.group_node(material)
assert node.node_tree[groups.FORM] == form
final = texels(material)
assert final.shape[2] == 3
assert np.abs(final[0, -1] - quick[0, -1]).max() < 0.02, (final[0, -1], quick[0, -1])
assert module("thickness.nodes").thickness_socket(material).default_value == 111.0
assert materials.input_socket(material, "roughness").is_linked
assert not materials.missing_tables(material)
used = {n.node_tree for m in bpy.data.materials for n in m.node_tree.nodes if n.type == "GROUP"}
assert set(bpy.data.node_groups) == used, [g.name for g in bpy.data.node_groups]

# Back to the library's stack: its texels again, which come from a file there and from memory here.
corners = np.ix_((0, -1), (0, -1))
shown.substrate = "water/Daimon-20C"
assert np.abs(texels(material)[corners] - library_texels[corners]).max() < 0.002
assert bpy.ops.nacre.finish_stack() == {"FINISHED"}
assert np.abs(texels(material)[corners] - library_texels[corners]).max() < 2**-13
assert np.abs(library_texels[-1, -1] - library_texels[0, -1]).max() > 0.01
shown.substrate = "Au/Johnson"
assert bpy.ops.nacre.finish_stack() == {"FINISHED"}

# Layers: added, moved, varied, removed; the slider follows its layer.
assert bpy.ops.nacre.add_layer() == {"FINISHED"}
assert [layer.medium for layer in shown.layers] == ["abbe 1.47 50", "SiO2/Malitson"]
assert bpy.ops.nacre.move_layer(direction="UP") == {"FINISHED"}
assert [layer.medium for layer in shown.layers] == ["SiO2/Malitson", "abbe 1.47 50"]
assert (shown.varying, shown.active) == (1, 0)
shown.layers[0].medium = "2.1+0.01i"
shown.layers[0].thickness_nm = 62.5
assert live.problem(material) == ""
stored = stack.stack_of(material)
assert (stored.layers[0].medium, stored.layers[0].thickness_nm) == ("2.1+0.01i", 62.5)
before = texels(material)
shown.layers[0].thickness_nm = 80.0
assert np.abs(texels(material) - before).max() > 0.01
assert bpy.ops.nacre.vary_layer(index=0) == {"FINISHED"}
assert shown.varying == 0
stack.finish(material)
assert module("thickness.nodes").thickness_range(
    module("thickness.nodes").thickness_socket(material)
) == (0.0, 160.0)
assert bpy.ops.nacre.remove_layer() == {"FINISHED"}
assert (len(shown.layers), shown.varying) == (1, -1)
stack.finish(material)
assert module("thickness.nodes").thickness_socket(material) is None
for _ in range(63):
    bpy.ops.nacre.add_layer()
refused(bpy.ops.nacre.add_layer, "at most 64 layers")
while len(shown.layers) > 1:
    bpy.ops.nacre.remove_layer()

# What is wrong is said, and changes nothing that is seen.
before = texels(material)
shown.substrate = "unobtainium/X"
assert "unobtainium/X" in live.problem(material)
assert np.array_equal(texels(material), before)
shown.substrate = ""
assert "must be named" in live.problem(material)
shown.substrate = "Ag/Johnson"
assert live.problem(material) == ""

# The search offers media by key and by name; what is chosen becomes the key.
search = module("films.properties")._media_search("substrate")
assert "Cu/Johnson · Copper" in search(shown, None, "copper")
assert "Cu/Johnson · Copper" in search(shown, None, "cu john")
assert search(shown, None, "copper unobtainium") == []
everything = search(shown, None, "")
assert "air" in everything
# A field that was opened and not typed in yet hands over what it holds.
assert search(shown, None, shown.substrate) == everything
shown.substrate = "Cu/Johnson · Copper"
assert shown.substrate == "Cu/Johnson"
assert stack.stack_of(material).substrate == "Cu/Johnson"
kept = shown.layers[0].medium
shown.layers[0].medium = "TiO2/Sarkar · Titanium dioxide, film"
assert (shown.layers[0].medium, live.problem(material)) == ("TiO2/Sarkar", "")
shown.layers[0].medium, shown.substrate = kept, "Ag/Johnson"

# Another technique is seen at once; one outside its domain is told, and changes nothing.
assert shown.technique == "multilayer"
before = texels(material)
shown.technique = "opaque_base"
assert live.problem(material) == "", live.problem(material)
assert np.abs(texels(material) - before).max() < 1e-3  # exact
before = texels(material)
shown.technique = "airy"
assert 'with technique "airy"' in live.problem(material), live.problem(material)
assert np.array_equal(texels(material), before)
shown.technique = "path_difference"
assert live.problem(material) == "", live.problem(material)
assert np.abs(texels(material) - before).mean() > 0.02
assert 'technique = "path_difference"' in material["nacre_template"]
properties = module("films.properties")
numbers = [item[3] for item in properties.TECHNIQUES]
assert numbers == list(range(8))  # stored in files
assert properties.TECHNIQUES[1][0] == "path_difference"
shown.technique = "multilayer"
assert "technique" not in material["nacre_template"]

# Undo takes the step back, texels too, in a file that was never saved.
stack.finish(material)
whole, name = texels(material), material.name
bpy.ops.ed.undo_push(message="before")
shown.substrate = "Cu/Johnson"
bpy.ops.ed.undo_push(message="edit")
assert np.abs(texels(material) - whole).max() > 0.05
bpy.ops.ed.undo()
material = bpy.data.materials[name]
shown = material.nacre
assert shown.substrate == "Ag/Johnson"
assert np.array_equal(texels(material), whole), np.abs(texels(material) - whole).max()
assert not stack.is_stale(material)

# Light and observer are part of the recipe.
before = texels(material)
shown.illuminant = "A"
assert np.abs(texels(material) - before).max() > 0.005
assert material["nacre_illuminant"] == "A"
stack.finish(material)

# The other form, from the same recipe.
other = {"osl": "nodes", "nodes": "osl"}[form]
assert bpy.ops.nacre.rebuild_material(form=other) == {"FINISHED"}
assert materials.group_node(material).node_tree[groups.FORM] == other
assert not stack.is_stale(material)
assert materials.input_socket(material, "roughness").is_linked

# Saved while stale: compiled first. Opened again it is whole, and can go on.
shown.layers[0].medium = "TiO2/Sarkar"
assert stack.is_stale(material)
blend = folder / "Schichten é.blend"
bpy.ops.wm.save_as_mainfile(filepath=str(blend))
assert not stack.is_stale(material)
name, saved = material.name, texels(material)
bpy.ops.wm.open_mainfile(filepath=str(blend))
material = bpy.data.materials[name]
assert np.array_equal(texels(material), saved)
assert not stack.is_stale(material)
assert material.nacre.layers[0].medium == "TiO2/Sarkar"
bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]

# Undo takes the step back, texels too.
bpy.ops.ed.undo_push(message="before")
material.nacre.layers[0].thickness_nm = 10.0
bpy.ops.ed.undo_push(message="edit")
edited = texels(material)
assert np.abs(edited - saved).max() > 0.01
bpy.ops.ed.undo()
material = bpy.data.materials[name]
assert material.nacre.layers[0].thickness_nm != 10.0
assert np.array_equal(texels(material), saved), np.abs(texels(material) - saved).max()
bpy.ops.ed.redo()
material = bpy.data.materials[name]
assert material.nacre.layers[0].thickness_nm == 10.0
assert np.abs(texels(material) - edited).max() < 0.02

# A template goes out and comes in again.
path = folder / "mine.toml"
assert bpy.ops.nacre.save_template(filepath=str(path)) == {"FINISHED"}
text = path.read_text("utf-8")
assert text == material["nacre_template"]
path.write_text(text.replace("TiO2/Sarkar", "SiO2/Malitson"), "utf-8")
assert bpy.ops.nacre.load_template(filepath=str(path)) == {"FINISHED"}
assert material.nacre.layers[0].medium == "SiO2/Malitson"
path.write_text("schema = [", "utf-8")
refused(lambda: bpy.ops.nacre.load_template(filepath=str(path)), "not a template")
assert material.nacre.layers[0].medium == "SiO2/Malitson"

# Back to the library.
assert bpy.ops.nacre.revert_stack() == {"FINISHED"}
assert not recipes.is_edited(material)
# In another space they were packed with the 15 bits of mantissa that the library's files have.
assert np.allclose(texels(material), library_texels, rtol=2**-15, atol=0.0)

# The panel's pictures.
bpy.ops.nacre.edit_stack()
swatch = module("films.swatch")
wanted = recipes.recipe(material)
assert swatch._draw_swatch("", wanted, 96).shape == (256, 256, 4)
assert swatch._draw_spectrum("", wanted, 100.0, 30.0).shape == (256, 256, 4)
extension.unregister()
extension.register()
assert material.nacre.layers[0].medium == "abbe 1.47 50"
extension.unregister()
