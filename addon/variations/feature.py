# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variations, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Forgotten
from ..materials import menu
from . import drawn, operators, panel


def _draw_menu(layout) -> None:
    for kind, text in ((drawn.RANDOM, "Nacre: Randomise"), (drawn.LIKE, "Nacre: More Like This")):
        layout.operator("nacre.vary_look", text=text).kind = kind


CLASSES = (*operators.CLASSES, *panel.CLASSES)
PARTS = (Forgotten(drawn.forget), menu.Entries(30, _draw_menu))
