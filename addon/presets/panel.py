# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The menu of a material's presets, above its inputs."""

from __future__ import annotations

import bpy

from ..materials.subject import active_material
from .operators import presets_of


class NACRE_MT_presets(bpy.types.Menu):
    bl_idname = "NACRE_MT_presets"
    bl_label = "Presets"

    def draw(self, context):
        presets = presets_of(active_material(context))
        for preset in presets:
            self.layout.operator("nacre.apply_preset", text=preset.name).preset = preset.name
        if not presets:
            self.layout.label(text="The active material has none")


def draw(layout: bpy.types.UILayout, context) -> None:
    if presets_of(active_material(context)):
        layout.menu("NACRE_MT_presets", icon="PRESET")


CLASSES = (NACRE_MT_presets,)
