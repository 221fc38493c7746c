# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The materials in Blender's asset browser."""

from __future__ import annotations

from functools import partial

import bpy

from ..blender import asset_libraries
from ..materials.guard import reports_errors
from ..materials.preferences import preferences
from . import build as assets
from . import process


class NACRE_OT_add_asset_library(bpy.types.Operator):
    bl_idname = "nacre.add_asset_library"
    bl_label = "Nacre: Add to Asset Browser"
    bl_description = (
        "Make an asset library of all materials, with catalogues and pictures; they can then be "
        "dragged onto objects"
    )

    @reports_errors
    def execute(self, _context):
        folder = assets.default_folder()
        if (kept := preferences()) is not None:
            kept.keep_assets = True
        if not bpy.app.background:
            process.begin(folder)
            return {"FINISHED"}
        count, left_out = assets.build(folder)
        assets.show(folder)
        self.report({"INFO"}, f"{count} materials are in the asset library {assets.NAME}")
        for text in left_out:
            self.report({"WARNING"}, text)
        return {"FINISHED"}


class NACRE_OT_remove_asset_library(bpy.types.Operator):
    bl_idname = "nacre.remove_asset_library"
    bl_label = "Nacre: Remove from Asset Browser"
    bl_description = "Take the asset library out of the preferences and delete its file"

    @reports_errors
    def execute(self, _context):
        assets.delete(assets.default_folder())
        if (kept := preferences()) is not None:
            kept.keep_assets = False  # or else it would be made anew at the next start
        return {"FINISHED"}


class NACRE_OT_open_assets(bpy.types.Operator):
    bl_idname = "nacre.open_assets"
    bl_label = "Nacre: Open Asset Browser"
    bl_description = (
        "Show Nacre's materials in an asset browser, in place of the timeline if there is one"
    )

    @classmethod
    def poll(cls, context):
        if context.window is None or not asset_libraries.is_listed(assets.default_folder()):
            cls.poll_message_set("There is no asset library yet")
            return False
        return True

    @reports_errors
    def execute(self, context):
        area = _place_for_assets(context.window.screen)
        area.ui_type = "ASSETS"
        process.dismiss()
        # A browser knows its libraries when it has been drawn.
        bpy.app.timers.register(partial(_choose_library, area), first_interval=0.2)
        return {"FINISHED"}


def _place_for_assets(screen: bpy.types.Screen) -> bpy.types.Area:
    """A browser that is there, or else the area that is missed least; never the viewport."""
    for kind in ("FILE_BROWSER", "DOPESHEET_EDITOR", "GRAPH_EDITOR", "NODE_EDITOR", "OUTLINER"):
        found = [area for area in screen.areas if area.type == kind]
        if found:
            return max(found, key=lambda area: area.width * area.height)
    return min(screen.areas, key=lambda area: area.width * area.height)


def _choose_library(area: bpy.types.Area) -> float | None:
    parameters = area.spaces.active.params if area.ui_type == "ASSETS" else None
    if parameters is None:
        return None
    parameters.asset_library_reference = assets.NAME
    return None


class NACRE_OT_dismiss(bpy.types.Operator):
    bl_idname = "nacre.dismiss"
    bl_label = "Nacre: Close the Message"
    bl_description = "Take this line away"
    bl_options = {"INTERNAL"}

    def execute(self, _context):
        process.dismiss()
        return {"FINISHED"}


CLASSES = (
    NACRE_OT_add_asset_library,
    NACRE_OT_remove_asset_library,
    NACRE_OT_open_assets,
    NACRE_OT_dismiss,
)
