# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes a preset of the active material."""

from __future__ import annotations

import bpy
from bpy.props import StringProperty

from ..core.presets import Preset, named, read
from ..materials import group as groups
from ..materials.guard import allows_change, reports_errors
from ..materials.material import group_node, set_values
from ..materials.subject import active_material


def presets_of(material: bpy.types.Material | None) -> tuple[Preset, ...]:
    """As its group carries them. Panels ask this at each redraw."""
    node = group_node(material)
    stored = node.node_tree.get(groups.PRESETS) if node is not None else None
    return read(stored) if isinstance(stored, str) else ()


class NACRE_OT_apply_preset(bpy.types.Operator):
    bl_idname = "nacre.apply_preset"
    bl_label = "Nacre: Apply Preset"
    bl_description = (
        "Give the inputs of the active material the values of a preset; what it does not name stays"
    )
    bl_options = {"REGISTER", "UNDO"}

    preset: StringProperty(name="Preset", description="Its name")

    @classmethod
    def poll(cls, context):
        material = active_material(context)
        if not presets_of(material):
            cls.poll_message_set("The active material has no presets")
            return False
        return allows_change(cls, material)

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        set_values(material, named(presets_of(material), self.preset).values)
        return {"FINISHED"}


CLASSES = (NACRE_OT_apply_preset,)
