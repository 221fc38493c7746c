# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Thickness that varies over a surface, as a part of the extension."""

from __future__ import annotations

from bpy.props import BoolProperty

from ..blender.parts import Extended, Joined
from ..materials import limits, menu, panel, subject
from ..materials.properties import NACRE_PG_session
from ..materials.thickness import thickness_socket
from . import followed, operators
from . import limits as of_sources
from . import panel as sources_panel


def _draw_menu(layout) -> None:
    layout.menu("NACRE_MT_thickness", text="Nacre: Vary Thickness", icon="TEXTURE")


CLASSES = operators.CLASSES
PARTS = (
    Extended(
        NACRE_PG_session,
        shows_fine=BoolProperty(
            name="More", description="Show what is seldom changed, too", default=False
        ),
    ),
    Joined(subject.STAND_INS, followed.follower),
    Joined(limits.FURTHER, of_sources.of_sources),
    Joined(panel.SECTIONS, panel.Section(sources_panel.draw, thickness_socket)),
    menu.Entries(10, _draw_menu),
    menu.entries(
        11, "paint_thickness", "stop_painting", "open_thickness_image", "animate_thickness"
    ),
)
