# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of any size of what the viewport shows, rendered by the scene's engine."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import IntProperty, StringProperty

from ..blender import output
from ..materials.guard import reports_errors
from . import viewport
from .camera import begin_aside, end_aside, use_view
from .view import height_for

_POLL = 0.1  # seconds


class Shot:
    """One picture: a scene aside from `begin` to `end`. The scene itself is never changed."""

    def __init__(self, context, view: viewport.Viewport, path: Path, size: tuple[int, int]):
        output.check([path])
        self.path = path
        self.outcome = ""  # of a render job: complete or cancel
        self.aside = begin_aside(context.scene, context.view_layer)
        try:
            use_view(self.aside, view.frame(size), view.data.view_matrix)
            render = self.aside.render
            render.resolution_x, render.resolution_y = size
            render.use_border = False
        except Exception:
            self.end()
            raise

    def use_samples(self, samples: int) -> None:
        """0: as many as the scene has."""
        if samples:
            self.aside.cycles.samples = self.aside.eevee.taa_render_samples = samples

    def render(self) -> None:
        """Waits for it."""
        bpy.ops.render.render(scene=self.aside.name)

    def start(self) -> None:
        """As a job, which shows its progress; Esc ends it."""
        for name, handler in self._handlers():
            getattr(bpy.app.handlers, name).append(handler)
        bpy.ops.render.render("INVOKE_DEFAULT", scene=self.aside.name)

    def save(self) -> None:
        output.Writer(self.aside).save(self.path)

    def end(self) -> None:
        """Takes away all that was added to the file; may be called twice."""
        for name, handler in self._handlers():
            handlers = getattr(bpy.app.handlers, name)
            if handler in handlers:
                handlers.remove(handler)
        if self.aside is not None:
            end_aside(self.aside)
            self.aside = None

    def _handlers(self):
        return ("render_complete", self._complete), ("render_cancel", self._cancel)

    def _complete(self, *_arguments) -> None:
        self.outcome = "complete"

    def _cancel(self, *_arguments) -> None:
        self.outcome = "cancel"


class NACRE_OT_viewport_picture(bpy.types.Operator):
    bl_idname = "nacre.viewport_picture"
    bl_label = "Nacre: Picture of the Viewport"
    bl_description = "Render what the viewport shows, at any size, into a PNG or EXR file"

    filepath: StringProperty(
        name="File",
        description="Where the picture goes: .png as it looks, .exr as linear light",
        subtype="FILE_PATH",
        default="//viewport.png",
    )
    filter_glob: StringProperty(default="*.png;*.exr", options={"HIDDEN"})
    width: IntProperty(name="Width", description="In pixels", min=4, max=65536, default=1920)
    height: IntProperty(
        name="Height", description="0: as the viewport has it", min=0, max=65536, default=0
    )
    samples: IntProperty(name="Samples", description="0: the scene's own", min=0)

    _shot: Shot | None = None
    _timer = None

    @classmethod
    def poll(cls, context):
        if viewport.of_context(context) is None:
            cls.poll_message_set("There is no 3D viewport in this window")
            return False
        return True

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        view = viewport.of_context(context)
        size = self.width, self.height or max(4, height_for(self.width, view.size))
        self._shot = Shot(context, view, Path(bpy.path.abspath(self.filepath)).absolute(), size)
        try:
            self._shot.use_samples(self.samples)
            self._shot.start()
            window_manager = context.window_manager
            self._timer = window_manager.event_timer_add(_POLL, window=context.window)
            window_manager.modal_handler_add(self)
        except Exception:
            self._end(context)
            raise
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type != "TIMER" or bpy.app.is_job_running("RENDER"):
            return {"PASS_THROUGH"}
        return self._finish(context)

    @reports_errors
    def _finish(self, context):
        try:
            if self._shot.outcome != "complete":
                self.report({"WARNING"}, "Cancelled; nothing was written")
                return {"CANCELLED"}
            self._shot.save()
        finally:
            path = self._shot.path
            self._end(context)
        self.report({"INFO"}, f"{path} written")
        return {"FINISHED"}

    def cancel(self, context):
        self._end(context)

    def _end(self, context) -> None:
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            self._timer = None
        if self._shot is not None:
            self._shot.end()


CLASSES = (NACRE_OT_viewport_picture,)
