# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Choosing a material, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import InMenu
from ..materials import menu
from . import assign, panel, properties, thumbnails


def _draw_menu(layout) -> None:
    layout.operator("nacre.assign_material", icon="SHADING_RENDERED")
    layout.operator("nacre.favourite", icon="SOLO_ON")


def _draw_assign(self, _context) -> None:
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.operator(
        "nacre.assign_material", text="Assign Wave Material…", icon="SHADING_RENDERED"
    )


CLASSES = (*assign.CLASSES, *panel.CLASSES)
PARTS = (
    *properties.PARTS,
    thumbnails,
    menu.Entries(0, _draw_menu),
    InMenu("MATERIAL_MT_context_menu", _draw_assign),
)
