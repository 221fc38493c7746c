# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`nacre render`: a material on a stage, or a .blend, through Cycles in background.

The one implementation behind `nacre render`, `blender --command nacre render` and `driver.py`.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import traceback
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import bpy

from ..blender import output
from ..core.computation import library_problem
from ..core.faults import ForeseenError
from ..core.form import OSL, choose_form
from ..core.library import Library
from ..core.manifest import CompiledMaterial, from_memory, load_folder
from ..core.presets import named
from ..core.values import parse_assignments
from ..films.stack import StackError, edit, is_path, read_stack, write_template
from ..gems import cut_stone
from ..materials import follow
from ..materials import scene as scene_setup
from ..materials.image import mend_spaces
from ..materials.material import create_material, input_socket, set_values
from ..viewer import passes
from ..viewer.pixel import in_picture
from ..viewer.probe import Probe
from . import batch, console, gallery, user_scene
from . import thickness as render_thickness
from .options import DEFAULT_VIEW, UsageError, parse
from .scenes import build_stage


@dataclass
class Job:
    """A scene that is ready to render, and what to say about it."""

    scene: bpy.types.Scene
    forms: dict[str, str] = field(default_factory=dict)  # material id -> form
    notes: list[str] = field(default_factory=list)


def main(argv: Sequence[str]) -> int:
    """Runs `render …`. Returns the exit status: 0 ok, 1 wrong usage or input."""
    console.mute_removed_engine_noise()
    cut_stone.register()
    try:
        options = parse(argv)
        if options.batch or options.gallery:
            return _many(list(argv), options)
        outputs = [Path(path).absolute() for path in options.output]
        with console.own_stdout(options.verbose) as stdout:
            output.check(outputs)
            report = _run(options, outputs)
            if options.json:
                print(json.dumps(report, sort_keys=True, default=Probe.data), file=stdout)
            elif not options.quiet or not outputs:
                print(_summary(report), file=stdout)
        return _fail("\n".join(_unknown(report))) if _unknown(report) else 0
    except SystemExit as done:  # --help
        return int(done.code or 0)
    except Exception as error:
        return _fail(_problem(error, verbose=not {"-v", "--verbose"}.isdisjoint(argv)))


def _unknown(report: dict) -> list[str]:
    """Of pixels that were asked for: films whose spectrum cannot be computed, and why."""
    return [
        f"--pixel {probe.pixel[0]} {probe.pixel[1]}: {probe.problem}"
        for probe in report.get("probes", ())
        if probe.problem
    ]


def _many(argv: list[str], options: argparse.Namespace) -> int:
    """A batch or the gallery. Exit status 1 where a picture failed."""
    folder = Path(options.output[0]).absolute()
    given = batch.common_arguments(argv)
    with console.own_stdout(options.verbose) as stdout:
        rows = (
            gallery.rows(folder, given)
            if options.gallery
            else batch.read_rows(options.batch, folder, given)
        )
        report = batch.render(rows, folder, _render_row, options.quiet)
        if options.gallery:
            report["page"] = str(gallery.write_page(folder, rows))
        if options.json:
            print(json.dumps(report, sort_keys=True), file=stdout)
        elif not options.quiet:
            print(batch.summary(report), file=stdout)
    if options.gallery and library_problem():
        return _fail(f"no swatches: {library_problem()}")
    return 1 if report["failed"] else 0


def _render_row(options: argparse.Namespace, path: Path) -> str:
    """Renders one picture of many; the problem, or nothing."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        output.check([path])
        _run(options, [path])
    except Exception as error:
        return _problem(error, options.verbose)
    return ""


def _problem(error: Exception, verbose: bool) -> str:
    """What to say of an error. One that nobody thought of, mostly Blender's own, is one line too."""
    if isinstance(error, ForeseenError):
        return str(error)
    if verbose:
        traceback.print_exc()
    said = " ".join(f"{type(error).__name__}: {error}".split())
    return f"Blender {bpy.app.version_string} gave up: {said}; -v tells where"


def _fail(problem: str) -> int:
    for line in problem.splitlines():
        print(f"nacre render: {line}", file=sys.stderr)
    return 1


def _run(options: argparse.Namespace, outputs: list[Path]) -> dict:
    started = time.monotonic()
    if options.pixel and library_problem():
        raise UsageError(f"--pixel: {library_problem()}")
    job = _blend_job(options) if options.blend else _stage_job(options)
    _set_picture(job.scene, options)
    bands = _in_bands(job.scene, options)
    if bands is not None:
        job.notes += bands.notes
    for note in job.notes:
        if not options.quiet:
            print(f"nacre render: {note}", file=sys.stderr)
    found = _probe(job.scene, options)
    written = _render(job.scene, options, outputs, bands) if outputs else []
    return {
        **({} if bands is None else bands.report()),
        **({"probes": found} if found else {}),
        "output": [str(path) for path in written],
        "materials": job.forms,
        "samples": job.scene.cycles.samples,
        "size": [job.scene.render.resolution_x, job.scene.render.resolution_y],
        "blender": bpy.app.version_string,
        "view_transform": job.scene.view_settings.view_transform,
        "seconds": round(time.monotonic() - started, 3),
    }


def _in_bands(scene: bpy.types.Scene, options: argparse.Namespace) -> Any:
    """A spectral.Prepared, or None. Only here is the library of optics needed by those who render."""
    if not options.spectral:
        return None
    if library_problem():
        raise UsageError(f"--spectral: {library_problem()}")
    from . import spectral

    return spectral.prepare(scene, options)


def _probe(scene: bpy.types.Scene, options: argparse.Namespace) -> list[Probe]:
    if not options.pixel:
        return []
    if options.frames:
        scene.frame_set(options.frames[0])
    layer = user_scene.rendered_layers(scene)[0]
    return [in_picture(scene, layer, tuple(pixel)) for pixel in options.pixel]


def _summary(report: dict) -> str:
    found = [probe.text() for probe in report.get("probes", ())]
    if not report["output"]:
        return "\n\n".join(found)
    forms = ", ".join(f"{name} ({form})" for name, form in report["materials"].items())
    view = report["view_transform"]
    lines = []
    for path in report["output"]:
        how = f", {view}" if path.lower().endswith(".png") else ""
        lines.append(f"{path}: {forms or 'rendered'}{how}")
    return "\n".join([*found, *lines, f"{report['seconds']:.1f} s, Blender {report['blender']}"])


def _compiled(options: argparse.Namespace) -> CompiledMaterial:
    """The material, with its stack edited where `--set` or `--technique` asks for it."""
    edits = [("--set", text) for text in options.set if is_path(text.partition("=")[0])]
    if options.technique:
        edits.append(("--technique", f"technique={options.technique}"))
    if not edits:
        return _unedited(options)
    if options.template is not None:
        text, name = _read_template(options.template), str(options.template)
    else:
        found = _unedited(options)
        text, name = found.template, found.id
    stack, problems = read_stack(text), []
    for option, assignment in edits:
        path, _, value = assignment.partition("=")
        try:
            stack = edit(stack, path, value)
        except StackError as error:
            problems.append(f"{option}: {error}")
    if problems:
        raise UsageError("\n".join(problems))
    return _compile_text(write_template(stack), name)


def _unedited(options: argparse.Namespace) -> CompiledMaterial:
    if options.material is not None:
        return Library.default().load(options.material)
    if options.compiled is not None:
        return load_folder(options.compiled)
    return _compile_text(_read_template(options.template), str(options.template))


def _read_template(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"--template: {path}: cannot be read: {error}") from error


def _compile_text(text: str, name: str) -> CompiledMaterial:
    try:
        import nacre
    except ImportError as error:
        raise UsageError(f"needs the Python package nacre here: {error}") from error
    try:
        made = nacre.compile_template(text, name)
    except nacre.NacreError as error:
        raise UsageError(str(error)) from error
    return from_memory(made.manifest, made.osl, made.tables)


def _stage_job(options: argparse.Namespace) -> Job:
    compiled = _compiled(options)
    values = parse_assignments(
        compiled, [text for text in options.set if not is_path(text.partition("=")[0])]
    )
    preset = dict(named(compiled.presets, options.preset).values) if options.preset else {}
    stage_name = options.stage or ("portrait" if options.look else compiled.traits.stage)
    stage = build_stage(stage_name, compiled.look.object)
    job = Job(stage.scene)
    material = _add_material(job, compiled, options.form)
    set_values(material, preset | values)
    stage.place(material)
    if options.vary or options.thickness_map:
        render_thickness.vary(material, compiled, options)
    elif options.look:
        render_thickness.dress(material, compiled, options)
    elif stage.dress and not options.animate:
        stage.dress(material)
    _animate(material, compiled, options)
    stage.scene.render.resolution_x, stage.scene.render.resolution_y = stage.size
    stage.scene.cycles.samples = stage.samples
    if options.view:
        _set_view(stage.scene, options.view)
    else:
        _default_view(job, options)
    return job


def _animate(
    material: bpy.types.Material, compiled: CompiledMaterial, options: argparse.Namespace
) -> None:
    """Keyframes at both ends of the frames, straight in between."""
    ends = []
    for text in options.animate:
        name, _, span = text.partition("=")
        pair = span.split(":")
        if len(pair) != 2:
            raise UsageError(f"--animate: must be NAME=FROM:TO (got {text!r})")
        ends.append([parse_assignments(compiled, [f"{name}={value}"]) for value in pair])
    bpy.context.preferences.edit.keyframe_new_interpolation_type = "LINEAR"
    for pair in ends:
        for values, frame in zip(pair, (options.frames[0], options.frames[-1]), strict=True):
            set_values(material, values)
            for name in values:
                input_socket(material, name).keyframe_insert("default_value", frame=frame)


def _blend_job(options: argparse.Namespace) -> Job:
    if not options.blend.is_file():
        raise UsageError(f"--blend: no file {options.blend}")
    try:
        bpy.ops.wm.open_mainfile(filepath=str(options.blend.absolute()), load_ui=False)
    except RuntimeError as error:
        raise UsageError(f"--blend: {options.blend}: cannot be opened: {error}") from error
    mend_spaces()
    follow.put_right()
    job = Job(_chosen_scene(options))
    refused = user_scene.refusals(job.scene, assigned=bool(options.assign))
    if refused:
        where = f"--blend: {options.blend}: the scene {job.scene.name}"
        raise UsageError("\n".join(f"{where} {text}" for text in refused))
    job.notes += [f"{options.blend}: {note}" for note in [user_scene.age_note()] if note]
    job.notes += user_scene.show_alone(job.scene)
    job.scene.render.engine = "CYCLES"
    _assign(job, options)
    lacking = user_scene.without_tables(job.scene)
    if lacking:
        raise UsageError("\n".join(f"--blend: {options.blend}: {text}" for text in lacking))
    job.notes += user_scene.serve_wave_materials(job.scene)
    if options.view:
        _set_view(job.scene, options.view)
    return job


def _chosen_scene(options: argparse.Namespace) -> bpy.types.Scene:
    if not options.scene:
        return bpy.context.scene
    scene = bpy.data.scenes.get(options.scene)
    if scene is None:
        known = ", ".join(scene.name for scene in bpy.data.scenes)
        raise UsageError(f"--scene: no scene {options.scene!r}; there are: {known}")
    return scene


def _assign(job: Job, options: argparse.Namespace) -> None:
    library = Library.default()
    for text in options.assign:
        name, _, material_id = text.partition("=")
        there = user_scene.surfaces(job.scene)
        if name not in there:
            known = ", ".join(there) or "none"
            raise UsageError(
                f"--assign: no object {name!r} takes a material in the scene {job.scene.name}; "
                f"there are: {known}{_elsewhere(name)}"
            )
        if there[name].hide_render:
            job.notes.append(f"{name}: is not seen: it is hidden in renders")
        material = _add_material(job, library.load(material_id), options.form)
        problem = user_scene.put_on(there[name], material)
        if problem:
            raise UsageError(f"--assign: {name}: {problem}")


def _elsewhere(name: str) -> str:
    scenes = [scene.name for scene in bpy.data.scenes if name in user_scene.surfaces(scene)]
    return f"; {name!r} is in: {', '.join(scenes)} (--scene)" if scenes else ""


def _add_material(job: Job, compiled: CompiledMaterial, requested: str) -> bpy.types.Material:
    form = choose_form(compiled, requested, scene_setup.renderer(job.scene))
    material = create_material(compiled, form)
    if form == OSL:
        scene_setup.use_osl(job.scene)
        if compiled.wavelength_per_path and scene_setup.use_wavelengths(job.scene):
            job.notes.append(f"{compiled.id}: motion blur is on, it carries the wavelengths")
    elif compiled.negative_gamut:
        job.notes.append(f"{compiled.id}: as nodes, colours outside the gamut are clipped")
    job.notes += [f"{compiled.id}: {note}" for note in compiled.notes]
    job.forms[compiled.id] = form
    return material


def _set_view(scene: bpy.types.Scene, name: str) -> None:
    try:
        scene.view_settings.view_transform = name
    except TypeError as error:  # it names those that the colour config has
        known = str(error).partition("not found in (")[2].rstrip(")")
        raise UsageError(f"--view: no view {name!r}; there are: {known}") from error


def _default_view(job: Job, options: argparse.Namespace) -> None:
    """Where the colour config has another: its own default, which Blender has put in place."""
    try:
        _set_view(job.scene, DEFAULT_VIEW)
    except UsageError:
        if any(path.lower().endswith(".png") for path in options.output):
            view = job.scene.view_settings.view_transform
            job.notes.append(f"the colour config has no view {DEFAULT_VIEW!r}; seen by {view!r}")


def _set_picture(scene: bpy.types.Scene, options: argparse.Namespace) -> None:
    render, cycles = scene.render, scene.cycles
    if options.size:
        render.resolution_x, render.resolution_y = options.size
    if options.samples:
        user_scene.use_samples(scene, options.samples)
    if options.threads:
        render.threads_mode = "FIXED"
        render.threads = options.threads
    render.resolution_percentage = 100
    render.use_file_extension = False
    cycles.use_animated_seed = False
    cycles.seed = options.seed
    cycles.use_adaptive_sampling = False
    cycles.time_limit = 0.0
    cycles.use_denoising = options.denoise
    # Nothing in the file that differs from run to run.
    for name in dir(render):
        if name.startswith("use_stamp_"):
            setattr(render, name, False)


def _render(
    scene: bpy.types.Scene,
    options: argparse.Namespace,
    outputs: list[Path],
    bands: Any,
) -> list[Path]:
    writer = output.Writer(scene)
    frames = options.frames or [None]
    written = []
    with console.stop_on_signals(writer.discard):
        for frame in frames:
            paths = outputs
            if frame is not None:
                scene.frame_set(frame)
                paths = [output.frame_path(path, frame) for path in outputs]
            if options.resume and all(path.is_file() for path in paths):
                continue
            if bands is not None:
                bands.render_frame(scene, options, paths)
                written += paths
                continue
            label = paths[0].name
            with (
                console.Complaints(options.quiet) as complaints,
                console.Progress(label, options.quiet),
            ):
                bpy.ops.render.render(scene=scene.name)
            if complaints.of_shaders:
                raise output.OutputError(_unloaded(complaints.of_shaders))
            for path in paths:
                writer.save(path)
                written.append(path)
            if options.aov:
                written.append(_render_passes(scene, options, paths[0]))
    return written


def _unloaded(complaints: list[str]) -> str:
    """Of shaders that are embedded Cycles tells but a digest."""
    said = "; ".join(complaints)
    trees = [*bpy.data.node_groups, *(m.node_tree for m in bpy.data.materials if m.node_tree)]
    scripts = [(tree, node) for tree in trees for node in tree.nodes if node.type == "SCRIPT"]
    names = {
        tree.name if tree in bpy.data.node_groups[:] else tree.id_data.name
        for tree, node in scripts
        if node.bytecode_hash and node.bytecode_hash in said
    }
    whose = f" of {', '.join(sorted(names))}" if names else ""
    return f"Cycles could not load the shader{whose}, so that nothing is written: {said}"


def _render_passes(scene: bpy.types.Scene, options: argparse.Namespace, beside: Path) -> Path:
    path = beside.with_name(f"{beside.stem}_passes.exr")
    with passes.rendered(scene, user_scene.rendered_layers(scene)[0], options.aov) as aside:
        output.Writer(aside, layers=True).save(path)
    return path
