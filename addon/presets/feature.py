# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets of materials, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Joined
from ..materials import menu
from ..materials import panel as material_panel
from . import operators, panel


def _draw_menu(layout) -> None:
    layout.menu("NACRE_MT_presets", text="Nacre: Presets", icon="PRESET")


CLASSES = (*operators.CLASSES, *panel.CLASSES)
PARTS = (
    Joined(material_panel.SECTIONS, material_panel.Section(panel.draw, lambda _: None)),
    menu.Entries(12, _draw_menu),
)
