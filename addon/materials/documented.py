# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels have in common: the `?` of a header, and when there is something to show."""

from __future__ import annotations

from ..core import manual
from .material import group_node
from .subject import active_material


def explain(layout, page: str, text: str) -> None:
    """A sign whose tooltip says it: Blender has one text for all inputs of nodes."""
    button = layout.operator("nacre.open_manual", text="", icon="INFO", emboss=False)
    button.page, button.said = page, text


class Documented:
    """A panel with a page of the manual."""

    manual_page = "blender"

    def draw_header_preset(self, _context):
        if manual.is_there():
            row = self.layout.row()
            row.operator(
                "nacre.open_manual", text="", icon="QUESTION", emboss=False
            ).page = self.manual_page


class OfWaveMaterial(Documented):
    """A panel of the active object's wave material."""

    @classmethod
    def poll(cls, context):
        return group_node(active_material(context)) is not None
