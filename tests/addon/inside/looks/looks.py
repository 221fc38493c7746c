# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Looks of the user's own: saved, listed, given, shared, and refused without a trace."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
thickness = module("thickness.nodes")
stack = module("films.edited")
recipes = module("materials.recipe")
groups = module("materials.group")
my_looks = module("looks.my_looks")
look_file = module("looks.look_file")
names = module("looks.file_names")
looks = module("looks.operators")
FILE = module("core.catalogues").FILE
folder = Path(sys.argv[1])
libraries = bpy.context.preferences.filepaths.asset_libraries
listed = len(libraries)


def blocks() -> set[str]:
    return {repr(block) for block in module("assets.asset").all_blocks()}


def names_in(place: Path) -> set[str]:
    return {path.name for path in place.iterdir()} if place.is_dir() else set()


def film(cube) -> bpy.types.Material:
    """Two sources, values of its own, a picture that lies on the disc, and a clock."""
    bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
    material = cube.active_material
    bpy.ops.nacre.remove_thickness()
    image = bpy.data.images.new("map", 4, 4)
    image.pixels = [0.25] * 64
    image.filepath_raw, image.file_format = str(folder / "karte.png"), "PNG"
    image.save()
    bpy.data.images.remove(image)
    bpy.ops.nacre.add_thickness(source="map", filepath=str(folder / "karte.png"))
    bpy.ops.nacre.add_thickness(source="distance")
    bpy.ops.nacre.add_thickness(source="swirl")
    bpy.ops.nacre.animate_thickness()
    materials.set_values(material, {"roughness": 0.125, "coverage": 0.75})
    thickness.sources_of(material)[0].inputs["Amount"].default_value = 0.625
    thickness.sources_of(material)[2].inputs["Maximum"].default_value = 160.0
    material.name = "Slick"
    return material


def check(material, *, is_packed: bool = True) -> None:
    assert thickness.sources_of(material)[0].inputs["Amount"].default_value == 0.625
    assert [thickness.spec_of(node).id for node in thickness.sources_of(material)] == [
        "swirl",
        "distance",
        "map",
    ]
    assert thickness.sources_of(material)[2].inputs["Maximum"].default_value == 160.0
    assert materials.input_socket(material, "roughness").default_value == 0.125
    assert materials.missing_tables(material) == ()
    tree = materials.group_node(material).node_tree
    assert all(n.image.packed_file for n in tree.nodes if n.type == "TEX_IMAGE")
    picture = thickness.feed_of(thickness.sources_of(material)[2], "TEX_IMAGE").image
    assert bool(picture.packed_file) == is_packed
    assert picture.colorspace_settings.is_data
    assert material.asset_data is None
    target = material.node_tree.animation_data.drivers[0].driver.variables[0].targets[0]
    assert target.id == bpy.context.scene


# ---- Saved: one file with its picture, and the open file is as it was.
cube = new_file()
refused(lambda: bpy.ops.nacre.save_look(name="x"), "poll()")
material = film(cube)
before = blocks()
assert len(libraries) == listed
assert bpy.ops.nacre.save_look(name="Ölfilm: 1/2") == {"FINISHED"}
assert blocks() == before
assert material.name == "Slick"
assert material.asset_data is None
assert thickness.feed_of(thickness.sources_of(material)[2], "TEX_IMAGE").image.packed_file is None
own = my_looks.folder()
assert names_in(own) == {"Ölfilm%3A 1%2F2.blend", "Ölfilm%3A 1%2F2.png", FILE}
assert libraries[-1].name == "Nacre: My Looks"
assert [look.name for look in my_looks.looks()] == ["Ölfilm: 1/2"]
assert (own / "Ölfilm%3A 1%2F2.png").read_bytes().endswith(b"IEND\xae\x42\x60\x82")
my_looks.icon(my_looks.looks()[0])

# Not twice under one name, unless it is said; of another case neither, which some systems take for the same.
refused(lambda: bpy.ops.nacre.save_look(name="ölfilm: 1/2"), "already")
first = (own / "Ölfilm%3A 1%2F2.blend").read_bytes()
assert bpy.ops.nacre.save_look(name="Ölfilm: 1/2", replace=True) == {"FINISHED"}
assert len(my_looks.looks()) == 1
assert len(libraries) == listed + 1

# Names that no system may have as files.
for name in ("CON", "nul.txt", ".hidden", "a<b>|?*", "dot.", "100 %", "x" * 90, "光沢"):
    materials.set_values(material, {"roughness": 0.125})
    assert bpy.ops.nacre.save_look(name=name[:63]) == {"FINISHED"}, name
    assert names.name_of(names.stem(name)) == name
assert len(my_looks.looks()) == 9
assert not [name for name in names_in(own) if "partial" in name]
refused(lambda: bpy.ops.nacre.save_look(name=" \n"), "needs a name")
for look in my_looks.looks():
    if look.name != "Ölfilm: 1/2":
        assert bpy.ops.nacre.remove_look(look=look.name) == {"FINISHED"}
assert len(names_in(own)) == 3
refused(lambda: bpy.ops.nacre.remove_look(look="CON"), "no look")

# What the asset browser knows of it. It leads to nothing else: no scene, no object.
new_file()
with bpy.data.libraries.load(str(own / "Ölfilm%3A 1%2F2.blend"), assets_only=True) as (
    held,
    target,
):
    assert list(held.objects) == list(held.scenes) == []
    target.materials = list(held.materials)
asset = bpy.data.materials["Ölfilm: 1/2"]
data = asset.asset_data
assert {"film", "Nacre"} <= {tag.name for tag in data.tags}
assert data.catalog_id in (own / FILE).read_text("utf-8")
assert data.description
assert tuple(asset.preview.image_size) == (256, 256)
assert len(bpy.data.materials) == len(held.materials) == 1
assert len(bpy.data.scenes) == 1
clock = asset.node_tree.animation_data.drivers[0].driver.variables[0].targets[0]
assert clock.id == bpy.context.scene  # as after dragging it from there

# ---- Given to an object of another file; again the same, unless it was changed there.
cube = new_file()
assert bpy.ops.nacre.assign_look(look="Ölfilm: 1/2") == {"FINISHED"}
given = cube.active_material
check(given)
points = [obj for obj in bpy.context.scene.objects if obj.type == "EMPTY"]
assert len(points) == 1  # what the source follows
bpy.ops.mesh.primitive_cube_add()
assert bpy.ops.nacre.assign_look(look="Ölfilm: 1/2") == {"FINISHED"}
assert bpy.context.object.active_material == given
assert len(bpy.data.materials) == 1
materials.set_values(given, {"roughness": 0.5})
assert bpy.ops.nacre.assign_look(look="Ölfilm: 1/2") == {"FINISHED"}
other = bpy.context.object.active_material
assert other != given
check(other)
assert materials.group_node(other).node_tree == materials.group_node(given).node_tree

# An edited stack goes along, compiled.
cube = new_file()
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
bpy.ops.nacre.edit_stack()
cube.active_material.nacre.substrate = "Al/Rakic"
assert stack.is_stale(cube.active_material)
wanted = recipes.recipe(cube.active_material)
assert bpy.ops.nacre.save_look(name="On Aluminium") == {"FINISHED"}
cube = new_file()
bpy.ops.nacre.assign_look(look="On Aluminium")
assert recipes.recipe(cube.active_material) == wanted
assert not stack.is_stale(cube.active_material)

# ---- Shared as one file, and opened where nothing of it is known.
cube = new_file()
material = film(cube)
before = blocks()
shared = folder / "geteilt é.blend"
assert bpy.ops.nacre.export_look(filepath=str(shared)) == {"FINISHED"}
assert blocks() == before
refused(lambda: bpy.ops.nacre.export_look(filepath=str(folder / "no" / "x.blend")), "no folder")
cube = new_file()
bpy.data.materials.new("Slick").use_fake_user = True
kept = {look.name for look in my_looks.looks()}
assert bpy.ops.nacre.import_look(filepath=str(shared)) == {"FINISHED"}
check(cube.active_material)
assert {look.name for look in my_looks.looks()} - kept == {"Slick"}
assert bpy.ops.nacre.import_look(filepath=str(shared)) == {"FINISHED"}
assert {look.name for look in my_looks.looks()} - kept == {"Slick", "Slick 2"}
assert bpy.ops.nacre.import_look(filepath=str(shared), keep=False) == {"FINISHED"}
assert {look.name for look in my_looks.looks()} - kept == {"Slick", "Slick 2"}
cube.select_set(False)
bpy.context.view_layer.objects.active = None
refused(lambda: bpy.ops.nacre.import_look(filepath=str(shared), keep=False), "Select an object")
before = blocks()
assert bpy.ops.nacre.import_look(filepath=str(shared)) == {"FINISHED"}
assert blocks() == before  # kept, and nothing in a file that has no place for it

# ---- Files that are something else: refused, and nothing is left behind.
whole = shared.read_bytes()
CUTS = (8, 40, len(whole) // 3, len(whole) * 9 // 10)
foreign = folder / "foreign.blend"
cube = new_file()
cube.data.materials.append(bpy.data.materials.new("Plain"))
bpy.ops.wm.save_as_mainfile(filepath=str(foreign))
cube = new_file()
material = film(cube)
tree = materials.group_node(material).node_tree
newer = folder / "newer.blend"
tree[groups.SCHEMA] = groups.SCHEMA_VERSION + 1
bpy.data.libraries.write(str(newer), {material})
refused(lambda: bpy.ops.nacre.save_look(name="Newer"), "newer Nacre")
refused(lambda: bpy.ops.nacre.export_look(filepath=str(folder / "n.blend")), "newer Nacre")
(folder / "text.blend").write_text("no", "utf-8")
for share in CUTS:
    (folder / f"cut{share}.blend").write_bytes(whole[:share])
cube = new_file()
before, kept = blocks(), names_in(own)
for path, word in (
    (folder / "text.blend", "not a .blend"),
    (folder / "none.blend", "cannot be read"),
    (folder, "cannot be read"),
    (foreign, "no wave material"),
    (newer, "newer Nacre"),
    *((folder / f"cut{share}.blend", "cut") for share in CUTS),
):
    refused(lambda path=path: bpy.ops.nacre.import_look(filepath=str(path)), word)
    assert blocks() == before, path
    assert names_in(own) == kept
    assert cube.active_material is None

# A whole scene of somebody else's: its wave materials, and nothing besides.
cube = new_file()
film(cube)
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "scene.blend"))
cube = new_file()
objects, scenes = len(bpy.data.objects), len(bpy.data.scenes)
assert bpy.ops.nacre.import_look(filepath=str(folder / "scene.blend"), keep=False) == {"FINISHED"}
check(cube.active_material, is_packed=False)  # the picture lies where it lay
assert len(bpy.data.objects) == objects + 1  # the empty that it follows
assert len(bpy.data.scenes) == scenes

# What is linked is another file's, and does not fit into one.
new_file()
with bpy.data.libraries.load(str(folder / "scene.blend"), link=True) as (held, target):
    target.materials = ["Slick"]
bpy.context.object.data.materials.append(target.materials[0])
before = blocks()
refused(lambda: bpy.ops.nacre.save_look(name="Linked"), "make it local first")
assert blocks() == before
assert not my_looks.has("Linked")
cube = new_file()
assert bpy.ops.nacre.assign_look(look="Slick") == {"FINISHED"}

# A view that is shown is no part of a look.
bpy.context.scene.nacre.view = "normal" if hasattr(bpy.context.scene, "nacre") else "shaded"
shown = module("viewer.views").shown()
assert shown == "normal"
assert bpy.ops.nacre.save_look(name="Viewed") == {"FINISHED"}
assert module("viewer.views").shown() == shown
with bpy.data.libraries.load(str(own / "Viewed.blend")) as (held, _):
    assert len(held.node_groups) == 4, held.node_groups
bpy.context.scene.nacre.view = "shaded"

# Tables that are gone; a folder that cannot be written.
for node in materials.group_node(cube.active_material).node_tree.nodes:
    if node.type == "TEX_IMAGE":
        node.image = None
refused(lambda: bpy.ops.nacre.save_look(name="Gone"), "tables are missing")
cube = new_file()
film(cube)
before = blocks()
moved = own.rename(own.with_name("moved"))
own.write_text("mine", "utf-8")
refused(lambda: bpy.ops.nacre.save_look(name="Blocked"), "cannot be made")
assert blocks() == before
own.unlink()
own.mkdir()
(own / "Blocked.blend").mkdir()  # nothing can take its place
refused(lambda: bpy.ops.nacre.save_look(name="Blocked"), "could not be written")
assert names_in(own) == {"Blocked.blend"}
assert blocks() == before
(own / "Blocked.blend").rmdir()
own.rmdir()
moved.rename(own)

# The last one takes the library out of the list, too.
emptied = own.rename(own.with_name("moved"))
bpy.ops.mesh.primitive_cube_add()
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
bpy.ops.nacre.save_look(name="Only")
bpy.ops.nacre.remove_look(look="Only")
assert len(libraries) == listed
assert names_in(own) == {FILE}
(own / FILE).unlink()
own.rmdir()
emptied.rename(own)
bpy.ops.nacre.save_look(name="Last")

# Taken out while the extension is off; the files stay.
kept = names_in(own)
extension.unregister()
assert len(libraries) == listed
extension.register()
assert len(libraries) == listed + 1
extension.unregister()
assert names_in(own) == kept
