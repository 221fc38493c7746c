# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""*Render Spectral*: pass after pass as render jobs, then one spectral picture, or one for each frame."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty

from ..blender import denoise, output
from ..core import wavelengths
from ..core.computation import library_problem
from ..materials.guard import reports_errors
from . import marks

_POLL = 0.05  # seconds


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

    wavelengths: StringProperty(
        name="Wavelengths",
        description="A band around each instead, as sensors have them: FIRST:LAST:STEP in nm, 400:700:10",
        default="",
    )
    mode: EnumProperty(
        name="Mode",
        description="How wavelengths are rendered",
        items=[
            (
                "BANDS",
                "Bands",
                "Passes of three wavelengths: hardly more noise than RGB, a channel for each wavelength, any "
                "GPU and EEVEE",
            ),
            (
                "PATHS",
                "Paths",
                "One render, in which each path draws three wavelengths: more noise in colours, RGB alone; "
                "Open Shading Language",
            ),
        ],
        default="BANDS",
    )
    animation: BoolProperty(
        name="Animation",
        description="All frames of the scene, each a file: #### in the name is the frame. Those that are there "
        "are left out where Overwrite is off in the output properties",
        default=False,
    )

    _jobs = None
    _job = None
    _timer = None
    _written = ()

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

    def execute(self, context):
        result = self._begin(context)
        if result != {"RUNNING_MODAL"}:
            self._end(context)
        return result

    @reports_errors
    def _begin(self, context):
        from . import needs, render_job

        path = Path(bpy.path.abspath(self.filepath)).absolute().with_suffix(".exr")
        output.check([path])
        scene = context.scene
        wanted = wavelengths.parse(self.wavelengths) if self.wavelengths else None
        plan = needs.plan_for(scene, -(-self.bands // 3) or None, wanted)
        steps = range(scene.frame_start, scene.frame_end + 1, scene.frame_step)
        self._jobs = render_job.pictures(
            scene, path, plan, steps if self.animation else None, by_paths=self.mode == "PATHS"
        )
        self._written = []
        if bpy.app.background:
            for job in self._jobs:
                with job:
                    while job.begin_next():
                        bpy.ops.render.render(scene=scene.name)
                        job.keep()
                self._write(job)
            return self._finish(context)
        window_manager = context.window_manager
        self._timer = window_manager.event_timer_add(_POLL, window=context.window)
        window_manager.modal_handler_add(self)
        return self._next_picture(context)

    def _next_picture(self, context):
        for job in self._jobs:
            self._job = job
            job.__enter__()
            if self._start(context):
                return {"RUNNING_MODAL"}
            self._close_job()
            self._write(job)
        return self._finish(context)

    def _start(self, context) -> bool:
        """The next pass of a picture; False where all are there."""
        job = self._job
        if not job.begin_next():
            return False
        context.workspace.status_text_set(
            f"Render Spectral: {job.path.name}, {job.status}; Esc stops"
        )
        bpy.ops.render.render("INVOKE_DEFAULT", scene=job.scene.name)
        return True

    def modal(self, context, event):
        if event.type != "TIMER" or bpy.app.is_job_running("RENDER"):
            return {"PASS_THROUGH"}
        result = self._go_on(context)
        if result != {"RUNNING_MODAL"}:
            self._end(context)
        return result

    @reports_errors
    def _go_on(self, context):
        job = self._job
        if job.outcome == "cancel":
            how = ", where Overwrite is off in the output properties" if self.animation else ""
            self.report({"WARNING"}, f"Stopped; the next Render Spectral goes on from here{how}")
            return {"CANCELLED"}
        if job.outcome != "complete":
            return {"RUNNING_MODAL"}
        job.keep()
        if self._start(context):
            return {"RUNNING_MODAL"}
        self._close_job()
        self._write(job)
        return self._next_picture(context)

    def _write(self, job) -> None:
        job.write()
        self._written.append(job)

    def _finish(self, context):
        if not self._written:
            self.report({"ERROR"}, "All frames are there already, and Overwrite is off")
            return {"CANCELLED"}
        job, render = self._written[-1], context.scene.render
        what = (
            job.path if len(self._written) == 1 else f"{len(self._written)} frames up to {job.path}"
        )
        how = "by paths" if self.mode == "PATHS" else f"in {job.plan.passes} passes"
        said = f"{what} written: {len(job.plan.bands)} bands {how}"
        if job.plan.choice is not None:
            said += f", within ΔE00 {job.plan.choice.error.mean:.2f} of all wavelengths"
        if render.engine == "CYCLES" and context.scene.cycles.use_denoising:
            said += "" if denoise.is_possible() else f"; {denoise.NOT_POSSIBLE}"
        self.report({"INFO"}, said)
        return {"FINISHED"}

    def cancel(self, context):
        self._end(context)

    def _close_job(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            job.__exit__(None, None, None)

    def _end(self, context) -> None:
        """Nothing is left of what was begun."""
        self._close_job()
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            context.workspace.status_text_set(None)
            self._timer = None
        if self._jobs is not None:
            self._jobs.close()
            self._jobs = None


CLASSES = (NACRE_OT_render_spectral,)
