# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a scene band by band, and puts the passes together to one spectral picture."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

from ..blender import output
from ..blender.denoise import denoised
from ..blender.float_image import as_image
from ..blender.space import of_file
from ..core import exr, spectral_image
from ..core.whole_file import write_whole
from . import attributes, films, light_groups
from .described import DAYLIGHT
from .engines import engine_of, having, layer_of, settings_of
from .plan import Plan, in_bands


@contextlib.contextmanager
def prepared(
    scene: bpy.types.Scene, plan: Plan, samples: int, *, denoise: bool = False
) -> Iterator[Callable[[int], None]]:
    """Yields what makes the scene render the pass of a number; all is as it was at the end. Raises
    ForeseenError."""
    engine = engine_of(scene)
    settings = [
        (scene.render, "use_persistent_data", True),
        *settings_of(scene, denoise=denoise),
        *engine.settings(plan, samples),
    ]
    with having(settings), films.in_bands(plan, at_once=engine.has_all_tables) as show_tables:

        def begin(number: int) -> None:
            engine.begin(plan, number)
            show_tables(number)
            attributes.put(scene, plan.properties(number, engine.live))

        try:
            yield begin
        finally:
            attributes.take_away(scene)


@dataclass(frozen=True)
class Passes:
    """Files of the passes of one picture, which outlive a render that was killed.

    `told` is all that makes the picture what it is: files of another one are not taken for it.
    """

    folder: Path
    plan: Plan
    told: str
    groups: tuple[str, ...] = ()

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

    def save(self, scene: bpy.types.Scene, number: int) -> None:
        """What was just rendered."""
        output.Writer(scene, layers=True, compressed=False).save(self.files[number])

    def missing(self) -> list[int]:
        return [number for number, file in enumerate(self.files) if not file.is_file()]

    def end(self) -> None:
        for left in self.folder.iterdir():
            left.unlink()
        self.folder.rmdir()


def beside(
    path: Path, scene: bpy.types.Scene, plan: Plan, samples: int, *, denoise: bool = False
) -> Passes:
    """In a folder beside the picture."""
    render = scene.render
    groups = light_groups.names_of(scene, layer_of(scene))
    told = {
        "bands": table_of(plan).text(),
        "values": {
            name: [float(value) for value in of_all] for name, of_all in plan.values.items()
        },
        "first_pass": plan.indices(0),
        "films": films.digest(),
        "disperses": plan.disperses,
        "groups": groups,
        "engine": render.engine,
        "samples": samples,
        "denoise": denoise,
        "seed": scene.cycles.seed,
        "size": [render.resolution_x, render.resolution_y, render.resolution_percentage],
        "frame": scene.frame_current,
        "file": bpy.data.filepath,
    }
    folder = path.with_name(f"{path.name}.passes")
    return Passes(folder, plan, json.dumps(told, sort_keys=True), tuple(groups))


@dataclass(frozen=True)
class Rendered:
    """All passes together, row 0 on top. radiance: float32 (height, width, N) per nm; groups: the same of
    each light group; alpha: (height, width); albedo and normal, (height, width, 3): what denoising goes by,
    where that was wanted."""

    plan: Plan
    radiance: np.ndarray
    groups: dict[str, np.ndarray]
    alpha: np.ndarray
    albedo: np.ndarray | None
    normal: np.ndarray | None

    @property
    def rgb(self) -> np.ndarray:
        """To the eye, in the file's space."""
        return spectral_image.colour(self.radiance, table_of(self.plan), of_file())


def rendered(passes: Passes) -> Rendered:
    """From all files. Raises ExrError."""
    plan, files = passes.plan, passes.files
    width, height = exr.size_of(files[0])
    radiance = np.zeros((height, width, len(plan.bands)), np.float32)
    groups = {name: np.zeros_like(radiance) for name in passes.groups}
    albedos = np.zeros_like(radiance)
    alpha = np.zeros((height, width), np.float32)
    normal = np.zeros((height, width, 3), np.float32)
    guided = True
    for number, file in enumerate(files):
        channels = exr.read_channels(file)

        def of(*names: str, channels: dict = channels) -> np.ndarray:
            values = [np.frombuffer(channels[name], np.float32) for name in names]
            return np.stack(values, axis=-1).reshape(height, width, len(names))

        indices = list(plan.indices(number))
        divisor = plan.turns * plan.white[indices].astype(np.float32)
        radiance[..., indices] += of(*(f"Combined.{channel}" for channel in "RGB")) / divisor
        for name, of_group in groups.items():
            shown = (f"{light_groups.pass_of(name)}.{channel}" for channel in "RGB")
            of_group[..., indices] += of(*shown) / divisor
        alpha += of("Combined.A")[..., 0] / len(files)
        guided = guided and "Denoising Albedo.R" in channels
        if guided:
            albedo = (f"Denoising Albedo.{channel}" for channel in "RGB")
            albedos[..., indices] += of(*albedo) / plan.turns
            normal += of(*(f"Denoising Normal.{axis}" for axis in "XYZ")) / len(files)
    if not guided:
        return Rendered(plan, radiance, groups, alpha, None, None)
    daylight = in_bands(plan.bands, DAYLIGHT).astype(np.float32)
    under_daylight = spectral_image.colour(albedos * daylight, table_of(plan), of_file())
    return Rendered(plan, radiance, groups, alpha, under_daylight, normal)


def table_of(plan: Plan) -> spectral_image.BandTable:
    bands = plan.bands
    return spectral_image.BandTable(
        bands.observer, bands.edges_nm, bands.wavelength_nm, bands.XYZ, bands.is_line
    )


def colour_of(found: Rendered, scene: bpy.types.Scene, samples: int) -> np.ndarray:
    """To the eye, without noise where denoising was wanted. The bands together, not each: what is left
    of the noise is hardly coloured."""
    if found.albedo is None or found.normal is None:
        return found.rgb
    return denoised(
        scene, layer_of(scene), samples, found.rgb, found.alpha, found.albedo, found.normal
    )


def write(found: Rendered, rgb: np.ndarray, scene: bpy.types.Scene, path: Path) -> None:
    """The spectral picture. Raises OSError that names the path."""
    alpha = found.alpha if scene.render.film_transparent else None
    table = table_of(found.plan)
    lights = light_groups.lights_of(scene, list(found.groups), found.plan)
    spectral_image.write(
        path,
        table,
        of_file(),
        found.radiance,
        rgb=rgb,
        alpha=alpha,
        groups=found.groups,
        lights=lights,
    )


def show(found: Rendered, rgb: np.ndarray, scene: bpy.types.Scene, path: Path) -> None:
    """As the scene's view transform shows it, a PNG."""
    image = as_image(rgb, found.alpha, f"{path.name} of bands")
    try:
        output.Writer(scene).save(path, image)
    finally:
        bpy.data.images.remove(image)
