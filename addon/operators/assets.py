# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The materials in Blender's asset browser."""

from __future__ import annotations

import bpy

from ..nodes import assets
from .guard import reports_errors


class NACRE_OT_add_asset_library(bpy.types.Operator):
    bl_idname = "nacre.add_asset_library"
    bl_label = "Nacre: Add to Asset Browser"
    bl_description = (
        "Make an asset library of all materials, with catalogues and pictures; they can then be "
        "dragged onto objects"
    )

    @reports_errors
    def execute(self, context):
        folder = assets.default_folder()
        if context.window:
            context.window.cursor_set("WAIT")
        count, left_out = assets.build(folder)
        assets.show(folder)
        if context.window:
            context.window.cursor_set("DEFAULT")
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
        return {"FINISHED"}


CLASSES = (NACRE_OT_add_asset_library, NACRE_OT_remove_asset_library)
