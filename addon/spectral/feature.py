# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral rendering, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Forgotten, Joined
from ..materials import material as made
from ..materials import menu
from . import operators, panel, render_operator


def _follow(material) -> None:
    from . import convert

    convert.follow(material)


CLASSES = (*operators.CLASSES, *render_operator.CLASSES, *panel.CLASSES)
PARTS = (
    Joined(made.WHEN_MADE, _follow),
    Forgotten(operators.forget),
    menu.entries(45, "make_spectral", "give_light", "render_spectral", "make_rgb"),
)
