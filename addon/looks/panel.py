# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks that were saved, as pictures to click; in the side bar and in the material's properties."""

from __future__ import annotations

import bpy

from ..blender import wrapped
from ..materials.documented import Documented
from ..materials.material import group_node
from ..materials.subject import active_material
from . import my_looks


class _Looks(Documented):
    bl_label = "My Looks"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        saved = my_looks.looks()
        if not saved:
            text = "Save a material here to give it to other objects and files"
            wrapped.label(layout, text, "INFO")
        grid = layout.grid_flow(row_major=True, columns=0, even_columns=True, align=True)
        for look in saved:
            _draw_look(grid, look)
        column = layout.column(align=True)
        column.operator_context = "INVOKE_DEFAULT"
        if group_node(active_material(context)) is not None:
            column.operator("nacre.save_look", text="Save Look…", icon="FILE_TICK")
            column.operator("nacre.export_look", text="Share as One File…", icon="EXPORT")
        column.operator("nacre.import_look", text="Open Shared Look…", icon="IMPORT")


def _draw_look(layout, look: my_looks.Look) -> None:
    column = layout.column(align=True)
    column.template_icon(icon_value=my_looks.icon(look), scale=3.6)
    row = column.row(align=True)
    row.operator("nacre.assign_look", text=look.name).look = look.name
    row.operator_context = "INVOKE_DEFAULT"
    row.operator("nacre.remove_look", text="", icon="X").look = look.name


class NACRE_PT_viewport_looks(_Looks, bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_order = 4


class NACRE_PT_material_looks(_Looks, bpy.types.Panel):
    bl_parent_id = "NACRE_PT_material"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


CLASSES = (NACRE_PT_viewport_looks, NACRE_PT_material_looks)
