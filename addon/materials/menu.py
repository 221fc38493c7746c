# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Object > Nacre. F3 finds what stands in a menu, and nothing else: features put their operators here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import groupby

import bpy

_entries: list[Entries] = []


@dataclass(frozen=True)
class Entries:
    """Of a feature. Those whose `place` has the same tens stand together."""

    place: int
    draw: Callable[[bpy.types.UILayout], None]

    def register(self) -> None:
        _entries.append(self)

    def unregister(self) -> None:
        _entries.remove(self)


def entries(place: int, *names: str) -> Entries:
    """Operators, by their names after `nacre.`."""

    def draw(layout: bpy.types.UILayout) -> None:
        for name in names:
            layout.operator(f"nacre.{name}")

    return Entries(place, draw)


class NACRE_MT_object(bpy.types.Menu):
    bl_idname = "NACRE_MT_object"
    bl_label = "Nacre"

    def draw(self, _context):
        layout = self.layout
        layout.operator_context = "INVOKE_DEFAULT"
        in_order = sorted(_entries, key=lambda item: item.place)
        for number, (_, together) in enumerate(groupby(in_order, lambda item: item.place // 10)):
            if number:
                layout.separator()
            for item in together:
                item.draw(layout)


def draw_submenu(menu, _context) -> None:
    menu.layout.separator()
    menu.layout.menu("NACRE_MT_object", icon="SHADING_RENDERED")


CLASSES = (NACRE_MT_object,)
