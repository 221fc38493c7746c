# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab in the viewport's side bar: pictures to choose from, light, and the active material."""

from __future__ import annotations

import bpy

from ..core.form import OSL
from ..core.library import Library
from ..nodes import chosen, lighting, thumbnails
from ..nodes.material import group_node
from ..nodes.script import has_osl
from . import wrapped
from .asset_build import draw_asset_build
from .panels import draw_light, draw_material

_LOCKED = (
    "Needs Open Shading Language, which this Blender was built without; blender.org's own has it."
)


class NACRE_PT_viewport(bpy.types.Panel):
    bl_label = "Nacre"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"

    def draw(self, context):
        layout = self.layout
        browser = context.window_manager.nacre
        entries = Library.default().entries()
        draw_asset_build(layout)
        layout.prop(browser, "search", text="", icon="VIEWZOOM")
        if browser.choice not in entries:
            layout.label(text=f"Nothing is found for “{browser.search}”", icon="INFO")
            return
        layout.template_icon_view(browser, "choice", show_labels=True, scale=8.0, scale_popup=6.0)
        entry = entries[browser.choice]
        row = layout.row(align=True)
        row.scale_y = 1.4
        assign = row.row(align=True)
        if entry.forms == (OSL,) and not has_osl():
            assign.enabled = False
            wrapped.label(layout, _LOCKED, "LOCKED")
        assign.operator("nacre.assign_material", text=f"Assign {entry.name}").material = entry.id
        favourites = chosen.favourites(entries)
        star = "SOLO_ON" if entry.id in favourites else "SOLO_OFF"
        row.operator("nacre.favourite", text="", icon=star).material = entry.id
        for title, found in (("Favourites", favourites), ("Recent", chosen.recent(entries))):
            _draw_row(layout, title, [entries[material_id] for material_id in found])


def _draw_row(layout, title: str, entries) -> None:
    if not entries:
        return
    layout.label(text=title)
    grid = layout.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    for entry in entries:
        icon = {"icon_value": thumbnails.icon(entry.id)}
        grid.operator("nacre.assign_material", text=entry.name, **icon).material = entry.id


class NACRE_PT_viewport_material(bpy.types.Panel):
    bl_label = "Active Material"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"

    @classmethod
    def poll(cls, context):
        return context.object is not None and group_node(context.object.active_material) is not None

    def draw(self, context):
        draw_material(self.layout, context)


class NACRE_PT_viewport_light(bpy.types.Panel):
    bl_label = "Light"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"

    @classmethod
    def poll(cls, context):
        """While there is a light, or something that could do with one."""
        world = context.scene.world
        is_lit = lighting.light_of(world) is not None
        return is_lit or (lighting.is_plain(world) and NACRE_PT_viewport_material.poll(context))

    def draw(self, context):
        draw_light(self.layout, context.scene)


CLASSES = (NACRE_PT_viewport, NACRE_PT_viewport_light, NACRE_PT_viewport_material)
