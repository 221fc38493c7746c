# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""All the ways in which a table can be missing, and one in which it only seems to be."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()
materials = module("materials.material")
image_module = module("materials.image")
folder = Path(sys.argv[1])
BLEND = folder / "tables é.blend"


def tree_of(material) -> bpy.types.NodeTree:
    return materials.group_node(material).node_tree


def pictures(material) -> list[bpy.types.Image]:
    nodes = tree_of(material).nodes
    return list({node.image for node in nodes if node.type == "TEX_IMAGE"})


def unpack(material) -> list[Path]:
    for image in pictures(material):
        image.unpack(method="WRITE_LOCAL")
    return [Path(bpy.path.abspath(image.filepath)) for image in pictures(material)]


def lost(material) -> None:
    for path in unpack(material):
        path.unlink()


def emptied(material) -> None:
    for path in unpack(material):
        path.write_bytes(b"")


def other_size(material) -> None:
    for path in unpack(material):
        small = bpy.data.images.new("small", 3, 2, float_buffer=True)
        small.file_format = "OPEN_EXR"
        small.save(filepath=str(path))
        bpy.data.images.remove(small)


def a_folder(material) -> None:
    for path in unpack(material):
        path.unlink()
        path.mkdir()


def too_long(material) -> None:
    for image in pictures(material):
        image.unpack(method="REMOVE")
        image.filepath_raw = "//" + "n" * 900 + ".exr"


def nameless(material) -> None:
    for image in pictures(material):
        image.unpack(method="REMOVE")
        image.filepath_raw = ""


def removed(material) -> None:
    for image in pictures(material):
        bpy.data.images.remove(image)


def whole(material) -> None:
    unpack(material)


for damage in (
    lost, emptied, other_size, a_folder, too_long, nameless, removed, whole,
):  # fmt: skip
    shutil.rmtree(folder / "textures", ignore_errors=True)
    cube = new_file()
    bpy.ops.nacre.assign_material(material="test_film", form="nodes")
    bpy.ops.wm.save_as_mainfile(filepath=str(BLEND))
    sizes = sorted(tuple(image.size) for image in pictures(cube.active_material))
    assert sizes, "no tables"
    damage(cube.active_material)
    bpy.ops.wm.save_as_mainfile(filepath=str(BLEND))
    bpy.ops.wm.open_mainfile(filepath=str(BLEND))
    bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]
    material = bpy.data.objects["Cube"].active_material
    stands_in = {image.name for image in pictures(material) if image.get(image_module.FALLBACK)}
    if damage is whole:  # files are files: they are used, not replaced
        assert materials.missing_tables(material) == ()
        assert stands_in == set(), stands_in
        assert sorted(tuple(image.size) for image in pictures(material)) == sizes
        continue
    assert materials.missing_tables(material) != (), damage
    assert stands_in == {"nacre_missing_0.5"}, (damage, stands_in)
    state = module("materials.scene").state(bpy.context.scene, materials.missing_tables(material))
    found = module("materials.problems").find_problems(materials.describe(material), state)
    assert found[0].text.startswith("Shown flat"), found
    assert bpy.ops.nacre.rebuild_material() == {"FINISHED"}
    assert materials.missing_tables(material) == (), damage
    assert sorted(tuple(image.size) for image in pictures(material)) == sizes

# In the open file: what was scaled is another size, what was never read is not read for this.
new_file()
bpy.ops.nacre.assign_material(material="test_film", form="nodes")
material = bpy.context.object.active_material
pictures(material)[0].scale(5, 5)
assert len(materials.missing_tables(material)) == 1
bpy.ops.nacre.rebuild_material()
assert materials.missing_tables(material) == ()
bpy.ops.wm.save_as_mainfile(filepath=str(BLEND))
bpy.ops.wm.open_mainfile(filepath=str(BLEND))
material = bpy.data.objects["Cube"].active_material
assert [image.has_data for image in pictures(material)] == [False] * len(pictures(material))

# Appended from a file of which the tables are gone; a linked stand-in is not taken for our own.
name = material.name
for image in pictures(material):
    bpy.data.images.remove(image)
extension.unregister()  # saved as it is
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "gone.blend"))
extension.register()
new_file()
with bpy.data.libraries.load(str(folder / "gone.blend"), link=True) as (_, wanted):
    wanted.materials = [name]
linked = wanted.materials[0]
assert all(image is None for image in pictures(linked))  # not ours to change
if hasattr(bpy.app.handlers, "blend_import_post"):
    new_file()
    with bpy.data.libraries.load(str(folder / "gone.blend"), link=False) as (_, wanted):
        wanted.materials = [name]
    assert all(image.get(image_module.FALLBACK) for image in pictures(wanted.materials[0]))

# What is added to others is nothing where it is missing; what a lobe is tinted with is grey.
new_file()
bpy.ops.nacre.assign_material(material="test_film", form="nodes")
dark = bpy.context.object.active_material
nodes = [node for node in tree_of(dark).nodes if node.type == "TEX_IMAGE"]
nodes[0][image_module.TABLE_CONTENT] = "further"
removed(dark)
module("materials.fallback").put_in_place()
stand_ins = [node.image.name for node in nodes]
assert stand_ins == ["nacre_missing_0", *["nacre_missing_0.5"] * (len(nodes) - 1)], stand_ins
extension.unregister()
