# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the asset library by itself, once and again after updates, in a Blender of its own without a
window: the one that the artist sees goes on."""

from __future__ import annotations

import subprocess
import sys
import threading
from dataclasses import dataclass, field
from pathlib import Path

import bpy

from ..blender.windows import redraw_panels
from ..materials.preferences import preferences
from . import build as assets

PROGRESS = "NACRE"
"""Lines of the other's standard output: this word, how many materials are done, of how many."""

_WAIT, _POLL = 2.0, 0.25  # seconds: after the start, and between looks


@dataclass
class _Job:
    process: subprocess.Popen
    folder: Path
    done: int = 0
    count: int = 0
    shown: int = -1  # how many were done when panels were last drawn
    said: list[str] = field(default_factory=list)


_jobs: list[_Job] = []  # one at most
_results: list[str] = []  # of this session, until somebody has seen it


def begin(folder: Path) -> None:
    """Starts, unless it is on its way."""
    if _jobs:
        return
    driver = str(Path(__file__).resolve().parents[1] / "background" / "driver.py")
    program = bpy.app.binary_path
    command = (
        [program, "--background", "--factory-startup", "--python", driver, "--"]
        if program
        else [sys.executable, driver]
    )
    process = subprocess.Popen(
        [*command, "assets", str(folder)],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        encoding="utf-8",
        errors="replace",
    )
    job = _Job(process, folder)
    _jobs.append(job)
    for read, stream in ((_read_progress, process.stdout), (_read_problems, process.stderr)):
        threading.Thread(target=read, args=(job, stream), daemon=True).start()
    if not bpy.app.timers.is_registered(look):
        bpy.app.timers.register(look, first_interval=_POLL, persistent=True)


def _read_progress(job: _Job, stream) -> None:
    for line in stream:
        words = line.split()
        if len(words) == 3 and words[0] == PROGRESS:
            job.done, job.count = int(words[1]), int(words[2])


def _read_problems(job: _Job, stream) -> None:
    for line in stream:
        job.said.append(line.rstrip())
        del job.said[:-20]


def look() -> float | None:
    """The timer; also to be called where there are none."""
    if not _jobs:
        return None
    job = _jobs[0]
    status = job.process.poll()
    if status is not None or job.done != job.shown:
        job.shown = job.done
        redraw_panels()
    if status is None:
        return _POLL
    _jobs.clear()
    if status == 0 and assets.is_built(job.folder):
        assets.show(job.folder)
        _results[:] = [f"{job.count} materials are ready"]
    else:
        why = job.said[-1] if job.said else f"Blender ended with status {status}"
        _results[:] = [f"The asset library was not made: {why}"]
    return None


def progress() -> tuple[int, int] | None:
    """Materials that are done, and all of them, while it is on its way."""
    return (_jobs[0].done, _jobs[0].count) if _jobs else None


def result() -> str:
    """What came of it, until `dismiss`."""
    return _results[0] if _results else ""


def dismiss() -> None:
    _results.clear()


def _begin_if_wanted() -> None:
    kept = preferences()
    folder = assets.default_folder()
    if kept is not None and kept.keep_assets and not assets.is_current(folder):
        begin(folder)


def register() -> None:
    if not bpy.app.background:
        bpy.app.timers.register(_begin_if_wanted, first_interval=_WAIT, persistent=True)


def unregister() -> None:
    for timer in (_begin_if_wanted, look):
        if bpy.app.timers.is_registered(timer):
            bpy.app.timers.unregister(timer)
    while _jobs:
        job = _jobs.pop()
        job.process.kill()
        job.process.wait()
    dismiss()
