# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures in bands as render jobs of Blender: their passes one after another, which can be stopped and gone
on with."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path

import bpy

from ..blender import output
from ..blender.float_image import as_image
from ..core import spectral_image
from . import rendering
from .engines import engine_of
from .paths import render
from .plan import Plan

RESULT = "Nacre Spectral"
"""Name of the picture that shows the last result."""


class _Watched:
    """How render jobs of Blender end: `outcome` is complete or cancel."""

    def __init__(self, scene: bpy.types.Scene, path: Path, plan: Plan) -> None:
        self.scene, self.path, self.plan = scene, path, plan
        self.outcome = ""
        self._stack = ExitStack()

    def __enter__(self):
        self._prepare()
        for name, handler in (("render_complete", self._complete), ("render_cancel", self._cancel)):
            handlers = getattr(bpy.app.handlers, name)
            handlers.append(handler)
            self._stack.callback(handlers.remove, handler)
        return self

    def __exit__(self, *_error: object) -> None:
        self._stack.close()

    def _complete(self, *_arguments: object) -> None:
        self.outcome = "complete"

    def _cancel(self, *_arguments: object) -> None:
        self.outcome = "cancel"


class Job(_Watched):
    """The passes of one picture, of which one is being rendered; the scene is as it was at the end."""

    def __init__(self, scene: bpy.types.Scene, path: Path, plan: Plan) -> None:
        super().__init__(scene, path, plan)
        engine = engine_of(scene)
        self._number: int | None = None
        self._samples, self._denoise = engine.samples, engine.denoises
        self._passes = rendering.beside(path, scene, plan, self._samples, denoise=self._denoise)

    def _prepare(self) -> None:
        self._passes.begin(resume=True)
        self._missing = iter(self._passes.missing())
        self._begin = self._stack.enter_context(
            rendering.prepared(self.scene, self.plan, self._samples, denoise=self._denoise)
        )

    @property
    def status(self) -> str:
        return f"pass {self._number + 1} of {self.plan.passes}"

    def begin_next(self) -> bool:
        """Tells the scene which pass is next; False where all are there."""
        self.outcome = ""
        self._number = next(self._missing, None)
        if self._number is not None:
            self._begin(self._number)
        return self._number is not None

    def keep(self) -> None:
        """The pass that was rendered."""
        self._passes.save(self.scene, self._number)

    def write(self) -> None:
        """The picture, of all passes."""
        found = rendering.rendered(self._passes)
        rgb = rendering.colour_of(found, self.scene, self._samples)
        rendering.write(found, rgb, self.scene, self.path)
        as_image(rgb, found.alpha, RESULT)[spectral_image.FILE] = str(self.path)
        self._passes.end()


class PathJob(_Watched):
    """One render, whose paths draw their wavelengths."""

    status = "wavelengths by path"
    _picture: render.Picture | None = None
    _is_begun = False

    def _prepare(self) -> None:
        self._denoise = engine_of(self.scene).denoises
        self._stack.enter_context(render.prepared(self.scene, self.plan, denoise=self._denoise))

    def begin_next(self) -> bool:
        """True the first time."""
        self.outcome = ""
        is_next, self._is_begun = not self._is_begun, True
        return is_next

    def keep(self) -> None:
        self._picture = render.taken(self.scene, denoise=self._denoise)

    def write(self) -> None:
        image = as_image(self._picture.rgb, self._picture.alpha, RESULT)
        output.Writer(self.scene).save(self.path, image)
        image.pop(spectral_image.FILE, None)


def pictures(
    scene: bpy.types.Scene,
    path: Path,
    plan: Plan,
    frames: Iterable[int] | None,
    *,
    by_paths: bool = False,
) -> Iterator[Job | PathJob]:
    """One of the scene as it is, or one for each frame, where what is there already is left out if the scene
    does not overwrite; then the scene is at its own frame again at the end."""
    kind = PathJob if by_paths else Job
    if frames is None:
        yield kind(scene, path, plan)
        return
    current = scene.frame_current
    try:
        for frame in frames:
            file = output.frame_path(path, frame)
            if scene.render.use_overwrite or not file.is_file():
                scene.frame_set(frame)
                yield kind(scene, file, plan)
    finally:
        scene.frame_set(current)
