# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit > Preferences > Add-ons > Nacre: what is installed, and what this Blender can do with it."""

from __future__ import annotations

import bpy

from ..core.library import Library
from ..nodes.scene import has_osl


class NACRE_preferences(bpy.types.AddonPreferences):
    bl_idname = __package__.rpartition(".")[0]

    def draw(self, _context):
        layout = self.layout
        library = Library.default()
        if has_osl():
            layout.label(text="This Blender runs Open Shading Language", icon="CHECKMARK")
        else:
            layout.label(
                text="This Blender has no Open Shading Language: films work as nodes, gratings do not",
                icon="INFO",
            )
        layout.label(text=f"{len(library.entries())} materials in {library.root}", icon="MATERIAL")
        for entry in library.entries().values():
            row = layout.row()
            row.label(text=entry.name)
            row.label(text=entry.category)
            row.label(text=entry.description)
