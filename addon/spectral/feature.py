# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral rendering, as a part of the extension."""

from __future__ import annotations

import bpy

from ..blender.parts import Forgotten, Joined
from ..core.computation import library_problem
from ..materials import material as made
from ..materials import menu
from . import choices, marks, operators, outlook, panel, render_operator


def _follow(material: bpy.types.Material) -> None:
    """Where the library is missing, a file that is spectral already waits for *Include New*."""
    if not marks.is_spectral() or library_problem():
        return
    from . import convert

    convert.follow(material)


CLASSES = (*operators.CLASSES, *choices.CLASSES, *render_operator.CLASSES, *panel.CLASSES)
PARTS = (
    Joined(made.WHEN_MADE, _follow),
    Forgotten(operators.forget),
    Forgotten(choices.forget),
    Forgotten(outlook.forget),
    menu.entries(
        45,
        "make_spectral",
        "give_light",
        "give_reflectance",
        "give_metal",
        "read_spectra",
        "look_at_bands",
        "render_spectral",
        "make_rgb",
    ),
)
