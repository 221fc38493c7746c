# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One render whose paths draw their wavelengths."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

from ...blender import output
from ...blender.denoise import denoised
from ...blender.space import of_file
from ...core import exr
from ...core.space import conversion_from_xyz
from ...materials import scene as scenes
from .. import attributes, films
from ..engines import EngineError, having, layer_of, settings_of, white_lamps
from ..plan import Plan
from . import nodes
from .draws import draws


@dataclass(frozen=True)
class Picture:
    """rgb: float32 (height, width, 3) in the file's space, row 0 on top; alpha: (height, width)."""

    rgb: np.ndarray
    alpha: np.ndarray


def picture(scene: bpy.types.Scene, plan: Plan, *, denoise: bool = False) -> Picture:
    """The scene with its samples, after Blender's own progress. Raises ForeseenError."""
    with prepared(scene, plan, denoise=denoise):
        bpy.ops.render.render(scene=scene.name)
        return taken(scene, denoise=denoise)


def taken(scene: bpy.types.Scene, *, denoise: bool) -> Picture:
    """What was just rendered."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "paths.exr")
        output.Writer(scene, layers=True, compressed=False).save(file)
        width, height = exr.size_of(file)
        channels = exr.read_channels(file)

    def of(*names: str) -> np.ndarray:
        values = [np.frombuffer(channels[name], np.float32) for name in names]
        return np.stack(values, axis=-1).reshape(height, width, len(names))

    from_xyz = np.asarray(conversion_from_xyz(of_file()), np.float32)
    rgb = of(*(f"Combined.{channel}" for channel in "RGB")) @ from_xyz.T
    alpha = of("Combined.A")[..., 0]
    if denoise and "Denoising Albedo.R" in channels:
        white = np.asarray(of_file(), np.float32).sum(axis=1)  # of which an albedo of 1 is
        albedo = of(*(f"Denoising Albedo.{channel}" for channel in "RGB")) * white @ from_xyz.T
        normal = of(*(f"Denoising Normal.{axis}" for axis in "XYZ"))
        samples = scene.cycles.samples
        rgb = denoised(scene, layer_of(scene), samples, rgb, alpha, albedo, normal)
    return Picture(rgb, alpha)


@contextlib.contextmanager
def prepared(scene: bpy.types.Scene, plan: Plan, *, denoise: bool) -> Iterator[None]:
    """What is rendered meanwhile can be `taken`; all is as it was at the end. Raises ForeseenError."""
    if scene.render.engine != "CYCLES":
        raise EngineError(f"{scene.render.engine} has no paths: render with Cycles, or in bands")
    if not scenes.renderer(scene).has_osl:
        raise EngineError("this Blender has no Open Shading Language: render in bands")
    settings = [
        *settings_of(scene, denoise=denoise),
        *white_lamps(),
        (scene.cycles, "shading_system", True),
        (scene.cycles, "use_denoising", False),
    ]
    if scenes.state(scene).gpu_without_osl:
        settings.append((scene.cycles, "device", "CPU"))
    with (
        having(settings),
        scenes.wavelengths(scene),
        films.in_bands(plan, at_once=True),
        nodes.in_place(scene, draws(plan)),
    ):
        attributes.put(scene, {attributes.IS_SPECTRAL: 1.0})
        try:
            yield
        finally:
            attributes.take_away(scene)
