# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps edited materials up to date: quick tables at each edit, the whole material a moment later,
compiled in a thread of its own while the interface goes on."""

from __future__ import annotations

import threading
import time
from collections.abc import Container

import bpy
from bpy.app.handlers import persistent

from ..blender.windows import redraw_panels
from ..core.faults import RecipeError
from ..core.manifest import ManifestError
from ..materials import recipe as recipes
from ..materials.material import belongs_here
from . import edited

WAIT = 0.4  # seconds without an edit
_POLL = 0.1

_edited_at: dict[int, float] = {}  # material's session_uid
_problems: dict[int, str] = {}
_jobs: list[_Compilation] = []  # one at most
_took = [1.5]  # seconds, the last one


class _Compilation(threading.Thread):
    def __init__(self, material: bpy.types.Material):
        super().__init__(name="nacre compile")
        self.uid = material.session_uid
        self.recipe = recipes.recipe(material)
        self.material_name = material.name
        self.began = time.monotonic()
        self.made = None
        self.problem = ""

    def run(self) -> None:
        try:
            self.made = recipes.compile_recipe(self.recipe, self.material_name)
        except (ManifestError, MemoryError, RuntimeError) as error:
            self.problem = str(error)


def changed(material: bpy.types.Material) -> None:
    """After each edit of the material's recipe."""
    _problems.pop(material.session_uid, None)
    try:
        edited.preview(material)
    except (RecipeError, ManifestError, ValueError) as error:  # NacreError is a ValueError
        _problems[material.session_uid] = str(error)
        return
    if edited.is_stale(material):
        _compile_soon(material)


def _compile_soon(material: bpy.types.Material) -> None:
    if not _has_timers():
        return
    _edited_at[material.session_uid] = time.monotonic()
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=_POLL)


def _has_timers() -> bool:
    """In background nobody runs them; saving compiles there."""
    return not bpy.app.background


def warm_up(material: bpy.types.Material) -> None:
    """Lets the first edit be as quick as the others: tables that every film needs are made once."""
    task = edited.preview_task(material)
    if task is not None:
        threading.Thread(target=task, name="nacre warm-up").start()


def refuse(material: bpy.types.Material, text: str) -> None:
    """An edit that cannot be stored."""
    _problems[material.session_uid] = text


def problem(material: bpy.types.Material) -> str:
    """What keeps the last edit from being seen, or nothing."""
    return _problems.get(material.session_uid, "")


def progress(material: bpy.types.Material) -> float | None:
    """How far the compilation that is due or under way is, by what the last one took; None: there is
    none."""
    if material.session_uid not in _edited_at:
        return None
    began = next((job.began for job in _jobs if job.uid == material.session_uid), None)
    return 0.0 if began is None else min((time.monotonic() - began) / _took[0], 0.95)


def finish_all() -> None:
    """Compiles every stale material, at once; what has problems stays as it was last right."""
    _wait()
    for material in bpy.data.materials:
        if not recipes.is_edited(material) or not belongs_here(material):
            continue
        _edited_at.pop(material.session_uid, None)
        try:
            edited.finish(material)
        except (RecipeError, ManifestError) as error:
            _problems[material.session_uid] = str(error)


def _tick() -> float | None:
    if _jobs:
        if _jobs[0].is_alive():
            redraw_panels()
            return _POLL
        _took[0] = max(time.monotonic() - _jobs[0].began, _POLL)
        _take(_jobs.pop())
    due = time.monotonic() - WAIT
    materials = _by_uid(_edited_at)
    for uid, since in list(_edited_at.items()):
        material = materials.get(uid)
        if material is None or not edited.is_stale(material):
            del _edited_at[uid]
        elif since <= due:
            _jobs.append(_Compilation(material))
            _jobs[0].start()
            redraw_panels()
            break
    return _POLL if _edited_at else None


def _take(done: _Compilation) -> None:
    material = _by_uid({done.uid}).get(done.uid)
    if material is None or not recipes.is_edited(material) or edited.damage(material):
        _edited_at.pop(done.uid, None)
        return
    if recipes.recipe(material) != done.recipe:
        return  # edited again meanwhile; the next turn compiles that
    _edited_at.pop(done.uid, None)
    if done.made is None:
        _problems[done.uid] = done.problem
        return
    edited.apply(material, done.made, done.recipe)
    redraw_panels(with_views=True)


def _by_uid(wanted: Container[int]) -> dict[int, bpy.types.Material]:
    """Those of the file, in one pass however many are wanted."""
    return {m.session_uid: m for m in bpy.data.materials if m.session_uid in wanted}


def _wait() -> None:
    while _jobs:
        _jobs[0].join()
        _take(_jobs.pop())


@persistent
def _before_save(*_arguments) -> None:
    finish_all()


@persistent
def _after_undo(*_arguments) -> None:
    """Texels are no part of a step: images go back to what is packed, and stale nodes are compiled."""
    for material in bpy.data.materials:
        if not recipes.is_edited(material) or edited.group_node(material) is None:
            continue
        if not belongs_here(material):
            continue
        for node in edited.group_node(material).node_tree.nodes:
            if node.type == "TEX_IMAGE" and node.image is not None and node.image.is_dirty:
                node.image.buffers_free()
        if edited.is_stale(material):
            changed(material)


@persistent
def _after_load(*_arguments) -> None:
    _forget()
    _resume()


def _resume() -> None:
    """Edits that were not compiled when the extension was turned off, or saved without it."""
    for material in bpy.data.materials:
        if belongs_here(material) and edited.is_stale(material):
            _compile_soon(material)


def _forget() -> None:
    _edited_at.clear()
    _problems.clear()


_HANDLERS = (
    ("save_pre", _before_save),
    ("undo_post", _after_undo),
    ("redo_post", _after_undo),
    ("load_post", _after_load),
)


def register() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)
    if _has_timers():  # while extensions are turned on at the start there is no file yet
        bpy.app.timers.register(_resume, first_interval=0.0)


def unregister() -> None:
    _wait()
    for timer in (_tick, _resume):
        if bpy.app.timers.is_registered(timer):
            bpy.app.timers.unregister(timer)
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    _forget()
