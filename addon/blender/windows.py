# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows whose panels show something that changed by itself."""

from __future__ import annotations

import bpy

_AREAS = ("VIEW_3D", "PREFERENCES", "PROPERTIES", "NODE_EDITOR", "IMAGE_EDITOR")


def redraw_panels(*, with_views: bool = False) -> None:
    """The panels alone: what they lie beside is not drawn again, unless that is wanted."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type not in _AREAS:
                continue
            beside = [region for region in area.regions if region.type == "UI"]
            for part in [area] if with_views else beside or [area]:
                part.tag_redraw()
