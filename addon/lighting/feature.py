# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light for a scene, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Joined
from ..materials import menu
from ..materials import panel as material_panel
from . import operators, panel


def _draw_menu(layout) -> None:
    layout.operator_menu_enum("nacre.light_scene", "light", icon="WORLD")
    layout.operator("nacre.remove_light")


CLASSES = (*operators.CLASSES, *panel.CLASSES)
PARTS = (Joined(material_panel.ABOVE, panel.draw_above), menu.Entries(1, _draw_menu))
