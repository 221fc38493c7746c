# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks of the user's own, as a part of the extension."""

from __future__ import annotations

from ..materials import menu
from . import my_looks, operators, panel

CLASSES = (*operators.CLASSES, *panel.CLASSES)
PARTS = (my_looks, menu.entries(31, "save_look", "export_look", "import_look"))
