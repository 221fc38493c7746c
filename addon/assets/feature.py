# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The asset library, as a part of the extension."""

from __future__ import annotations

from bpy.props import BoolProperty

from ..blender.parts import Joined
from ..materials import menu, preferences
from . import build, operators, panel, process

preferences.keep(
    keep_assets=BoolProperty(
        name="Keep the Asset Library",
        description="Make the asset library by itself after installing and after updates, aside",
        default=True,
    )
)

CLASSES = operators.CLASSES
PARTS = (
    Joined(preferences.SECTIONS, panel.draw_preferences),
    build,
    process,
    menu.entries(60, "open_assets", "add_asset_library", "remove_asset_library"),
)
