# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Every panel draws whatever a file holds, says what is wrong, and does its work once."""

from __future__ import annotations

import sys
from pathlib import Path
from types import SimpleNamespace

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
groups = module("materials.group")
stack = module("films.edited")
recipes = module("materials.recipe")
live = module("films.live")
library = module("core.library")
folder = Path(sys.argv[1])

PANELS = [
    cls
    for name in (
        "browser.panel",
        "lighting.panel",
        "materials.panel",
        "films.panel",
        "viewer.panel",
        "looks.panel",
        "variations.panel",
    )
    for cls in module(name).CLASSES
    if issubclass(cls, bpy.types.Panel)
]
assert len(PANELS) == 20, PANELS


class Layout:
    """Stands for a UILayout; keeps the words, and checks that what is shown is there."""

    def __init__(self, said: list[str]):
        self.said = said

    def _part(self, *_arguments, **_options):
        return Layout(self.said)

    row = column = box = split = grid_flow = _part

    def label(self, text="", **_options):
        self.said.append(text)

    def operator(self, name, **_options):
        area, _, what = name.partition(".")
        getattr(getattr(bpy.ops, area), what).get_rna_type()
        self.said.append(name)
        return SimpleNamespace()

    def operator_menu_enum(self, name, choice, text="", **_options):
        assert choice in getattr(bpy.ops.nacre, name.partition(".")[2]).get_rna_type().properties
        self.operator(name)
        self.said.append(text)

    def prop(self, owner, name, **_options):
        getattr(owner, name)

    def template_icon_view(self, owner, name, **_options):
        assert getattr(owner, name) in library.Library.default().entries()

    def template_list(self, kind, _id, owner, items, *_arguments, **_options):
        assert hasattr(bpy.types, kind)
        drawn = getattr(bpy.types, kind)
        for index, item in enumerate(getattr(owner, items)):
            drawn.draw_item(None, bpy.context, self, owner, item, 0, owner, "active", index)

    def _nothing(self, *_arguments, **_options):
        pass

    def progress(self, factor, text=""):
        assert 0.0 <= factor <= 1.0
        self.said.append(text)

    menu = separator = template_icon = template_color_ramp = _nothing


def drawn() -> list[str]:
    """The words of all panels that want to be shown."""
    said: list[str] = []
    space = SimpleNamespace(tree_type="ShaderNodeTree", shader_type="OBJECT")
    context = SimpleNamespace(
        object=bpy.context.object,
        scene=bpy.context.scene,
        space_data=space,
        window_manager=bpy.context.window_manager,
    )
    for panel in PANELS:
        if getattr(panel, "poll", lambda _context: True)(context):
            panel.draw(SimpleNamespace(layout=Layout(said)), context)
    return said


def assigned(*, edit: bool = False) -> bpy.types.Material:
    cube = new_file()
    bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
    if edit:
        bpy.ops.nacre.edit_stack()
    return cube.active_material


def tree_of(material) -> bpy.types.NodeTree:
    return materials.group_node(material).node_tree


new_file()
assert "nacre.assign_material" in drawn()
assert "nacre.edit_stack" not in drawn()
assigned()
assert "nacre.edit_stack" in drawn()

# What is computed and read for a panel is computed and read once.
material = assigned(edit=True)
bpy.ops.nacre.add_thickness(source="swirl")
import nacre  # noqa: E402

counted = {
    nacre: ("preview_tables", "template_spectrum"),
    stack: ("read_stack",),
    library: ("read_manifest",),
}
calls: list[str] = []


def counting(owner, name):
    real = getattr(owner, name)

    def call(*arguments, **options):
        calls.append(name)
        return real(*arguments, **options)

    setattr(owner, name, call)
    return real


originals = {(o, name): counting(o, name) for o, names in counted.items() for name in names}
assert "nacre.revert_stack" in drawn()
assert calls.count("preview_tables") == calls.count("template_spectrum") == 1, calls
for _ in range(5):
    calls.clear()
    drawn()
    assert calls == [], calls
# A stack that cannot be computed is tried once for each picture.
material.nacre.substrate = "unobtainium/X"
calls.clear()
said = drawn()
assert "Below: 'unobtainium/X' is not in the library." in " ".join(said), said
assert calls.count("preview_tables") == calls.count("template_spectrum") == 1, calls
calls.clear()
drawn()
assert calls == [], calls
preferences = module("materials.preferences").NACRE_preferences
preferences.draw(SimpleNamespace(layout=Layout([]), keep_assets=True), bpy.context)
module("browser.assign").material_items(None, bpy.context)
assert calls == [], calls
for (owner, name), real in originals.items():
    setattr(owner, name, real)

# Media that are held where their data end, in the words of the manifest, as the stack has them now.
HELD = "BaTiO3/Wemple-o: n and k are held beyond 400 … 700 nm, 0.0402 % of the luminous weight (D65, cie1931)"
material = assigned(edit=True)
assert HELD not in " ".join(drawn())
for substrate, words in (("BaTiO3/Wemple-o", True), ("water/Daimon-20C", False)):
    material.nacre.substrate = substrate
    live.finish_all()
    assert live.problem(material) == ""
    said = " ".join(drawn())
    assert (HELD in said) == words, said
material.nacre.substrate = "TiO2/Devore-o"
live.finish_all()
assert "what is needed is 400 … 700 nm" in live.problem(material), live.problem(material)

# Damaged properties: words where it matters, never an exception.
for name in (
    groups.MATERIAL, groups.KIND, groups.FORM, groups.SCHEMA, groups.DIGEST, groups.SOCKETS,
    groups.TEMPLATE, groups.TEMPLATE_TEXT, groups.RECIPE, groups.WAVELENGTHS, groups.NOTES,
    groups.CONDITIONS, groups.TRAITS,
):  # fmt: skip
    for value in (7, "{ broken", {"a": 1}, [1.0, 2.0], ""):
        material = assigned()
        tree_of(material)[name] = value
        assert drawn(), (name, value)
        module("materials.schema").migrate()
        module("materials.fallback").put_in_place()
        if name == groups.MATERIAL:  # which one it was is not known any more
            refused(bpy.ops.nacre.rebuild_material, "unknown material")
        elif (name, value) == (groups.SCHEMA, 7):
            refused(bpy.ops.nacre.rebuild_material, "newer Nacre")
        else:
            assert bpy.ops.nacre.rebuild_material() == {"FINISHED"}
            assert materials.missing_tables(material) == ()
        assert drawn(), (name, value)
for name, values in (
    (recipes.TEMPLATE, (7, "schema = [", {"a": 1}, "")),
    (recipes.CONDITIONS.illuminant, (7, "D99")),
    (recipes.CONDITIONS.observer, (7, "cie1492")),
    (recipes.CONDITIONS.adaptation, (7, "by eye")),
):
    for value in values:
        material = assigned(edit=True)
        material[name] = value
        said = drawn()
        assert "The stored stack cannot be read" in said, (name, value, said)
        live.finish_all()
        live._after_undo()
        assert bpy.ops.nacre.revert_stack() == {"FINISHED"}
        assert not recipes.is_edited(material)
        assert "nacre.edit_stack" in drawn()

# Newer, missing, linked.
material = assigned(edit=True)
tree_of(material)[groups.SCHEMA] = groups.SCHEMA_VERSION + 1
assert "newer Nacre" in " ".join(drawn())
material = assigned()
for node in tree_of(material).nodes:
    if node.type == "TEX_IMAGE":
        node.image = None
assert any("Shown flat" in text for text in drawn())
material = assigned(edit=True)
material.name = "Lent"
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "lent.blend"))
ways = [{"link": True}]
if bpy.app.version >= (5, 0, 0):
    ways.append({"link": True, "pack": True})
for options in ways:
    cube = new_file()
    with bpy.data.libraries.load(str(folder / "lent.blend"), **options) as (_, wanted):
        wanted.materials = ["Lent"]
    cube.data.materials.append(wanted.materials[0])
    assert not cube.active_material.is_editable
    assert "nacre.revert_stack" in drawn()
    assert not bpy.ops.nacre.revert_stack.poll()
    assert not bpy.ops.nacre.rebuild_material.poll()
    live.finish_all()
    live._after_undo()
    assert recipes.is_edited(cube.active_material)
extension.unregister()
