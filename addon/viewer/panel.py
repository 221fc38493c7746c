# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a probe found, what materials show instead of their surface, passes, and pictures."""

from __future__ import annotations

import bpy

from ..blender import icons, wrapped
from ..films.messages import spoken
from ..materials import scene
from ..materials.documented import OfWaveMaterial
from . import passes, probe_operators


class _Viewer(OfWaveMaterial):
    manual_page = "viewer"
    bl_options = {"DEFAULT_CLOSED"}


class _Probe(_Viewer):
    bl_label = "Probe"

    def draw(self, _context):
        layout = self.layout
        row = layout.row(align=True)
        row.operator_context = "INVOKE_DEFAULT"
        row.operator("nacre.probe", text="Probe a Point", icon="EYEDROPPER")
        found = probe_operators.last()
        if found is None:
            return
        row.operator("nacre.copy_probe", text="", icon="COPYDOWN").what = "text"
        row.operator("nacre.copy_probe", text="", icon="FILE_SCRIPT").what = "json"
        column = layout.column(align=True)
        for index, (label, value) in enumerate(found.lines()):
            split = column.split(factor=0.3)
            split.label(text=label)
            row = split.row(align=True)
            row.label(text=value)
            copy = row.operator("nacre.copy_probe", text="", icon="COPYDOWN", emboss=False)
            copy.what, copy.line = "line", index
        if found.problem:
            for text in spoken(found.problem):
                wrapped.label(layout, text, "ERROR")
        _draw_spectra(layout, found)


def _draw_spectra(layout, found) -> None:
    row = layout.row()
    for name, light in (("R", found.reflected), ("T", found.transmitted)):
        if light is None:
            continue
        column = row.column(align=True)
        column.label(text=f"{name}, 380–780 nm")
        column.template_icon(icon_value=icons.curve(f"probe:{name}", light.spectrum), scale=6.0)


class _Views(_Viewer):
    bl_label = "Views and Passes"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(context.scene.nacre, "view")
        layout.prop(context.scene.nacre, "view_lamp")
        row = layout.row(align=True)
        if passes.present(context.scene):
            row.operator("nacre.remove_aovs", text="Remove Passes", icon="X")
            if scene.state(context.scene).osl_on:
                layout.label(text=passes.NOT_WITH_OSL, icon="ERROR")
        else:
            row.operator("nacre.add_aovs", text="Add Passes", icon="RENDERLAYERS")
        row = layout.row()
        row.operator_context = "INVOKE_DEFAULT"
        row.operator("nacre.viewport_picture", text="Picture of the Viewport…", icon="IMAGE_DATA")


class NACRE_PT_probe(_Probe, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "NACRE_PT_material"


class NACRE_PT_views(_Views, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "NACRE_PT_material"


class NACRE_PT_shader_editor_probe(_Probe, bpy.types.Panel):
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_parent_id = "NACRE_PT_shader_editor"


class NACRE_PT_shader_editor_views(_Views, bpy.types.Panel):
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_parent_id = "NACRE_PT_shader_editor"


CLASSES = (
    NACRE_PT_probe,
    NACRE_PT_views,
    NACRE_PT_shader_editor_probe,
    NACRE_PT_shader_editor_views,
)
