# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a scene band by band, and puts the passes together to one spectral picture."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

from ..blender import output
from ..blender.space import of_file
from ..core import exr, spectral_image
from ..core.whole_file import write_whole
from . import attributes
from .plan import Plan


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


@dataclass(frozen=True)
class Passes:
    """Files of the passes of one picture, which outlive a render that was killed.

    `told` is all that makes the picture what it is: files of another one are not taken for it.
    """

    folder: Path
    plan: Plan
    told: str

    @property
    def files(self) -> list[Path]:
        return [self.folder / f"{number:03d}.exr" for number in range(self.plan.passes)]

    @property
    def _note(self) -> Path:
        return self.folder / "passes.json"

    def begin(self, *, resume: bool) -> None:
        """The folder with what can be gone on from, if that is wanted, else empty."""
        self.folder.mkdir(exist_ok=True)
        with contextlib.suppress(OSError, UnicodeDecodeError):
            if resume and self._note.read_text("utf-8") == self.told:
                return
        for left in self.folder.iterdir():
            left.unlink()
        write_whole(self._note, self.told)

    def missing(self) -> list[int]:
        return [number for number, file in enumerate(self.files) if not file.is_file()]

    def end(self) -> None:
        for left in self.folder.iterdir():
            left.unlink()
        self.folder.rmdir()


def beside(path: Path, scene: bpy.types.Scene, plan: Plan, samples: int) -> Passes:
    """In a folder beside the picture."""
    render = scene.render
    told = {
        "bands": table_of(plan).text(),
        "values": {
            name: [float(value) for value in of_all] for name, of_all in plan.values.items()
        },
        "samples": samples,
        "seed": scene.cycles.seed,
        "size": [render.resolution_x, render.resolution_y, render.resolution_percentage],
        "frame": scene.frame_current,
        "file": bpy.data.filepath,
    }
    return Passes(path.with_name(f"{path.name}.passes"), plan, json.dumps(told, sort_keys=True))


def radiance_of(passes: Passes) -> np.ndarray:
    """float32 (height, width, N) per nm, from all files. Raises ExrError."""
    plan, radiance = passes.plan, None
    for number, file in enumerate(passes.files):
        width, channels = exr.read_picture(file, "RGB")
        if radiance is None:
            radiance = np.empty((len(channels[0]) // width, width, len(plan.bands)), np.float32)
        for k, values in zip(plan.indices(number), channels, strict=True):
            radiance[..., k] = np.frombuffer(values, np.float32).reshape(radiance.shape[:2])
    assert radiance is not None
    return radiance


def table_of(plan: Plan) -> spectral_image.BandTable:
    bands = plan.bands
    return spectral_image.BandTable(
        bands.observer, bands.edges_nm, bands.wavelength_nm, bands.XYZ, bands.is_line
    )


def write(radiance: np.ndarray, plan: Plan, path: Path) -> None:
    """The spectral picture. Raises OSError that names the path."""
    height, width = radiance.shape[:2]
    lines = exr.LINES_OF_ZIP
    rows = ((radiance[row : row + lines], None) for row in range(0, height, lines))
    spectral_image.write(path, (width, height), table_of(plan), of_file(), rows)


def as_image(radiance: np.ndarray, plan: Plan, name: str) -> bpy.types.Image:
    """A picture of the file in its linear space; one of that name is filled anew."""
    height, width = radiance.shape[:2]
    pixels = np.ones((height, width, 4), np.float32)
    pixels[..., :3] = spectral_image.colour(radiance, table_of(plan), of_file())
    image = bpy.data.images.get(name)
    if image is None or tuple(image.size) != (width, height):
        if image is not None:
            bpy.data.images.remove(image)
        image = bpy.data.images.new(name, width, height, float_buffer=True, is_data=False)
    image.pixels.foreach_set(pixels[::-1].ravel())
    image.update()
    return image


def show(radiance: np.ndarray, plan: Plan, scene: bpy.types.Scene, path: Path) -> None:
    """As the scene's view transform shows it, a PNG."""
    image = as_image(radiance, plan, f"{path.name} of bands")
    try:
        output.save_view(image, scene, path)
    finally:
        bpy.data.images.remove(image)
