# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral pictures after they were rendered, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Forgotten
from ..materials import menu
from . import operators, panel, properties

CLASSES = (*properties.CLASSES, *operators.CLASSES, *panel.CLASSES)
PARTS = (
    *properties.PARTS,
    Forgotten(properties.forget),
    menu.entries(46, "develop", "measure_spectrum", "save_spectra", "forget_spectrum"),
)
