# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measure a point of a wave material: thickness, angle, spectrum and colour."""

from __future__ import annotations

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty

from ..blender.windows import begin_pick, end_pick, redraw_panels
from ..materials.guard import reports_errors
from . import viewport
from .pixel import in_picture, in_viewport
from .probe import Probe

_last: list[Probe] = []  # one at most; a session's, so that undo leaves it alone


def last() -> Probe | None:
    return _last[0] if _last else None


class NACRE_OT_probe(bpy.types.Operator):
    bl_idname = "nacre.probe"
    bl_label = "Nacre: Probe a Point"
    bl_description = (
        "Click a point: thickness, angle, spectrum and exact colour of the film there. Esc cancels"
    )

    x: IntProperty(name="X", description="Pixels from the left", min=0)
    y: IntProperty(name="Y", description="Pixels from the top", min=0)
    camera: BoolProperty(
        name="Camera",
        description="A pixel of the camera's picture; off: of the viewport",
        default=False,
    )
    _view: viewport.Viewport | None = None

    def invoke(self, context, _event):
        if self.properties.is_property_set("x") or context.window is None:
            return self.execute(context)
        return begin_pick(self, context, "Click a point of a film to probe it, Esc to cancel")

    def modal(self, context, event):
        if event.type in {"ESC", "RIGHTMOUSE"}:
            end_pick(context)
            return {"CANCELLED"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            # Everything else goes on, such as turning the view.
            return {"PASS_THROUGH"}
        end_pick(context)
        found = viewport.under_mouse(context.window, (event.mouse_x, event.mouse_y))
        if found is None:
            self.report({"WARNING"}, "That was outside of the 3D viewport")
            return {"CANCELLED"}
        self._view, (self.x, self.y) = found
        return self.execute(context)

    @reports_errors
    def execute(self, context):
        pixel = (self.x, self.y)
        view = self._view or (None if self.camera else viewport.of_context(context))
        place = (context.scene, context.view_layer, pixel)
        found = in_viewport(*place, view) if view else in_picture(*place)
        _last[:] = [found]
        context.window_manager.nacre_probe.json = found.json()
        redraw_panels()
        return {"FINISHED"}


class NACRE_OT_copy_probe(bpy.types.Operator):
    bl_idname = "nacre.copy_probe"
    bl_label = "Nacre: Copy What Was Probed"
    bl_description = "Copy what the probe found to the clipboard"

    what: EnumProperty(
        name="What",
        description="How much of what was found",
        items=(
            ("text", "Text", "All numbers as lines", 0),
            ("json", "JSON", "All numbers and both spectra", 1),
            ("line", "Line", "One of the lines", 2),
        ),
        default="text",
    )
    line: IntProperty(name="Line", description="Which of the lines, from 0", min=0)

    @classmethod
    def poll(cls, _context):
        if last() is None:
            cls.poll_message_set("Probe a point first")
            return False
        return True

    def execute(self, context):
        found = last()
        if self.what == "line":
            lines = found.lines()
            text = lines[min(self.line, len(lines) - 1)][1]
        else:
            text = found.json() if self.what == "json" else found.text()
        context.window_manager.clipboard = text
        return {"FINISHED"}


def forget() -> None:
    _last.clear()


CLASSES = (NACRE_OT_probe, NACRE_OT_copy_probe)
