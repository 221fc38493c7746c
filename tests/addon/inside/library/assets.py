# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The asset library: built, listed, appended from, and taken away without trace."""

from __future__ import annotations

from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()
assets = module("assets.build")
catalogues = module("core.catalogues")
words = module("core.words")
library = module("core.library").Library.default()
materials = module("materials.material")
thickness = module("thickness.nodes")
folder = assets.default_folder()
libraries = bpy.context.preferences.filepaths.asset_libraries
listed = len(libraries)

cube = new_file()
bpy.ops.nacre.assign_material(material="tempered_steel", form="nodes")
before = {kind: set(getattr(bpy.data, kind)) for kind in ("materials", "node_groups", "images")}
assert not assets.is_built(folder)
for _ in range(2):  # again: the same, in the same place
    assert bpy.ops.nacre.add_asset_library() == {"FINISHED"}
    assert len(libraries) == listed + 1
assert libraries[-1].name == "Nacre"
assert Path(libraries[-1].path) == folder
assert before == {kind: set(getattr(bpy.data, kind)) for kind in before}
bpy.ops.nacre.assign_material(material="tempered_steel", form="nodes")
assert len(bpy.data.node_groups) == len(before["node_groups"])  # shared as before

text = (folder / catalogues.FILE).read_text("utf-8")
for entry in library.entries().values():
    assert f"{catalogues.catalogue_id(entry.category)}:{entry.category}:" in text
    assert f":{entry.category.split('/')[0]}:" in text

new_file()
with bpy.data.libraries.load(str(folder / assets.BLEND), assets_only=True) as (source, target):
    target.materials = list(source.materials)
offered = module("core.looks").variants(library.entries())
assert {material.name for material in bpy.data.materials} == {v.name for v in offered.values()}
assert "Tempered Steel, Even" in bpy.data.materials
for material in bpy.data.materials:
    node = materials.group_node(material)
    entry = library.entries()[node.node_tree["nacre_material"]]
    data = material.asset_data
    assert data.catalog_id == catalogues.catalogue_id(entry.category)
    assert data.description == entry.description
    tags = {tag.name for tag in data.tags}
    assert {entry.kind, *entry.tags, *words.synonyms(entry)} <= tags
    assert not materials.missing_tables(material)
    assert tuple(material.preview.image_size) == (256, 256), material.name
    assert materials.describe(material).form == "nodes"  # works wherever it is dragged
    varies = entry.varies and not material.name.endswith(", Even")
    assert bool(thickness.sources_of(material)) == varies, material.name

# Taken out while the extension is off, there again afterwards, and deleted on demand.
extension.unregister()
assert len(libraries) == listed
extension.register()
assert len(libraries) == listed + 1
assert bpy.ops.nacre.remove_asset_library() == {"FINISHED"}
assert len(libraries) == listed
assert not assets.is_built(folder)
extension.unregister()
