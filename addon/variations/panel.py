# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variations of the active material as small balls to click."""

from __future__ import annotations

import bpy

from ..blender import icons, wrapped
from ..materials.documented import OfWaveMaterial
from ..materials.subject import active_material
from . import drawn as variations
from . import pictures
from .drawing import State, words

_SIZE = 96  # pixels of a picture


class _Variations(OfWaveMaterial):
    bl_label = "Variations"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        material = active_material(context)
        if not variations.knobs(material, with_colours=False):
            wrapped.label(layout, "Nothing here varies: all inputs are linked or animated", "INFO")
            return
        row = layout.row(align=True)
        for kind, text, icon in (
            (variations.RANDOM, "Randomise", "FILE_REFRESH"),
            (variations.LIKE, "More Like This", "DUPLICATE"),
        ):
            row.operator("nacre.vary_look", text=text, icon=icon).kind = kind
        drawn = variations.drawn(material)
        if drawn is None:
            return
        grid = layout.grid_flow(row_major=True, columns=4, even_columns=True, align=True)
        for index, state in enumerate(drawn.states):
            _draw_one(grid, material, index, state)


def _draw_one(layout, material: bpy.types.Material, index: int, state: State) -> None:
    shown = pictures.subject(material, state)
    column = layout.column(align=True)
    text = "Back" if index == 0 else str(index)
    if shown is None:
        said = words(variations.knobs(material, with_colours=False), state)
        text = f"{text}: {said}" if said else text
    else:
        name = f"{material.session_uid}:variation:{index}"
        icon = icons.drawn(name, (shown, _SIZE), pictures.draw)
        column.template_icon(icon_value=icon, scale=3.2)
    taken = column.operator(
        "nacre.take_variation", text=text, depress=variations.is_now(material, state)
    )
    taken.index = index


class NACRE_PT_viewport_variations(_Variations, bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_order = 3


class NACRE_PT_material_variations(_Variations, bpy.types.Panel):
    bl_parent_id = "NACRE_PT_material"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


CLASSES = (NACRE_PT_viewport_variations, NACRE_PT_material_variations)
