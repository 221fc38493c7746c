# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Everything that one can click says what it does, in words of its own."""

from __future__ import annotations

from collections import Counter

import bpy

from jobs.extension import load, module

extension = load()
extension.register()
classes = module("registration")._CLASSES

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
extension.unregister()
