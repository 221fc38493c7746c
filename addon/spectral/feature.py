# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral rendering, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Forgotten
from ..materials import menu
from . import operators, panel, render_operator

CLASSES = (*operators.CLASSES, *render_operator.CLASSES, *panel.CLASSES)
PARTS = (
    Forgotten(operators.forget),
    menu.entries(45, "make_spectral", "give_light", "render_spectral", "make_rgb"),
)
