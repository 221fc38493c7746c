# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A spectral picture in the image editor: who sees it, under which lamps, and what is at its places."""

from __future__ import annotations

import bpy

from ..blender import icons, wrapped
from ..materials.documented import Documented
from . import operators, session

_COLUMNS = 2
_MOST_PLACES = 12


class NACRE_PT_develop(Documented, bpy.types.Panel):
    bl_label = "Develop"
    bl_space_type = "IMAGE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"
    manual_page = "spectral"

    def draw(self, context):
        layout, shown = self.layout, session.shown()
        _draw_open(layout, context.space_data.image, shown)
        if shown is None:
            return
        settings = context.window_manager.nacre_develop
        layout.use_property_split = True
        layout.use_property_decorate = False
        column = layout.column()
        column.prop(settings, "viewer")
        if session.is_camera(settings.viewer):
            column.prop(settings, "raw")
        column.prop(settings, "white")
        column.prop(settings, "exposure")
        _draw_lamps(layout, settings, shown)
        if shown.problem:
            wrapped.label(layout, shown.problem, "ERROR")


def _draw_open(layout, image, shown) -> None:
    row = layout.row(align=True)
    row.operator_context = "INVOKE_DEFAULT"
    file = operators.file_of(image)
    if file is not None and (shown is None or file != shown.picture.path):
        row.operator(
            "nacre.develop", text=f"Develop {file.name}", icon="IMAGE_DATA"
        ).filepath = str(file)
    if shown is None:
        row.operator("nacre.develop", text="" if file else "Develop…", icon="FILE_FOLDER")
        return
    row.operator("nacre.develop", text="" if file else "Open…", icon="FILE_FOLDER")
    picture = shown.picture
    column = layout.column(align=True)
    column.label(text=picture.path.name, icon="IMAGE_DATA")
    width, height = picture.image.size
    column.label(text=f"{len(picture.bands)} bands, {width} × {height}", icon="BLANK1")


def _draw_lamps(layout, settings, shown) -> None:
    column = layout.column()
    has_groups = len(settings.lamps) > 1
    for lamp in settings.lamps:
        before = shown.picture.image.lamps.get(lamp.layer)
        if before is None and not lamp.layer and has_groups:
            continue
        box = column.column(align=True)
        name = lamp.layer or ("All Lamps" if has_groups else "Lamps")
        of = f"{name}: {before.light}" if before else name
        box.label(text=of, icon="LIGHT")
        if before is not None:
            row = box.row(align=True)
            row.prop(lamp, "light")
            row.operator_context = "INVOKE_DEFAULT"
            row.operator("nacre.read_spectra", text="", icon="FILE_FOLDER").is_light = True
        box.prop(lamp, "strength")


class NACRE_PT_develop_places(bpy.types.Panel):
    bl_label = "Spectra"
    bl_space_type = "IMAGE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_parent_id = "NACRE_PT_develop"

    @classmethod
    def poll(cls, _context):
        return session.shown() is not None

    def draw(self, context):
        layout, shown = self.layout, session.shown()
        settings = context.window_manager.nacre_develop
        row = layout.row(align=True)
        row.operator_context = "INVOKE_DEFAULT"
        row.operator("nacre.measure_spectrum", text="Measure", icon="EYEDROPPER")
        row.prop(settings, "side")
        if not shown.places:
            return
        row.operator("nacre.save_spectra", text="", icon="EXPORT")
        row.operator("nacre.forget_spectrum", text="", icon="TRASH").index = -1
        grid = layout.grid_flow(columns=_COLUMNS, row_major=True, even_columns=True)
        nm = shown.picture.bands.wavelength_nm
        for index, place in enumerate(shown.places[:_MOST_PLACES]):
            column = grid.column(align=True)
            row = column.row(align=True)
            row.label(text=f"{index + 1}:  {place.label}", icon_value=icons.chip(place.chip))
            row.operator("nacre.forget_spectrum", text="", icon="X", emboss=False).index = index
            curve = icons.curve(f"spectrum:{index}", place.curve(nm))
            column.template_icon(icon_value=curve, scale=6.0)
            column.label(text="  ".join(f"{channel:.2g}" for channel in place.rgb))
        if len(shown.places) > _MOST_PLACES:
            layout.label(text=f"… and {len(shown.places) - _MOST_PLACES} more")
        if len(shown.places) > 1:
            _draw_comparison(layout, settings, shown)


def _draw_comparison(layout, settings, shown) -> None:
    column = layout.column(align=True)
    column.label(text="1 and 2", icon="ARROW_LEFTRIGHT")
    row = column.row()
    row.use_property_split = True
    row.prop(settings, "under")
    if shown.apart is None:
        wrapped.label(column, shown.why_not_compared, "INFO")
        return
    column.label(text=f"ΔE00 {shown.apart.difference:.2f}", icon="BLANK1")
    column.label(text=f"Index of metamerism {shown.apart.index:.2f}", icon="BLANK1")


CLASSES = (NACRE_PT_develop, NACRE_PT_develop_places)
