# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab in the viewport's side bar: pictures to choose from, light, and the active material."""

from __future__ import annotations

import bpy

from ..assets.panel import draw_asset_build
from ..blender import wrapped
from ..core.form import OSL
from ..core.library import Entry, Library
from ..core.looks import variants
from ..films.panel import draw_progress
from ..lighting import world as lighting
from ..lighting.panel import draw_light
from ..materials.documented import Documented, OfWaveMaterial
from ..materials.material import group_node
from ..materials.panel import draw_material
from ..materials.script import has_osl
from ..materials.subject import active_material
from . import chosen, thumbnails
from .properties import finds_any

_LOCKED = (
    "Needs Open Shading Language, which this Blender was built without; blender.org's own has it."
)
_FIRST = (
    "tempered_steel",
    "soap_film",
    "oil_on_water",
    "rainbow_haematite",
    "rose_chafer",
    "car_paint_green_violet",
)
"""What is offered to those who have not found their own yet."""


class NACRE_PT_viewport(Documented, bpy.types.Panel):
    bl_label = "Nacre"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"

    def draw(self, context):
        layout = self.layout
        browser = context.window_manager.nacre
        offered = variants(Library.default().entries())
        draw_asset_build(layout)
        layout.prop(browser, "search", text="", icon="VIEWZOOM")
        if not finds_any(browser):
            layout.label(text=f"Nothing is found for “{browser.search}”", icon="INFO")
            return
        layout.template_icon_view(browser, "choice", show_labels=True, scale=8.0, scale_popup=6.0)
        chosen_one = offered[browser.choice]
        row = layout.row(align=True)
        row.scale_y = 1.4
        assign = row.row(align=True)
        if _is_locked(chosen_one.entry):
            assign.enabled = False
            wrapped.label(layout, _LOCKED, "LOCKED")
        text = f"Assign {chosen_one.name}"
        assign.operator("nacre.assign_material", text=text).material = chosen_one.key
        favourites = chosen.favourites(offered)
        star = "SOLO_ON" if chosen_one.key in favourites else "SOLO_OFF"
        row.operator("nacre.favourite", text="", icon=star).material = chosen_one.key
        # Here, where it is seen without scrolling; what was taken has a panel.
        is_dark = lighting.is_plain(context.scene.world)
        if is_dark and group_node(active_material(context)) is not None:
            draw_light(layout, context.scene)


class NACRE_PT_viewport_shelf(Documented, bpy.types.Panel):
    """Those that one comes back to, and until there are some, those to begin with."""

    bl_label = "Favourites and Recent"
    bl_parent_id = "NACRE_PT_viewport"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"

    @classmethod
    def poll(cls, context):
        return not context.window_manager.nacre.search

    def draw(self, _context):
        offered = variants(Library.default().entries())
        favourites, recent = chosen.favourites(offered), chosen.recent(offered)
        known = {*favourites, *recent}
        # In one grid, so that the pictures stay where they are when one of them is taken.
        first = [key for key in _FIRST if key in offered and key not in known]
        first = first[: max(0, len(_FIRST) - len(known))]
        title = " and to ".join(["Recent"] * bool(recent) + ["Begin With"] * bool(first))
        for text, found in (("Favourites", favourites), (title, [*recent, *first])):
            _draw_row(self.layout, text, [offered[key] for key in found])


def _is_locked(entry: Entry) -> bool:
    return entry.forms == (OSL,) and not has_osl()


def _draw_row(layout, title: str, shown) -> None:
    if not shown:
        return
    layout.label(text=title)
    grid = layout.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    for item in shown:
        column = grid.column(align=True)
        column.enabled = not _is_locked(item.entry)
        column.template_icon(icon_value=thumbnails.icon(item.key), scale=4.0)
        column.operator("nacre.assign_material", text=item.label).material = item.key


class NACRE_PT_viewport_material(OfWaveMaterial, bpy.types.Panel):
    manual_page = "thickness"
    bl_label = "Active Material"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_order = 2

    def draw(self, context):
        material = active_material(context)
        self.layout.prop(material, "name", text="", icon="MATERIAL")
        draw_progress(self.layout, material)
        draw_material(self.layout, context)


CLASSES = (
    NACRE_PT_viewport,
    NACRE_PT_viewport_shelf,
    NACRE_PT_viewport_material,
)
