# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the library's materials as icons, read when they are first shown."""

from __future__ import annotations

import bpy
import bpy.utils.previews

from ..core.catalogues import thumbnail
from ..core.library import Library
from ..core.looks import variants

_START, _NEXT = 0.5, 0.01  # seconds

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []  # one at most


def icon(key: str) -> int:
    """Of a variant; 0 where there is no picture."""
    if not _collections:
        _collections.append(bpy.utils.previews.new())
    icons = _collections[0]
    if key not in icons:
        file = thumbnail(key)
        if not file.is_file():
            return 0
        icons.load(key, str(file), "IMAGE")
    return icons[key].icon_id


def _warm_up() -> float | None:
    """One picture more; all of them at once, when the side bar is first shown, would be felt."""
    loaded = _collections[0] if _collections else ()
    for key in variants(Library.default().entries()):
        if key not in loaded and icon(key):
            return _NEXT
    return None


def register() -> None:
    if not bpy.app.background:
        bpy.app.timers.register(_warm_up, first_interval=_START, persistent=True)


def unregister() -> None:
    if bpy.app.timers.is_registered(_warm_up):
        bpy.app.timers.unregister(_warm_up)
    while _collections:
        bpy.utils.previews.remove(_collections.pop())
