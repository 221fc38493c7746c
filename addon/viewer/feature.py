# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Probe, views, passes and pictures of the viewport, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Forgotten, InMenu
from ..materials import menu
from . import panel, pass_operators, picture, probe_operators, properties, views


def _draw_view_menu(layout) -> None:
    layout.operator("nacre.probe", icon="EYEDROPPER")
    layout.operator("nacre.viewport_picture", icon="IMAGE_DATA")


def _draw_in_view(self, _context) -> None:
    self.layout.separator()
    self.layout.operator_context = "INVOKE_DEFAULT"
    _draw_view_menu(self.layout)


CLASSES = (
    *properties.CLASSES,
    *pass_operators.CLASSES,
    *picture.CLASSES,
    *probe_operators.CLASSES,
    *panel.CLASSES,
)
PARTS = (
    *properties.PARTS,
    views,
    Forgotten(probe_operators.forget),
    menu.Entries(40, _draw_view_menu),
    menu.entries(41, "add_aovs", "remove_aovs"),
    InMenu("VIEW3D_MT_view", _draw_in_view),
)
