# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that take a material."""

from __future__ import annotations

import bpy


def named(targets: list[bpy.types.Object]) -> str:
    """The object, or how many there are."""
    return targets[0].name if len(targets) == 1 else f"{len(targets)} objects"


def chosen_objects(context) -> list[bpy.types.Object]:
    """The active object and the selected ones of kinds that have materials, each once."""
    chosen = [context.active_object, *(context.selected_objects or ())]
    unique = dict.fromkeys(obj for obj in chosen if obj is not None)
    return [obj for obj in unique if hasattr(obj.data, "materials")]


def takes_materials(obj: bpy.types.Object) -> bool:
    """An object of linked data has as many slots as that, and may hold materials of its own."""
    return obj.is_editable and (obj.data.is_editable or bool(obj.material_slots))


def takers(context) -> list[bpy.types.Object]:
    return [obj for obj in chosen_objects(context) if takes_materials(obj)]


def put(obj: bpy.types.Object, material: bpy.types.Material, new_slot: bool) -> None:
    own = obj.data.is_editable
    if own and (new_slot or not obj.material_slots):
        obj.data.materials.append(material)
        obj.active_material_index = len(obj.material_slots) - 1
        return
    slot = obj.material_slots[obj.active_material_index]
    if not own:
        slot.link = "OBJECT"
    slot.material = material
