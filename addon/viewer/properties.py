# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What materials show in place of their surface, and what the last probe found."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, PointerProperty, StringProperty

from ..blender.parts import Extended
from ..materials.properties import NACRE_PG_scene
from . import views
from .fields import FIELDS, SHADED

# The numbers are stored in .blend files: append, never reorder.
VIEWS = (
    (SHADED, "Shaded", "Materials as they are", 0),
    *((item.id, item.name, item.description, 1 + i) for i, item in enumerate(FIELDS)),
)


def _shown_view(_self) -> int:
    """Read from the nodes, so that undo and files agree with it."""
    shown = views.shown()
    return next(number for name, _, _, number in VIEWS if name == shown)


def _show_view(self, number: int) -> None:
    views.show(self.id_data, VIEWS[number][0])


def _is_lamp(_self, obj: bpy.types.Object) -> bool:
    return obj.type == "LIGHT"


def _on_lamp(self, _context) -> None:
    views.choose_lamp(self.id_data, self.view_lamp)


class NACRE_PG_probe(bpy.types.PropertyGroup):
    """What the last probe found, as JSON; of this session, in no file."""

    json: StringProperty(name="JSON", description="All numbers and both spectra")


CLASSES = (NACRE_PG_probe,)


PARTS = (
    Extended(
        NACRE_PG_scene,
        view=EnumProperty(
            name="View",
            description="What wave materials show; files are saved with their shaded surfaces",
            items=VIEWS,
            get=_shown_view,
            set=_show_view,
        ),
        view_lamp=PointerProperty(
            name="Lamp",
            description="What To Light points to; none: the nearest",
            type=bpy.types.Object,
            poll=_is_lamp,
            update=_on_lamp,
        ),
    ),
    Extended(bpy.types.WindowManager, nacre_probe=PointerProperty(type=NACRE_PG_probe)),
)
