# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a file is spectral, what its lamps are, and what stays RGB."""

from __future__ import annotations

import bpy

from ..blender import wrapped
from ..core.computation import library_problem
from ..materials.documented import Documented
from . import marks, operators, outlook

_MOST_LAMPS, _MOST_COLOURS, _MOST_REMARKS = 12, 8, 8


class _Spectral(Documented):
    bl_label = "Spectral"
    manual_page = "spectral"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        if not marks.is_spectral():
            layout.operator("nacre.make_spectral", text="Make Spectral", icon="COLORSET_13_VEC")
            return
        _draw_lamps(layout, context.scene)
        _draw_surfaces(layout, context.object)
        _draw_remarks(layout)
        _draw_outlook(layout)
        row = layout.row()
        row.operator_context = "INVOKE_DEFAULT"
        row.scale_y = 1.3
        row.operator("nacre.render_spectral", text="Render Spectral…", icon="RENDER_STILL")
        row = layout.row(align=True)
        row.operator("nacre.make_spectral", text="Include New", icon="FILE_REFRESH")
        row.operator("nacre.make_rgb", text="Back to RGB", icon="X")


def _draw_lamps(layout, scene) -> None:
    lamps = [(item.name, item.data.node_tree) for item in scene.objects if item.type == "LIGHT"]
    if scene.world is not None:
        lamps.append((marks.WORLD, scene.world.node_tree))
    column = layout.column(align=True)
    for name, tree in lamps[:_MOST_LAMPS]:
        split = column.split(factor=0.45)
        split.label(text=name, icon="WORLD" if name == marks.WORLD else "LIGHT")
        row = split.row(align=True)
        row.operator_context = "INVOKE_DEFAULT"
        row.operator("nacre.give_light", text=marks.lit_by(tree) or "Its Colour").lamp = name
        row.operator("nacre.read_spectra", text="", icon="FILE_FOLDER").lamp = name
    if len(lamps) > _MOST_LAMPS:
        column.label(text=f"… and {len(lamps) - _MOST_LAMPS} more")


def _draw_surfaces(layout, item) -> None:
    """Of the active object's material."""
    if library_problem():
        return
    from . import give

    material = item.active_material if item is not None else None
    colours = give.colours_of(material) if material is not None else []
    metals = give.metals_of(material) if material is not None else []
    if not colours and not metals:
        return
    column = layout.column(align=True)
    for metal in metals:
        split = column.split(factor=0.45)
        split.label(text="n and k" if len(metals) == 1 else metal.label, icon="MATERIAL")
        row = split.row()
        row.enabled = material.is_editable
        row.operator_context = "INVOKE_DEFAULT"
        button = row.operator("nacre.give_metal", text=metal.metal or "As Set")
        button.material, button.colour = material.name, metal.label
    names = [colour.socket.name for colour in colours]
    for colour in colours[:_MOST_COLOURS]:
        split = column.split(factor=0.45)
        is_only = names.count(colour.socket.name) == 1
        split.label(text=colour.socket.name if is_only else colour.label, icon="MATERIAL")
        row = split.row(align=True)
        row.enabled = material.is_editable
        row.operator_context = "INVOKE_DEFAULT"
        for name, text, icon in (
            ("nacre.give_reflectance", colour.spectrum or "Its Colour", "NONE"),
            ("nacre.read_spectra", "", "FILE_FOLDER"),
        ):
            button = row.operator(name, text=text, icon=icon)
            button.material, button.colour = material.name, colour.label


def _draw_outlook(layout) -> None:
    row = layout.row()
    column = row.column(align=True)
    for line in outlook.lines() or ["How many bands has not been asked"]:
        wrapped.label(column, line, "BLANK1")
    row.operator("nacre.look_at_bands", text="", icon="FILE_REFRESH", emboss=False)


def _draw_remarks(layout) -> None:
    found = operators.remarks()
    if not found:
        return
    box = layout.box()
    box.label(text="Stays RGB", icon="INFO")
    for remark in found[:_MOST_REMARKS]:
        row = box.row()
        wrapped.label(row.column(), f"{remark.where}: {remark.text}", "BLANK1")
        show = row.operator("nacre.show_rgb", text="", icon="RESTRICT_SELECT_OFF", emboss=False)
        show.kind, show.name = remark.kind, remark.name
    if len(found) > _MOST_REMARKS:
        box.label(text=f"… and {len(found) - _MOST_REMARKS} more")


class NACRE_PT_viewport_spectral(_Spectral, bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_order = 8


class NACRE_PT_render_spectral(_Spectral, bpy.types.Panel):
    bl_label = "Nacre Spectral"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"


CLASSES = (NACRE_PT_viewport_spectral, NACRE_PT_render_spectral)
