# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What every wave material adds to Blender."""

from __future__ import annotations

from ..blender import icons
from ..blender.parts import Forgotten, InMenu
from . import fallback, fix, follow, limits, menu, panel, preferences, properties, schema

CLASSES = (
    *properties.CLASSES,
    preferences.NACRE_preferences,
    *fix.CLASSES,
    *panel.CLASSES,
    *menu.CLASSES,
)
PARTS = (
    properties,
    schema,
    fallback,
    follow,
    limits,
    menu.entries(50, "rebuild_material", "use_cycles", "use_cpu", "use_osl", "use_wavelengths"),
    InMenu("VIEW3D_MT_object", menu.draw_submenu),
    Forgotten(icons.unregister),
)
