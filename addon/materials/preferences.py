# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit > Preferences > Add-ons > Nacre: what is installed, and what this Blender can do with it."""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby

import bpy

from ..blender import wrapped
from ..core.computation import library_problem
from ..core.library import Library
from .script import has_osl

SECTIONS: list[Callable[[bpy.types.UILayout, bpy.types.AddonPreferences], None]] = []
"""What features draw of theirs."""


class NACRE_preferences(bpy.types.AddonPreferences):
    """Features add properties by `keep`."""

    bl_idname = __package__.rpartition(".")[0]

    def draw(self, _context):
        layout = self.layout
        library = Library.default()
        if has_osl():
            layout.label(text="This Blender runs Open Shading Language", icon="CHECKMARK")
        else:
            wrapped.label(
                layout,
                "This Blender was built without Open Shading Language. All but gratings work as nodes; "
                "blender.org's own Blender has it.",
                "INFO",
            )
        layout.label(text=f"{len(library.entries())} materials in {library.root}", icon="MATERIAL")
        if missing := library_problem():
            wrapped.label(layout, missing, "ERROR")
        row = layout.row()
        row.operator("nacre.open_manual", text="Manual", icon="HELP")
        row.operator("nacre.copy_report", text="Copy for a Bug Report", icon="COPYDOWN")
        for section in SECTIONS:
            section(layout, self)
        for category, entries in groupby(library.entries().values(), key=lambda e: e.category):
            names = " · ".join(entry.name for entry in entries)
            split = layout.split(factor=0.25)
            split.label(text=category)
            split.label(text=names)


def keep(**properties: object) -> None:
    """Adds properties, such as BoolProperty(…). To be called while modules are loaded: unlike those of other
    classes, preferences take none when they are registered."""
    NACRE_preferences.__annotations__.update(properties)


def preferences() -> bpy.types.AddonPreferences | None:
    """None where Nacre runs without being installed as an add-on."""
    addon = bpy.context.preferences.addons.get(NACRE_preferences.bl_idname)
    return addon.preferences if addon is not None else None
