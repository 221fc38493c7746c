# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a scene band by band, and puts the passes together to one spectral picture."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np

from ..blender import output
from ..blender.space import of_file
from ..core import exr, spectral_image
from ..core.faults import ForeseenError
from . import attributes
from .plan import Plan


class RenderError(ForeseenError):
    """A scene cannot be rendered in bands."""


def samples_for(samples: int, passes: int) -> int:
    """Of each pass, so that all passes together have `samples`, or a few more."""
    return max(1, -(-samples // passes))


@contextlib.contextmanager
def prepared(scene: bpy.types.Scene, plan: Plan, samples: int) -> Iterator[None]:
    """The scene renders a pass of `plan` whenever `begin_pass` was called; all is as it was at the end.

    Every pixel of Cycles gets consecutive parts of one sequence of samples, the same for all passes:
    what they have in common, light and shade, is as smooth as if it were one render, and what is left
    is hardly coloured.
    """
    render, cycles = scene.render, scene.cycles
    each = samples_for(samples, plan.passes)
    wanted = [
        (render, "use_persistent_data", True),
        (cycles, "use_adaptive_sampling", False),
        (cycles, "use_denoising", False),
        (cycles, "use_animated_seed", False),
        (cycles, "samples", each * plan.passes),
        (cycles, "use_sample_subset", True),
        (cycles, "sample_subset_length", each),
        (cycles, "sample_offset", 0),
    ]
    before = [(owner, name, getattr(owner, name)) for owner, name, _ in wanted]
    try:
        for owner, name, value in wanted:
            setattr(owner, name, value)
        yield
    finally:
        for owner, name, value in reversed(before):
            setattr(owner, name, value)
        attributes.take_away(scene)


def begin_pass(scene: bpy.types.Scene, plan: Plan, number: int) -> None:
    scene.cycles.sample_offset = number * scene.cycles.sample_subset_length
    attributes.put(scene, plan.properties(number))


def render(scene: bpy.types.Scene, plan: Plan, samples: int, path: Path) -> None:
    """Waits for all passes and writes the spectral picture."""
    folder = path.with_name(f"{path.name}.passes")
    folder.mkdir(exist_ok=True)
    writer = output.Writer(scene, compressed=False)
    files = [folder / f"{number:03d}.exr" for number in range(plan.passes)]
    with prepared(scene, plan, samples):
        for number, file in enumerate(files):
            begin_pass(scene, plan, number)
            bpy.ops.render.render(scene=scene.name)
            writer.save(file)
    combine(files, plan, path)
    for file in files:
        file.unlink()
    folder.rmdir()


def combine(files: list[Path], plan: Plan, path: Path) -> None:
    """From one file for each pass. Raises ExrError, or OSError that names a path."""
    bands = plan.bands
    table = spectral_image.BandTable(
        bands.observer, bands.edges_nm, bands.wavelength_nm, bands.XYZ, bands.is_line
    )
    radiance = None
    for number, file in enumerate(files):
        width, channels = exr.read_picture(file, "RGB")
        if radiance is None:
            radiance = np.empty((len(channels[0]) // width, width, len(bands)), np.float32)
        for k, values in zip(plan.indices(number), channels, strict=True):
            radiance[..., k] = np.frombuffer(values, np.float32).reshape(radiance.shape[:2])
    assert radiance is not None
    height, width = radiance.shape[:2]
    lines = exr.LINES_OF_ZIP
    rows = ((radiance[row : row + lines], None) for row in range(0, height, lines))
    spectral_image.write(path, (width, height), table, of_file(), rows)
