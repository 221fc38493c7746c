# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What materials ask of a scene: engine, Open Shading Language, wavelengths through motion blur."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import bpy

from ..core.form import OSL, Renderer
from .problems import SceneState
from .script import has_osl


def renderer(scene: bpy.types.Scene) -> Renderer:
    return Renderer(
        has_osl=has_osl(),
        engine=scene.render.engine,
        device=scene.cycles.device,
        backend=_gpu_backend(),
    )


def state(scene: bpy.types.Scene, missing_tables: tuple[str, ...] = ()) -> SceneState:
    here = renderer(scene)
    return SceneState(
        engine=scene.render.engine,
        has_osl=here.has_osl,
        osl_on=here.has_osl and scene.cycles.shading_system,
        gpu_without_osl=here.device == "GPU" and here.backend not in ("NONE", "OPTIX"),
        motion_blur=scene.render.use_motion_blur,
        flat_shutter=_is_flat(scene),
        missing_tables=missing_tables,
    )


def use_osl(scene: bpy.types.Scene) -> bool:
    """Cycles with Open Shading Language; True if that changed anything."""
    changed = scene.render.engine != "CYCLES" or not scene.cycles.shading_system
    scene.render.engine = "CYCLES"
    scene.cycles.shading_system = True
    return changed


def use_wavelengths(scene: bpy.types.Scene) -> bool:
    """Lets OSL's `time` carry each path's wavelength; True if that changed anything.

    `time` varies along with motion blur only. A shutter of 0 keeps everything sharp, and its curve
    has to be flat, or else the wavelengths are not drawn evenly. Motion blur that is on already keeps
    its shutter.
    """
    changed = not scene.render.use_motion_blur or not _is_flat(scene)
    if not scene.render.use_motion_blur:
        scene.render.use_motion_blur = True
        scene.render.motion_blur_shutter = 0.0
    curve = scene.render.motion_blur_shutter_curve
    for point in curve.curves[0].points:
        point.location.y = 1.0
    curve.update()
    return changed


@contextlib.contextmanager
def wavelengths(scene: bpy.types.Scene) -> Iterator[None]:
    """`use_wavelengths` for a while."""
    render = scene.render
    before = render.use_motion_blur, render.motion_blur_shutter
    curve = render.motion_blur_shutter_curve
    heights = [point.location.y for point in curve.curves[0].points]
    try:
        use_wavelengths(scene)
        yield
    finally:
        render.use_motion_blur, render.motion_blur_shutter = before
        for point, height in zip(curve.curves[0].points, heights, strict=True):
            point.location.y = height
        curve.update()


def serve(scene: bpy.types.Scene, form: str, wavelength_per_path: bool) -> list[str]:
    """Gives the scene what a material of this form needs; returns what was changed, one sentence each."""
    said = []
    if form == OSL and has_osl():
        if use_osl(scene):
            said.append("Cycles now renders with Open Shading Language.")
        if wavelength_per_path and use_wavelengths(scene):
            said.append("Motion blur is on with a shutter of 0: it carries the wavelengths.")
    return said


def _is_flat(scene: bpy.types.Scene) -> bool:
    points = scene.render.motion_blur_shutter_curve.curves[0].points
    return all(abs(point.location.y - 1.0) < 1e-6 for point in points)


def _gpu_backend() -> str:
    cycles = bpy.context.preferences.addons.get("cycles")
    return cycles.preferences.compute_device_type if cycles else "NONE"
