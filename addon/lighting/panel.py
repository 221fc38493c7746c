# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The offer of light where there is nothing to mirror, and the sliders of what was taken."""

from __future__ import annotations

import bpy

from ..materials.documented import Documented
from . import world as lighting


def draw_light(layout, scene) -> None:
    """An offer while there is nothing to mirror; the sliders of what was taken."""
    node = lighting.light_of(scene.world)
    if node is None:
        if not lighting.is_plain(scene.world):
            return
        box = layout.box()
        box.label(text="Nothing here for films to mirror", icon="WORLD")
        box.operator_menu_enum("nacre.light_scene", "light", text="Light the Scene")
        return
    column = layout.box().column(align=True)
    row = column.row(align=True)
    row.operator_menu_enum("nacre.light_scene", "light", text=node.label, icon="WORLD")
    row.operator("nacre.remove_light", text="", icon="X")
    for socket in node.inputs:
        column.prop(socket, "default_value", text=socket.name)


def draw_above(layout, context) -> None:
    """A part of the material's panels."""
    draw_light(layout, context.scene)


class NACRE_PT_viewport_light(Documented, bpy.types.Panel):
    bl_label = "Light"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_order = 1

    @classmethod
    def poll(cls, context):
        return lighting.light_of(context.scene.world) is not None

    def draw(self, context):
        draw_light(self.layout, context.scene)


CLASSES = (NACRE_PT_viewport_light,)
