# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""*Render Spectral*: pass after pass as render jobs, then one spectral picture."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

import bpy
from bpy.props import IntProperty, StringProperty

from ..blender import denoise, output
from ..core.computation import library_problem
from ..materials.guard import reports_errors
from . import marks

_POLL = 0.05  # seconds
RESULT = "Nacre Spectral"
"""Name of the picture that shows the last result."""


class NACRE_OT_render_spectral(bpy.types.Operator):
    bl_idname = "nacre.render_spectral"
    bl_label = "Nacre: Render Spectral"
    bl_description = (
        "Render the scene in bands of wavelengths, with as many samples as it has, into an EXR with a "
        "channel for each. Esc stops; what was rendered is kept, and the next render goes on from there"
    )

    filepath: StringProperty(
        name="File",
        description="Where the picture goes: .exr",
        subtype="FILE_PATH",
        default="//spectral.exr",
    )
    filter_glob: StringProperty(default="*.exr", options={"HIDDEN"})
    bands: IntProperty(
        name="Bands",
        description="Wavelengths, three a pass; 0: as many as the scene's lights need",
        default=0,
        min=0,
        max=300,
        step=3,
    )

    _job = None
    _timer = None

    @classmethod
    def poll(cls, context):
        problem = library_problem()
        if not problem and not marks.is_spectral():
            problem = "No colour of the file has a spectrum: Make Spectral first"
        if not problem and context.scene.camera is None:
            problem = "The scene has no camera"
        if problem:
            cls.poll_message_set(problem)
        return not problem

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        from . import engines, needs, rendering

        path = Path(bpy.path.abspath(self.filepath)).absolute().with_suffix(".exr")
        output.check([path])
        scene = context.scene
        made = needs.plan_for(scene, -(-self.bands // 3) or None)
        engine = engines.engine_of(scene)
        samples, smooth = engine.samples, engine.denoises
        passes = rendering.beside(path, scene, made, samples, denoise=smooth)
        passes.begin(resume=True)
        job = _Job(scene, passes, samples, path, smooth)
        if bpy.app.background:
            with job:
                while job.begin_next():
                    bpy.ops.render.render(scene=scene.name)
                    job.keep()
            return self._written(job)
        self._job = job
        job.__enter__()
        window_manager = context.window_manager
        self._timer = window_manager.event_timer_add(_POLL, window=context.window)
        window_manager.modal_handler_add(self)
        self._start(context)
        return {"RUNNING_MODAL"}

    def _start(self, context) -> None:
        job = self._job
        if job.begin_next():
            context.workspace.status_text_set(
                f"Render Spectral: pass {job.number + 1} of {job.passes.plan.passes}; Esc stops"
            )
            bpy.ops.render.render("INVOKE_DEFAULT", scene=job.scene.name)

    def modal(self, context, event):
        if event.type != "TIMER" or bpy.app.is_job_running("RENDER"):
            return {"PASS_THROUGH"}
        return self._go_on(context)

    @reports_errors
    def _go_on(self, context):
        job = self._job
        try:
            if job.outcome == "cancel":
                self._end(context)
                self.report({"WARNING"}, "Stopped; the next Render Spectral goes on from here")
                return {"CANCELLED"}
            if job.outcome == "complete":
                job.keep()
                self._start(context)
            if job.number is not None:
                return {"RUNNING_MODAL"}
        except Exception:
            self._end(context)
            raise
        self._end(context)
        return self._written(job)

    def _written(self, job: _Job):
        job.write()
        plan = job.passes.plan
        said = f"{job.path} written: {len(plan.bands)} bands in {plan.passes} passes"
        if job.scene.render.engine == "CYCLES" and job.scene.cycles.use_denoising:
            said += "" if denoise.is_possible() else f"; {denoise.NOT_POSSIBLE}"
        self.report({"INFO"}, said)
        return {"FINISHED"}

    def cancel(self, context):
        self._end(context)

    def _end(self, context) -> None:
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            context.workspace.status_text_set(None)
            self._timer = None
            self._job.__exit__(None, None, None)


class _Job:
    """The passes of one picture, of which one is being rendered; the scene is as it was at the end."""

    def __init__(
        self, scene: bpy.types.Scene, passes, samples: int, path: Path, denoise: bool
    ) -> None:
        self.scene, self.passes, self.path, self._denoise = scene, passes, path, denoise
        self.number: int | None = None
        self.outcome = ""  # of a render job: complete or cancel
        self._samples = samples
        self._missing = iter(passes.missing())
        self._stack = ExitStack()

    def __enter__(self) -> _Job:
        from . import rendering

        self._begin = self._stack.enter_context(
            rendering.prepared(self.scene, self.passes.plan, self._samples, denoise=self._denoise)
        )
        for name, handler in (("render_complete", self._complete), ("render_cancel", self._cancel)):
            handlers = getattr(bpy.app.handlers, name)
            handlers.append(handler)
            self._stack.callback(handlers.remove, handler)
        return self

    def __exit__(self, *_error: object) -> None:
        self._stack.close()

    def begin_next(self) -> bool:
        """Tells the scene which pass is next; False where all are there."""
        self.outcome = ""
        self.number = next(self._missing, None)
        if self.number is not None:
            self._begin(self.number)
        return self.number is not None

    def keep(self) -> None:
        self.passes.save(self.scene, self.number)

    def write(self) -> None:
        from . import rendering

        found = rendering.rendered(self.passes)
        rgb = rendering.colour_of(found, self.scene, self._samples)
        rendering.write(found, rgb, self.scene, self.path)
        rendering.as_image(rgb, found.alpha, RESULT)
        self.passes.end()

    def _complete(self, *_arguments: object) -> None:
        self.outcome = "complete"

    def _cancel(self, *_arguments: object) -> None:
        self.outcome = "cancel"


CLASSES = (NACRE_OT_render_spectral,)
