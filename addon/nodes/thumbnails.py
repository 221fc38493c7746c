# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the library's materials as icons, read when they are first shown."""

from __future__ import annotations

import bpy
import bpy.utils.previews

from ..core.catalogues import thumbnail
from ..core.library import Library

_START, _NEXT = 0.5, 0.01  # seconds

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []  # one at most


def icon(material_id: str) -> int:
    """0 where there is no picture."""
    if not _collections:
        _collections.append(bpy.utils.previews.new())
    icons = _collections[0]
    if material_id not in icons:
        file = thumbnail(material_id)
        if not file.is_file():
            return 0
        icons.load(material_id, str(file), "IMAGE")
    return icons[material_id].icon_id


def _warm_up() -> float | None:
    """One picture more; all of them at once, when the side bar is first shown, would be felt."""
    loaded = _collections[0] if _collections else ()
    for material_id in Library.default().entries():
        if material_id not in loaded and icon(material_id):
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
