# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Every shipped material as it is pictured: its object, its sources, its even variant and its pictures."""

from __future__ import annotations

import bpy

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()
library = module("core.library").Library.default()
core_looks = module("core.looks")
looks, thickness = module("thickness.dress"), module("thickness.nodes")
objects = module("background.scenes.objects").OBJECTS
thumbnail = module("core.catalogues").thumbnail

offered = core_looks.variants(library.entries())
varied = [item for item in offered.values() if item.is_even]
assert len(varied) >= 15
for variant in offered.values():
    assert thumbnail(variant.key).is_file(), variant.key

for material_id in library.entries():
    compiled = library.load(material_id)
    assert compiled.look.object in objects, (material_id, compiled.look.object)

for variant in varied:
    compiled = library.load(variant.entry.id)
    cube = new_file()
    assert bpy.ops.nacre.assign_material(material=variant.entry.id) == {"FINISHED"}
    material = cube.active_material
    assert material.name == compiled.name
    sources = thickness.sources_of(material)
    names = [text.partition(":")[0] for text in reversed(compiled.look.thickness)]
    assert [node.node_tree[thickness.SOURCE] for node in sources] == names
    assert bpy.ops.nacre.assign_material(material=variant.key) == {"FINISHED"}
    assert cube.active_material.name == f"{compiled.name}, Even"
    assert thickness.sources_of(cube.active_material) == []

# What lets light straight through is blended in EEVEE: dithered, its mirror image is grain.
for material_id, method in (
    ("soap_film", "BLENDED"),
    ("dichroic_red", "BLENDED"),
    ("tempered_steel", "DITHERED"),
    ("water", "DITHERED"),
):
    bpy.ops.nacre.assign_material(material=material_id)
    assert cube.active_material.surface_render_method == method, material_id


def problem_of(material, compiled) -> str:
    try:
        looks.dress(material, compiled)
    except module("core.manifest").ManifestError as error:
        return str(error)
    return ""


# A look that does not fit is refused whole.
compiled = library.load("tempered_steel")
for text, message in (
    ("rain", "no source 'rain'"),
    ("drop:base_nm=5,height_nm=900", "must be"),
    ("swirl:colour=3", "no value 'colour'"),
):
    wrong = type(compiled)(**{**vars(compiled), "look": core_looks.Look("", ("swirl", text))})
    cube = new_file()
    bpy.ops.nacre.assign_material(material="tempered_steel:even")
    material = cube.active_material
    said = problem_of(material, wrong)
    assert said.startswith("tempered_steel: look.thickness: "), said
    assert message in said, said
    assert thickness.sources_of(material) == []

# A star is for one variant.
assert bpy.ops.nacre.favourite(material="soap_film:even") == {"FINISHED"}
assert module("browser.chosen").favourites(offered) == ["soap_film:even"]
bpy.ops.nacre.favourite(material="soap_film:even")
extension.unregister()
