# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The `?` of a panel's header."""

from __future__ import annotations

from ..core import manual


class Documented:
    """A panel with a page of the manual."""

    manual_page = "blender"

    def draw_header_preset(self, _context):
        if manual.is_there():
            row = self.layout.row()
            row.operator(
                "nacre.open_manual", text="", icon="QUESTION", emboss=False
            ).page = self.manual_page
