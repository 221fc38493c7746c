# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the library's materials as icons, read when they are first shown."""

from __future__ import annotations

import bpy.utils.previews

from ..core.catalogues import thumbnail

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


def unregister() -> None:
    while _collections:
        bpy.utils.previews.remove(_collections.pop())
