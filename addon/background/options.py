# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of `render`."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

from ..core import wavelengths
from ..core.faults import ForeseenError
from ..core.form import AUTO, NODES, OSL
from ..films.stack import MULTILAYER, TECHNIQUES
from ..thickness.sources import SOURCES, ThicknessError, Varied, read_varied
from ..viewer.fields import FIELDS
from .scenes import STAGES

DEFAULT_VIEW = "Khronos PBR Neutral"
MOST_BANDS = wavelengths.MOST

EPILOG = """\
Cycles is looked for in this order: NACRE_PYTHON (a Python with bpy), NACRE_BLENDER (a Blender program),
.venv of the checkout or the prefix, python3, blender on the path.

examples:
  nacre render --material soap_film --stage bubble -o bubble.png
  nacre render --material oil_on_water --set thickness_nm=420 --stage furnace --size 128x128 -o oil.exr
  nacre render --material oil_on_water --set substrate=Au/Johnson --set range_nm=0:300 -o gilt.png
  nacre render --material soap_film --technique airy --stage bubble -o airy.png
  nacre render --template beetle.toml --stage shaderball --samples 256 --denoise -o a.exr -o a.png
  nacre render --material soap_film --stage bubble --vary drainage --vary swirl --frames 1-48 -o f_##.png
  nacre render --material oil_on_water --vary drop:base_nm=100,height_nm=600,radius=0.4 -o drop.png
  nacre render --material soap_film --stage sphere --animate thickness_nm=900:50 --frames 1-48 -o thin_##.png
  nacre render --material oil_on_water --thickness-map spill.png --range 100:800 -o spill.png
  nacre render --batch looks.csv --stage shaderball --samples 64 -o looks/
  nacre render --material soap_film --stage sphere --spectral --wavelengths 400:700:10 -o cube.exr
  nacre render --material soap_film --stage sphere --pixel 320 240 --json
  nacre render --material soap_film --stage sphere --aov thickness --aov cos_theta -o bubble.exr
  nacre render --gallery --size 256x256 --samples 64 -o gallery/
  nacre render --blend shot.blend --spectral --light World=F11 -o office.exr -o office.png
  nacre render --blend shot.blend --assign Ring=tempered_steel --frames 1-24 -o shot_####.exr
"""


class UsageError(ForeseenError):
    """Options that do not fit together, or values out of range."""


class _Parser(argparse.ArgumentParser):
    """Exit status 1 for wrong usage, as for every other wrong input; argparse's own is 2."""

    def error(self, message: str) -> NoReturn:
        raise UsageError(message)


def parser() -> argparse.ArgumentParser:
    made = _Parser(
        prog="nacre render",
        description="Render a material on a stage, or a .blend with materials, through Cycles.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    what = made.add_argument_group("what to render (one of these)")
    what.add_argument("--material", metavar="ID", help="a compiled material of the library")
    what.add_argument(
        "--compiled", metavar="DIR", type=Path, help="the folder of a compiled material"
    )
    what.add_argument(
        "--template", metavar="FILE", type=Path, help="a template, compiled on the way"
    )
    what.add_argument("--blend", metavar="FILE", type=Path, help="a .blend file")
    what.add_argument(
        "--batch",
        metavar="CSV",
        type=Path,
        help="a picture for each row: a column `output`, others named as options or as values to set",
    )
    what.add_argument(
        "--gallery",
        action="store_true",
        help="every material of the library, and a page about them",
    )
    stage = made.add_argument_group("a material")
    stage.add_argument(
        "--stage", metavar="NAME", help=f"one of {', '.join(STAGES)} (default shaderball)"
    )
    stage.add_argument(
        "--look",
        action="store_true",
        help="as the library pictures it: on its own object unless --stage says where, its thickness "
        "varied; the stage portrait alone keeps the thickness even",
    )
    stage.add_argument(
        "--set",
        metavar="NAME=VALUE",
        action="append",
        default=[],
        help="a value of the material, or of its stack: layers.0.thickness_nm=420, "
        "layers.0.medium=TiO2/Sarkar, layers.0.coherent=false, ambient, substrate, range_nm=LOW:HIGH",
    )
    stage.add_argument("--preset", metavar="NAME", help="of the material, before what --set says")
    stage.add_argument(
        "--technique",
        choices=TECHNIQUES,
        metavar="NAME",
        help="what a film's reflectance is computed by, for comparison: "
        f"{', '.join(TECHNIQUES)} (default: the template's, mostly {MULTILAYER})",
    )
    stage.add_argument(
        "--animate",
        metavar="NAME=FROM:TO",
        action="append",
        default=[],
        help="a value that runs evenly over --frames, such as thickness_nm=100:800",
    )
    stage.add_argument(
        "--vary",
        metavar="SOURCE[:NAME=VALUE,…]",
        action="append",
        default=[],
        type=_varied,
        help=f"let the thickness vary: {_sources()}; may be repeated: each lies upon "
        "those before it. Thicknesses are in nm, or with _scale in place of _nm, of a material with "
        "thickness_scale, factors; centre is X:Y in texture coordinates, in which the radius is too",
    )
    stage.add_argument(
        "--thickness-map", metavar="FILE", type=Path, help="a picture of the thickness, over UV"
    )
    stage.add_argument(
        "--range", metavar="LOW:HIGH", type=_range, help="thicknesses of black and white in the map"
    )
    blend = made.add_argument_group("a .blend file")
    blend.add_argument(
        "--assign",
        metavar="OBJECT=ID",
        action="append",
        default=[],
        help="gives an object a material of the library; may be repeated",
    )
    blend.add_argument(
        "--scene", metavar="NAME", help="default: the one that the file was saved with"
    )
    made.add_argument(
        "--frames",
        metavar="A-B",
        type=_frames,
        help="of what moves; #### in the output's name is the frame; default: the current one",
    )
    made.add_argument(
        "--resume", action="store_true", help="leave out frames whose files are there already"
    )
    made.add_argument(
        "--form", choices=(AUTO, OSL, NODES), default=AUTO, help="of the materials (default auto)"
    )
    picture = made.add_argument_group("the picture")
    picture.add_argument("--samples", metavar="N", type=_whole(1), help="default: the stage's own")
    picture.add_argument("--size", metavar="WxH", type=_size, help="default: the stage's own")
    picture.add_argument("--seed", metavar="S", type=_whole(0), default=0, help="default 0")
    picture.add_argument("--denoise", action="store_true", help="OpenImageDenoise; default off")
    picture.add_argument(
        "--spectral",
        action="store_true",
        help="with a spectrum for every colour: an .exr has a channel for each wavelength besides RGB",
    )
    picture.add_argument(
        "--mode",
        choices=["bands", "paths"],
        default=None,
        help="of --spectral: passes of three bands each (default), or one render in which each path draws three "
        "wavelengths, with more noise and without a channel for each",
    )
    picture.add_argument(
        "--bands",
        metavar="N",
        type=_bands,
        default=None,
        help="wavelengths of --spectral, three a pass: a multiple of 3, or auto, as many as the scene's "
        "lights need (default)",
    )
    picture.add_argument(
        "--wavelengths",
        metavar="FIRST:LAST:STEP",
        type=_wavelengths,
        help="of --spectral, instead of --bands: a band around each, in nm, as sensors have them (400:700:10), "
        "and others that cover the rest",
    )
    picture.add_argument(
        "--light",
        metavar="LAMP=SPECTRUM",
        action="append",
        default=[],
        help="with --spectral: what a lamp of the scene, or World, is: D65, F11, lamp/hps, blackbody:2700, "
        "line:589.3, led.csv …, as bright as it was; Street* is all whose names begin so; may be repeated",
    )
    picture.add_argument(
        "--surface",
        metavar="MATERIAL=SPECTRUM",
        action="append",
        default=[],
        help="with --spectral: the reflectance of a material's colour, of the library or from a file: "
        "colorchecker/red, paints.csv#ochre; MATERIAL/COLOUR where it has several; or the metal of a "
        "Metallic BSDF, Au/Johnson; may be repeated",
    )
    picture.add_argument(
        "--view",
        metavar="NAME",
        help=f"view transform of a PNG (default {DEFAULT_VIEW!r}, a .blend keeps its own)",
    )
    picture.add_argument(
        "--aov",
        metavar="NAME",
        action="append",
        default=[],
        choices=[item.id for item in FIELDS],
        help=f"a pass of the wave materials in a file with layers beside the first output, "
        f"…_passes.exr: {', '.join(item.id for item in FIELDS)}; may be repeated",
    )
    picture.add_argument(
        "--pixel",
        metavar=("X", "Y"),
        nargs=2,
        type=_whole(0),
        action="append",
        default=[],
        help="print thickness, angle, spectrum and colour of the film there, from the top left; may "
        "be repeated; without -o nothing is rendered",
    )
    picture.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        action="append",
        default=[],
        help=".exr: float, scene-linear; .png: 8 bit, through the view transform; may be repeated; "
        "of --batch and --gallery a folder",
    )
    made.add_argument("--threads", metavar="N", type=_whole(1), help="default: all")
    made.add_argument("--json", action="store_true", help="print a report as JSON")
    made.add_argument("--quiet", action="store_true", help="print errors only")
    made.add_argument("-v", "--verbose", action="store_true", help="with Blender's own messages")
    return made


def _whole(least: int):
    def parse(text: str) -> int:
        if not text.isdecimal() or not least <= int(text) <= 2**31 - 1:
            raise argparse.ArgumentTypeError(f"must be a whole number ≥ {least} (got {text!r})")
        return int(text)

    return parse


def _bands(text: str) -> int | None:
    if text == AUTO:
        return None
    if not text.isdecimal() or int(text) % 3 or not 3 <= int(text) <= MOST_BANDS:
        raise argparse.ArgumentTypeError(
            f"must be auto or a multiple of 3 in 3 … {MOST_BANDS} (got {text!r})"
        )
    return int(text)


def _wavelengths(text: str) -> wavelengths.Wavelengths:
    try:
        return wavelengths.parse(text)
    except wavelengths.WavelengthsError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


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


def _sources() -> str:
    """Those that stand alone, with the names of their values."""
    return "; ".join(
        f"{item.id} ({', '.join(made.option('nm') for made in item.inputs if made.is_given)})"
        for item in SOURCES
        if item.stands_alone
    )


def _varied(text: str) -> Varied:
    try:
        return read_varied(text)
    except ThicknessError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def _frames(text: str) -> range:
    match = re.fullmatch(r"(\d+)(?:-(\d+))?", text)
    first = int(match.group(1)) if match else 1
    last = int(match.group(2) or first) if match else 0
    if last < first:
        raise argparse.ArgumentTypeError(f"must be A or A-B with A ≤ B (got {text!r})")
    return range(first, last + 1)


def _check_looks(options: argparse.Namespace) -> None:
    if options.pixel and (options.batch or options.gallery):
        raise UsageError("--pixel does not go with --batch and --gallery")
    if options.pixel and options.frames and len(options.frames) != 1:
        raise UsageError("--pixel is of one frame: give --frames A")


def parse(argv: Sequence[str]) -> argparse.Namespace:
    argv = list(argv)
    if argv[:1] == ["render"]:
        argv = argv[1:]
    options = parser().parse_args(argv)
    if not options.output and not options.pixel:
        raise UsageError("give -o FILE, or --pixel X Y")
    _check_looks(options)
    if options.batch or options.gallery:
        if options.batch and options.gallery:
            raise UsageError("give one of --batch, --gallery")
        if len(options.output) != 1:
            raise UsageError("-o: one folder for all pictures")
        return options
    _check_source(options)
    _check_thickness(options)
    _check_spectral(options)
    return options


def _check_spectral(options: argparse.Namespace) -> None:
    if not options.spectral:
        for name, given in (
            ("--light", options.light),
            ("--surface", options.surface),
            ("--bands", options.bands),
            ("--wavelengths", options.wavelengths),
            ("--mode", options.mode),
        ):
            if given not in (None, []):
                raise UsageError(f"{name} needs --spectral")
        return
    if options.bands is not None and options.wavelengths is not None:
        raise UsageError(
            "--bands and --wavelengths are one too many: both say which bands there are"
        )
    if options.form == OSL:
        raise UsageError("--spectral renders materials as nodes: --form osl does not go with it")
    if options.aov:
        raise UsageError("--aov does not go with --spectral")
    options.form = NODES


def _check_source(options: argparse.Namespace) -> None:
    sources = [options.material, options.compiled, options.template, options.blend]
    if sum(source is not None for source in sources) != 1:
        raise UsageError(
            "give one of --material, --compiled, --template, --blend, --batch, --gallery"
        )
    if options.blend is None and (options.assign or options.scene):
        raise UsageError(f"{'--assign' if options.assign else '--scene'} needs --blend")
    varied = options.vary or options.thickness_map
    of_a_stage = (
        options.stage
        or options.look
        or options.preset
        or options.set
        or options.animate
        or options.technique
    )
    if options.blend is not None and (of_a_stage or varied):
        raise UsageError(
            "--stage, --look, --preset, --set, --technique, --animate, --vary and --thickness-map do not go "
            "with --blend"
        )
    moves = options.blend or options.animate or options.look or _swirls(options)
    if options.frames and not moves:
        raise UsageError(
            "--frames needs --blend, --animate, --look or --vary swirl: nothing else moves"
        )
    if options.animate and not options.frames:
        raise UsageError("--animate needs --frames")


def _swirls(options: argparse.Namespace) -> bool:
    return "swirl" in {item.source.id for item in options.vary}


def _check_thickness(options: argparse.Namespace) -> None:
    if options.look and (options.vary or options.thickness_map):
        raise UsageError(
            "--look does not go with --vary and --thickness-map, which it brings along"
        )
    if options.range and not options.thickness_map:
        raise UsageError("--range needs --thickness-map")
    if options.thickness_map and not all(
        item.source.changes_what_is_below for item in options.vary
    ):
        raise UsageError("--thickness-map goes with --vary drop, swirl and spread alone")
