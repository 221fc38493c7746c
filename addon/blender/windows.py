# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows: panels that show something that changed by itself, and clicks that pick a place."""

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


def begin_pick(operator: bpy.types.Operator, context: bpy.types.Context, words: str) -> set[str]:
    """For `invoke`: `modal` waits for clicks, and the status bar says `words`."""
    context.window.cursor_modal_set("EYEDROPPER")
    context.workspace.status_text_set(words)
    context.window_manager.modal_handler_add(operator)
    return {"RUNNING_MODAL"}


def end_pick(context: bpy.types.Context) -> None:
    context.window.cursor_modal_restore()
    context.workspace.status_text_set(None)


def within(region: bpy.types.Region, mouse: tuple[int, int]) -> tuple[int, int] | None:
    """A place of the window from the region's bottom left; None where it is not in it."""
    x, y = mouse[0] - region.x, mouse[1] - region.y
    return (x, y) if 0 <= x < region.width and 0 <= y < region.height else None
