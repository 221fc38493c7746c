# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object > Nacre, and entries in Blender's menus. F3 finds what stands in a menu, and nothing else."""

from __future__ import annotations

import bpy

from ..variations.drawn import LIKE, RANDOM


class NACRE_MT_object(bpy.types.Menu):
    bl_idname = "NACRE_MT_object"
    bl_label = "Nacre"

    def draw(self, _context):
        layout = self.layout
        layout.operator_context = "INVOKE_DEFAULT"
        layout.operator("nacre.assign_material", icon="SHADING_RENDERED")
        layout.operator("nacre.favourite", icon="SOLO_ON")
        layout.operator_menu_enum("nacre.light_scene", "light", icon="WORLD")
        layout.operator("nacre.remove_light")
        layout.separator()
        layout.menu("NACRE_MT_thickness", text="Nacre: Vary Thickness", icon="TEXTURE")
        for name in (
            "paint_thickness",
            "stop_painting",
            "open_thickness_image",
            "animate_thickness",
        ):
            layout.operator(f"nacre.{name}")
        layout.separator()
        for name in ("edit_stack", "add_layer", "revert_stack", "load_template", "save_template"):
            layout.operator(f"nacre.{name}")
        layout.separator()
        for kind, text in ((RANDOM, "Nacre: Randomise"), (LIKE, "Nacre: More Like This")):
            layout.operator("nacre.vary_look", text=text).kind = kind
        for name in ("save_look", "export_look", "import_look"):
            layout.operator(f"nacre.{name}")
        layout.separator()
        layout.operator("nacre.probe", icon="EYEDROPPER")
        layout.operator("nacre.viewport_picture", icon="IMAGE_DATA")
        for name in ("add_aovs", "remove_aovs"):
            layout.operator(f"nacre.{name}")
        layout.separator()
        for name in ("rebuild_material", "use_cycles", "use_cpu", "use_osl", "use_wavelengths"):
            layout.operator(f"nacre.{name}")
        layout.separator()
        for name in ("open_assets", "add_asset_library", "remove_asset_library"):
            layout.operator(f"nacre.{name}")
        layout.operator("nacre.open_manual", icon="HELP")
        layout.operator("nacre.copy_report", icon="COPYDOWN")


def _draw_submenu(self, _context) -> None:
    self.layout.separator()
    self.layout.menu("NACRE_MT_object", icon="SHADING_RENDERED")


def _draw_assign(self, _context) -> None:
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.operator(
        "nacre.assign_material", text="Assign Wave Material…", icon="SHADING_RENDERED"
    )


def _draw_view_entries(self, _context) -> None:
    self.layout.separator()
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.operator("nacre.probe", icon="EYEDROPPER")
    self.layout.operator("nacre.viewport_picture", icon="IMAGE_DATA")


_MENUS = (
    ("VIEW3D_MT_object", _draw_submenu),
    ("MATERIAL_MT_context_menu", _draw_assign),
    ("VIEW3D_MT_view", _draw_view_entries),
)


def add_to_menus() -> None:
    for name, draw in _MENUS:
        getattr(bpy.types, name).append(draw)


def remove_from_menus() -> None:
    for name, draw in _MENUS:
        getattr(bpy.types, name).remove(draw)


CLASSES = (NACRE_MT_object,)
