# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the asset library is, and where it can be seen."""

from __future__ import annotations

from ..blender import asset_libraries, wrapped
from . import build as assets
from . import process


def draw_asset_build(layout) -> None:
    """Nothing where nothing is made."""
    progress = process.progress()
    if progress is not None:
        done, count = progress
        text = f"Asset library: {done} of {count}" if count else "Asset library: starting"
        layout.progress(factor=done / max(count, 1), text=text)
        return
    result = process.result()
    if not result:
        return
    box = layout.box()
    made = asset_libraries.is_listed(assets.default_folder())
    wrapped.label(box, result, "CHECKMARK" if made else "ERROR")
    row = box.row(align=True)
    if made:
        row.operator("nacre.open_assets", text="Open Asset Browser", icon="ASSET_MANAGER")
    row.operator("nacre.dismiss", text="" if made else "Close", icon="X")


def draw_preferences(layout, kept) -> None:
    layout.prop(kept, "keep_assets")
    draw_asset_build(layout)
    row = layout.row()
    if assets.is_built(assets.default_folder()):
        row.operator("nacre.add_asset_library", text="Rebuild Asset Library", icon="FILE_REFRESH")
        row.operator("nacre.remove_asset_library", text="Remove from Asset Browser", icon="X")
    else:
        row.operator("nacre.add_asset_library", text="Add to Asset Browser", icon="ASSET_MANAGER")
