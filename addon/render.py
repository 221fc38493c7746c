# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`nacre render`: a material on a stage, or a .blend, through Cycles in background.

The one implementation behind `nacre render`, `blender --command nacre render` and `driver.py`.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

import bpy

from . import console, output
from .core.form import AUTO, NODES, OSL, FormError, choose_form
from .core.library import Library
from .core.manifest import CompiledMaterial, ManifestError, from_memory, load_folder
from .core.oso import OsoError
from .core.stack import StackError, edit, is_path, read_stack, write_template
from .core.thickness import SOURCES
from .core.values import AssignmentError, parse_assignments
from .nodes import scene as scene_setup
from .nodes import thickness
from .nodes.material import create_material, set_values
from .scenes import StageError, build_stage, stage_names

DEFAULT_VIEW = "Khronos PBR Neutral"

EXAMPLES = """\
examples:
  nacre render --material soap_film --stage bubble -o bubble.png
  nacre render --material oil_on_water --set thickness_nm=420 --stage furnace --size 128x128 -o oil.exr
  nacre render --material oil_on_water --set substrate=Au/Johnson --set range_nm=0:300 -o gilt.png
  nacre render --template beetle.toml --stage shaderball --samples 256 --denoise -o a.exr -o a.png
  nacre render --material soap_film --stage bubble --vary drainage --vary swirl --frames 1-48 -o f_##.png
  nacre render --material oil_on_water --thickness-map spill.png --range 100:800 -o spill.png
  nacre render --blend shot.blend --assign Ring=tempered_steel --frames 1-24 -o frames/####.exr
"""

_ERRORS = (
    ManifestError,
    FormError,
    AssignmentError,
    StageError,
    OsoError,
    StackError,
    output.OutputError,
)


class UsageError(Exception):
    """Options that do not fit together, or values out of range."""


class _Parser(argparse.ArgumentParser):
    """Exit status 1 for wrong usage, as for every other wrong input; argparse's own is 2."""

    def error(self, message: str) -> NoReturn:
        raise UsageError(message)


@dataclass
class Job:
    """A scene that is ready to render, and what to say about it."""

    scene: bpy.types.Scene
    forms: dict[str, str] = field(default_factory=dict)  # material id -> form
    notes: list[str] = field(default_factory=list)


def main(argv: Sequence[str]) -> int:
    """Runs `render …`. Returns the exit status: 0 ok, 1 wrong usage or input."""
    console.mute_removed_engine_noise()
    try:
        options = _parse(argv)
        outputs = [Path(path).absolute() for path in options.output]
        with console.own_stdout(options.verbose) as stdout:
            output.check(outputs)
            report = _run(options, outputs)
            if options.json:
                print(json.dumps(report, sort_keys=True), file=stdout)
            elif not options.quiet:
                print(_summary(report), file=stdout)
        return 0
    except SystemExit as done:  # --help
        return int(done.code or 0)
    except UsageError as error:
        return _fail(error)
    except _ERRORS as error:
        return _fail(error)


def _fail(error: Exception) -> int:
    for line in str(error).splitlines():
        print(f"nacre render: {line}", file=sys.stderr)
    return 1


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="nacre render",
        description="Render a material on a stage, or a .blend with materials, through Cycles.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    what = parser.add_argument_group("what to render (one of the four)")
    what.add_argument("--material", metavar="ID", help="a compiled material of the library")
    what.add_argument(
        "--compiled", metavar="DIR", type=Path, help="the folder of a compiled material"
    )
    what.add_argument(
        "--template", metavar="FILE", type=Path, help="a template, compiled on the way"
    )
    what.add_argument("--blend", metavar="FILE", type=Path, help="a .blend file")
    stage = parser.add_argument_group("a material")
    stage.add_argument(
        "--stage", metavar="NAME", help=f"one of {', '.join(stage_names())} (default shaderball)"
    )
    stage.add_argument(
        "--set",
        metavar="NAME=VALUE",
        action="append",
        default=[],
        help="a value of the material, or of its stack: layers.0.thickness_nm=420, "
        "layers.0.medium=TiO2/Sarkar, layers.0.coherent=false, ambient, substrate, range_nm=LOW:HIGH",
    )
    stage.add_argument(
        "--vary",
        metavar="SOURCE",
        action="append",
        default=[],
        choices=[item.id for item in SOURCES if item.id in ("drop", "drainage", "swirl")],
        help="let the thickness vary: drop, drainage or swirl; may be repeated, swirl last",
    )
    stage.add_argument(
        "--thickness-map", metavar="FILE", type=Path, help="a picture of the thickness, over UV"
    )
    stage.add_argument(
        "--range", metavar="LOW:HIGH", type=_range, help="thicknesses of black and white in the map"
    )
    blend = parser.add_argument_group("a .blend file")
    blend.add_argument("--assign", metavar="OBJECT=ID", action="append", default=[])
    parser.add_argument("--frames", metavar="A-B", type=_frames, help="default: the current frame")
    parser.add_argument(
        "--form", choices=(AUTO, OSL, NODES), default=AUTO, help="of the materials (default auto)"
    )
    picture = parser.add_argument_group("the picture")
    picture.add_argument("--samples", metavar="N", type=_whole(1), help="default: the stage's own")
    picture.add_argument("--size", metavar="WxH", type=_size, help="default: the stage's own")
    picture.add_argument("--seed", metavar="S", type=_whole(0), default=0, help="default 0")
    picture.add_argument("--denoise", action="store_true", help="OpenImageDenoise; default off")
    picture.add_argument(
        "--view",
        metavar="NAME",
        help=f"view transform of a PNG (default {DEFAULT_VIEW!r}, a .blend keeps its own)",
    )
    picture.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        action="append",
        required=True,
        help=".exr: float, scene-linear; .png: 8 bit, through the view transform; may be repeated",
    )
    parser.add_argument("--threads", metavar="N", type=_whole(1), help="default: all")
    parser.add_argument("--json", action="store_true", help="print a report as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")
    parser.add_argument("-v", "--verbose", action="store_true", help="with Blender's own messages")
    return parser


def _whole(least: int):
    def parse(text: str) -> int:
        if not text.isdecimal() or not least <= int(text) <= 2**31 - 1:
            raise argparse.ArgumentTypeError(f"must be a whole number ≥ {least} (got {text!r})")
        return int(text)

    return parse


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    size = tuple(map(int, match.groups())) if match else (0, 0)
    if not all(4 <= side <= 65536 for side in size):
        raise argparse.ArgumentTypeError(f"must be WxH, each 4 … 65536 pixels (got {text!r})")
    return size


def _range(text: str) -> tuple[float, float]:
    try:
        low, high = map(float, text.split(":"))
    except ValueError:
        low, high = 0.0, 0.0
    if not (math.isfinite(low) and math.isfinite(high) and 0.0 <= low < high):
        raise argparse.ArgumentTypeError(f"must be LOW:HIGH with 0 ≤ LOW < HIGH (got {text!r})")
    return low, high


def _frames(text: str) -> range:
    match = re.fullmatch(r"(\d+)(?:-(\d+))?", text)
    first = int(match.group(1)) if match else 1
    last = int(match.group(2) or first) if match else 0
    if last < first:
        raise argparse.ArgumentTypeError(f"must be A or A-B with A ≤ B (got {text!r})")
    return range(first, last + 1)


def _parse(argv: Sequence[str]) -> argparse.Namespace:
    argv = list(argv)
    if argv[:1] == ["render"]:
        argv = argv[1:]
    options = _parser().parse_args(argv)
    sources = [options.material, options.compiled, options.template, options.blend]
    if sum(source is not None for source in sources) != 1:
        raise UsageError("give one of --material, --compiled, --template, --blend")
    if options.blend is None and options.assign:
        raise UsageError("--assign needs --blend")
    varied = options.vary or options.thickness_map
    if options.blend is not None and (options.stage or options.set or varied):
        raise UsageError("--stage, --set, --vary and --thickness-map do not go with --blend")
    if options.blend is None and options.frames and "swirl" not in options.vary:
        raise UsageError("--frames needs --blend, or --vary swirl: nothing else moves")
    if options.range and not options.thickness_map:
        raise UsageError("--range needs --thickness-map")
    if options.thickness_map and set(options.vary) - {"swirl"}:
        raise UsageError("--thickness-map goes with --vary swirl alone")
    return options


def _run(options: argparse.Namespace, outputs: list[Path]) -> dict:
    started = time.monotonic()
    job = _blend_job(options) if options.blend else _stage_job(options)
    _set_picture(job.scene, options)
    for note in job.notes:
        if not options.quiet:
            print(f"nacre render: {note}", file=sys.stderr)
    written = _render(job.scene, options, outputs)
    return {
        "output": [str(path) for path in written],
        "materials": job.forms,
        "samples": job.scene.cycles.samples,
        "size": [job.scene.render.resolution_x, job.scene.render.resolution_y],
        "blender": bpy.app.version_string,
        "view_transform": job.scene.view_settings.view_transform,
        "seconds": round(time.monotonic() - started, 3),
    }


def _summary(report: dict) -> str:
    forms = ", ".join(f"{name} ({form})" for name, form in report["materials"].items())
    view = report["view_transform"]
    lines = []
    for path in report["output"]:
        how = f", {view}" if path.lower().endswith(".png") else ""
        lines.append(f"{path}: {forms or 'rendered'}{how}")
    return "\n".join([*lines, f"{report['seconds']:.1f} s, Blender {report['blender']}"])


def _compiled(options: argparse.Namespace) -> CompiledMaterial:
    """The material, with its stack edited where `--set` asks for it."""
    edits = [text for text in options.set if is_path(text.partition("=")[0])]
    if not edits:
        return _unedited(options)
    if options.template is not None:
        text, name = _read_template(options.template), str(options.template)
    else:
        found = _unedited(options)
        text, name = found.template, found.id
    stack, problems = read_stack(text), []
    for edit_ in edits:
        path, _, value = edit_.partition("=")
        try:
            stack = edit(stack, path, value)
        except StackError as error:
            problems.append(f"--set: {error}")
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
    stage = build_stage(options.stage or "shaderball")
    job = Job(stage.scene)
    material = _add_material(job, compiled, options.form)
    set_values(material, values)
    stage.place(material)
    if options.vary or options.thickness_map:
        _vary(material, compiled, options)
    elif stage.dress:
        stage.dress(material)
    stage.scene.render.resolution_x, stage.scene.render.resolution_y = stage.size
    stage.scene.cycles.samples = stage.samples
    _set_view(stage.scene, options.view or DEFAULT_VIEW, strict=options.view is not None)
    return job


def _vary(
    material: bpy.types.Material, compiled: CompiledMaterial, options: argparse.Namespace
) -> None:
    socket = thickness.thickness_socket(material)
    if socket is None:
        raise UsageError(f"{compiled.id} has no thickness that could vary")
    if options.thickness_map:
        _map_thickness(material, options)
    for source in options.vary:
        node = thickness.add_source(material, source)
        if source == "swirl" and options.frames:
            thickness.animate(node)


def _map_thickness(material: bpy.types.Material, options: argparse.Namespace) -> None:
    low, high = thickness.thickness_range(thickness.thickness_socket(material))
    wanted = options.range or (low, high)
    if not (low <= wanted[0] and wanted[1] <= high):
        raise UsageError(
            f"--range: must be within {low:g}:{high:g}, which the tables cover "
            f"(got {wanted[0]:g}:{wanted[1]:g})"
        )
    try:
        image = bpy.data.images.load(str(options.thickness_map.absolute()))
    except RuntimeError as error:
        raise UsageError(f"--thickness-map: {options.thickness_map}: {error}") from error
    if tuple(image.size) == (0, 0):
        raise UsageError(f"--thickness-map: {options.thickness_map}: is not a picture")
    node = thickness.add_source(material, "map")
    node.inputs["Minimum"].default_value, node.inputs["Maximum"].default_value = wanted
    thickness.link_image(material, image)


def _blend_job(options: argparse.Namespace) -> Job:
    if not options.blend.is_file():
        raise UsageError(f"--blend: no file {options.blend}")
    try:
        bpy.ops.wm.open_mainfile(filepath=str(options.blend.absolute()), load_ui=False)
    except RuntimeError as error:
        raise UsageError(f"--blend: {options.blend}: cannot be opened: {error}") from error
    job = Job(bpy.context.scene)
    job.scene.render.engine = "CYCLES"
    library = Library.default()
    for text in options.assign:
        name, _, material_id = text.partition("=")
        target = bpy.data.objects.get(name)
        if target is None or not hasattr(target.data, "materials"):
            known = ", ".join(o.name for o in bpy.data.objects if hasattr(o.data, "materials"))
            raise UsageError(f"--assign: no object {name!r} takes a material; there are: {known}")
        material = _add_material(job, library.load(material_id), options.form)
        target.data.materials.clear()
        target.data.materials.append(material)
    if options.view:
        _set_view(job.scene, options.view, strict=True)
    return job


def _add_material(job: Job, compiled: CompiledMaterial, requested: str) -> bpy.types.Material:
    form = choose_form(compiled, requested, scene_setup.renderer(job.scene))
    material = create_material(compiled, form)
    if form == OSL:
        scene_setup.use_osl(job.scene)
        if compiled.wavelength_per_path and scene_setup.use_wavelengths(job.scene):
            job.notes.append(f"{compiled.id}: motion blur is on, it carries the wavelengths")
    elif compiled.negative_gamut:
        job.notes.append(f"{compiled.id}: as nodes, colours outside the gamut are clipped")
    job.forms[compiled.id] = form
    return material


def _set_view(scene: bpy.types.Scene, name: str, *, strict: bool) -> None:
    try:
        scene.view_settings.view_transform = name
    except TypeError as error:
        if strict:
            raise UsageError(f"--view: {error}") from error
        scene.view_settings.view_transform = "Standard"


def _set_picture(scene: bpy.types.Scene, options: argparse.Namespace) -> None:
    render, cycles = scene.render, scene.cycles
    if options.size:
        render.resolution_x, render.resolution_y = options.size
    if options.samples:
        cycles.samples = options.samples
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


def _render(scene: bpy.types.Scene, options: argparse.Namespace, outputs: list[Path]) -> list[Path]:
    writer = output.Writer(scene)
    frames = options.frames or [None]
    written = []
    with console.stop_on_signals(writer.discard):
        for frame in frames:
            paths = outputs
            if frame is not None:
                scene.frame_set(frame)
                paths = [output.frame_path(path, frame) for path in outputs]
            label = paths[0].name
            with console.Progress(label, options.quiet):
                bpy.ops.render.render()
            for path in paths:
                writer.save(path)
                written.append(path)
    return written
