# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`nacre render --spectral`: the scene in bands."""

from __future__ import annotations

import argparse
import fnmatch
from dataclasses import dataclass
from pathlib import Path

import bpy

import nacre

from ..blender import denoise, output
from ..blender.float_image import as_image
from ..spectral import convert, give, needs, plan, rendering
from ..spectral.described import EMISSION, REFLECTANCE, Described, SpectrumError
from ..spectral.marks import WORLD
from ..spectral.paths import render
from . import console
from .options import UsageError


@dataclass
class Prepared:
    """A file that is spectral, the bands that it is rendered in, and what to say about it."""

    plan: plan.Plan
    notes: list[str]
    by_paths: bool = False
    taken_over: int = 0
    """Passes that a render before this one had left."""

    def report(self) -> dict:
        """`delta_e`: mean error of the library's reflectances under the light that is worst off."""
        choice = self.plan.choice
        return {
            "bands": len(self.plan.bands),
            "passes": 1 if self.by_paths else self.plan.passes,
            "passes_resumed": self.taken_over,
            **({} if choice is None else {"delta_e": round(choice.error.mean, 4)}),
        }

    def render_frame(
        self, scene: bpy.types.Scene, options: argparse.Namespace, paths: list[Path]
    ) -> None:
        """All passes, then the files. What was rendered of a picture that was stopped is kept in a folder
        beside it, from which --resume goes on."""
        smooth = options.denoise and denoise.is_possible()
        if self.by_paths:
            self._render_paths(scene, options, paths, smooth=smooth)
            return
        samples, plan = scene.cycles.samples, self.plan
        passes = rendering.beside(paths[0], scene, plan, samples, denoise=smooth)
        passes.begin(resume=options.resume)
        missing = passes.missing()
        self.taken_over += plan.passes - len(missing)
        with rendering.prepared(scene, plan, samples, denoise=smooth) as begin:
            for number in missing:
                begin(number)
                label = f"{paths[0].name} {number + 1}/{plan.passes}"
                with console.Complaints(options.quiet), console.Progress(label, options.quiet):
                    bpy.ops.render.render(scene=scene.name)
                passes.save(scene, number)
        found = rendering.rendered(passes)
        rgb = rendering.colour_of(found, scene, samples)
        for path in paths:
            if path.suffix.lower() == ".png":
                rendering.show(found, rgb, scene, path)
            else:
                rendering.write(found, rgb, scene, path)
        passes.end()

    def _render_paths(
        self,
        scene: bpy.types.Scene,
        options: argparse.Namespace,
        paths: list[Path],
        *,
        smooth: bool,
    ) -> None:
        with (
            console.Complaints(options.quiet),
            console.Progress(paths[0].name, options.quiet),
            render.prepared(scene, self.plan, denoise=smooth),
        ):
            bpy.ops.render.render(scene=scene.name)
            found = render.taken(scene, denoise=smooth)
        image = as_image(found.rgb, found.alpha, f"{paths[0].name} by paths")
        try:
            for path in paths:
                output.Writer(scene).save(path, image)
        finally:
            bpy.data.images.remove(image)


def prepare(scene: bpy.types.Scene, options: argparse.Namespace) -> Prepared:
    """Every colour of the file gets a spectrum, and bands are chosen. Raises ForeseenError."""
    report = convert.make_spectral()
    for text in options.light:
        _give_light(scene, text)
    for text in options.surface:
        _give_surface(text)
    triples = None if options.bands is None else options.bands // 3
    made = needs.plan_for(scene, triples, options.wavelengths)
    notes = [f"{remark.where}: {remark.text}" for remark in report.remarks]
    if made.choice is not None and not made.choice.met:
        notes.append(f"{len(made.bands)} bands, the most there are, {_shortfall(made.choice)}")
    if options.denoise and not denoise.is_possible():
        notes.append(denoise.NOT_POSSIBLE)
    return Prepared(made, notes, by_paths=options.mode == "paths")


def _shortfall(choice: nacre.BandChoice) -> str:
    if choice.held == "spreads":
        return f"leave steps of {choice.step_px:.1f} pixels between colours in dispersive glass"
    of_films = choice.held == "films"
    error = choice.film_error if of_films else choice.error.mean
    what = "films" if of_films else "lights"
    return f"show these {what} within ΔE00 {error:.2f} on average"


def _give_light(scene: bpy.types.Scene, text: str) -> None:
    name, _, spectrum = text.partition("=")
    lamps = {item.name: item.data for item in scene.objects if item.type == "LIGHT"}
    meant = [name] if name in lamps else fnmatch.filter(lamps, name)
    is_world = not meant and name == WORLD and scene.world is not None
    if not meant and not is_world:
        known = ", ".join([*lamps, *([WORLD] if scene.world is not None else [])]) or "none"
        raise UsageError(f"--light: no lamp {name!r} in the scene {scene.name}; there are: {known}")
    try:
        described = Described.named(spectrum, EMISSION)
        for lamp in meant:
            give.to_lamp(lamps[lamp], described)
        if is_world:
            give.to_world(scene.world, described)
    except SpectrumError as error:
        raise UsageError(f"--light: {error}") from error


def _give_surface(text: str) -> None:
    """Of `MATERIAL=SPECTRUM`, or `MATERIAL/COLOUR=SPECTRUM` where it has several; of a metal, a medium."""
    name, _, spectrum = text.rpartition("=")
    material = bpy.data.materials.get(name)
    label = ""
    if material is None:
        owner, _, label = name.rpartition("/")
        material = bpy.data.materials.get(owner)
    if material is None:
        known = ", ".join(found.name for found in bpy.data.materials) or "none"
        raise UsageError(f"--surface: no material {name!r}; there are: {known}")
    metals = [metal for metal in give.metals_of(material) if label in ("", metal.label)]
    if metals and spectrum in nacre.library.keys("media"):
        _give_metals(metals, spectrum)
        return
    colours = give.colours_of(material)
    wanted = [colour for colour in colours if label in ("", colour.label)]
    if not wanted or (len(wanted) > 1 and not label):
        labels = ", ".join(colour.label for colour in colours) or "none"
        raise UsageError(
            f"--surface: say which colour of {material.name}, {material.name}/COLOUR=…; "
            f"there are: {labels}"
        )
    try:
        wanted[0].give(Described.named(spectrum, REFLECTANCE))
    except SpectrumError as error:
        raise UsageError(f"--surface: {error}") from error


def _give_metals(metals: list[give.SurfaceMetal], key: str) -> None:
    try:
        for metal in metals:
            metal.give(key)
    except SpectrumError as error:
        raise UsageError(f"--surface: {error}") from error
