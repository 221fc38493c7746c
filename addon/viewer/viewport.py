# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pixels of 3D viewports, and the regions that are under the mouse."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from ..blender.windows import within
from .view import Frame, frame


@dataclass(frozen=True)
class Viewport:
    region: bpy.types.Region
    data: bpy.types.RegionView3D

    @property
    def size(self) -> tuple[int, int]:
        return self.region.width, self.region.height

    def frame(self, size: tuple[int, int]) -> Frame:
        return frame(self.data.window_matrix, size)


def of_context(context: bpy.types.Context) -> Viewport | None:
    """The viewport that an operator runs in, else the largest one of the window."""
    if context.region_data is not None and context.region.type == "WINDOW":
        return Viewport(context.region, context.region_data)
    found = list(_viewports(context.window)) if context.window else []
    return max(found, key=lambda view: view.size[0] * view.size[1], default=None)


def under_mouse(
    window: bpy.types.Window, mouse: tuple[int, int]
) -> tuple[Viewport, tuple[int, int]] | None:
    """The viewport there, and the pixel of it from its top left."""
    for view in _viewports(window):
        place = within(view.region, mouse)
        if place is not None:
            return view, (place[0], view.region.height - 1 - place[1])
    return None


def _viewports(window: bpy.types.Window):
    for area in window.screen.areas:
        if area.type != "VIEW_3D":
            continue
        regions = [region for region in area.regions if region.type == "WINDOW"]
        for index, region in enumerate(regions):
            quads = area.spaces.active.region_quadviews
            yield Viewport(region, quads[index] if quads else area.spaces.active.region_3d)
