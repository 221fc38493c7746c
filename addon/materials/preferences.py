# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit > Preferences > Add-ons > Nacre: what is installed, and what this Blender can do with it."""

from __future__ import annotations

from itertools import groupby

import bpy
from bpy.props import BoolProperty, StringProperty

from ..assets import build as assets
from ..assets.panel import draw_asset_build
from ..blender import wrapped
from ..core.library import Library
from ..films.edited import library_problem
from .script import has_osl


class NACRE_preferences(bpy.types.AddonPreferences):
    bl_idname = __package__.rpartition(".")[0]

    keep_assets: BoolProperty(
        name="Keep the Asset Library",
        description="Make the asset library by itself after installing and after updates, aside",
        default=True,
    )
    recent: StringProperty(name="Recent", description="Assigned last, the last one first")
    favourites: StringProperty(name="Favourites", description="In the order in which they came")

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
        layout.prop(self, "keep_assets")
        draw_asset_build(layout)
        row = layout.row()
        if assets.is_built(assets.default_folder()):
            row.operator(
                "nacre.add_asset_library", text="Rebuild Asset Library", icon="FILE_REFRESH"
            )
            row.operator("nacre.remove_asset_library", text="Remove from Asset Browser", icon="X")
        else:
            row.operator(
                "nacre.add_asset_library", text="Add to Asset Browser", icon="ASSET_MANAGER"
            )
        for category, entries in groupby(library.entries().values(), key=lambda e: e.category):
            names = " · ".join(entry.name for entry in entries)
            split = layout.split(factor=0.25)
            split.label(text=category)
            split.label(text=names)
