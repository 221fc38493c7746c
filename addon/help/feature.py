# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual and reports, as a part of the extension."""

from __future__ import annotations

from ..materials import menu
from . import operators


def _draw_menu(layout) -> None:
    layout.operator("nacre.open_manual", icon="HELP")
    layout.operator("nacre.copy_report", icon="COPYDOWN")


CLASSES = operators.CLASSES
PARTS = (operators, menu.Entries(61, _draw_menu))
