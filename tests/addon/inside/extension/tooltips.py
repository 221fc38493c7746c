# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Everything that one can click says what it does, in words of its own."""

from __future__ import annotations

from collections import Counter
from types import SimpleNamespace

import bpy

from jobs.extension import load, module

extension = load()
extension.register()
classes = module("registration").classes()

operators = [cls for cls in classes if issubclass(cls, bpy.types.Operator)]
assert len(operators) > 20
said = Counter()
for operator in operators:
    kind = getattr(bpy.ops.nacre, operator.bl_idname.partition(".")[2]).get_rna_type()
    # F3 finds them under the extension's name.
    assert kind.name.startswith("Nacre: "), kind.identifier
    said[kind.description] += 1
groups = [cls.bl_rna for cls in classes if issubclass(cls, bpy.types.PropertyGroup)]
lacking = []
for kind in (
    *(getattr(bpy.ops.nacre, o.bl_idname.partition(".")[2]).get_rna_type() for o in operators),
    *groups,
):
    for name, prop in kind.properties.items():
        if name in ("rna_type", "name") or prop.is_hidden:
            continue
        if prop.type not in ("COLLECTION",) and not prop.description:
            lacking.append(f"{kind.identifier}.{name}")
        if prop.type == "ENUM":
            items = [item.description for item in prop.enum_items]
            lacking += [f"{kind.identifier}.{name}: {n}" for n in items if not n]
assert not lacking, lacking
assert "" not in said
assert not [text for text, count in said.items() if count > 1], said.most_common(3)
assert all(not text.endswith(".") for text in said)


class Menu:
    """Stands for a UILayout: keeps what can be called from it."""

    operator_context = ""

    def __init__(self):
        self.found = set()

    def operator(self, name, *_arguments, **_options):
        getattr(bpy.ops.nacre, name.partition(".")[2]).get_rna_type()
        self.found.add(name)
        return SimpleNamespace()

    operator_menu_enum = operator

    def menu(self, name, **_options):
        getattr(bpy.types, name).draw(SimpleNamespace(layout=self), bpy.context)

    def separator(self):
        pass

    def label(self, **_options):
        pass


# F3 looks through menus: everything is in one but what is done to the row, the picture or the message
# that was clicked.
menu = Menu()
menu.menu("NACRE_MT_object")
clicked = {
    "assign_look", "remove_look", "take_variation", "dismiss", "copy_probe",
    "read_as_data", "remove_thickness_source", "move_thickness_source", "set_thickness",
    "remove_layer", "move_layer", "vary_layer", "finish_stack", "apply_preset", "show_rgb",
}  # fmt: skip
known = {operator.bl_idname for operator in operators}
assert known - menu.found == {f"nacre.{name}" for name in clicked}, known - menu.found
extension.unregister()
