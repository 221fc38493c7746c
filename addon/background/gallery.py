# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every material of the library on its stage, and a page with large pictures, settings and recipes."""

from __future__ import annotations

import html
import re
import shutil
from collections.abc import Iterator, Sequence
from pathlib import Path

from ..core import manual
from ..core.library import Library
from ..core.looks import EVEN, even_name, picture_name, variants
from ..core.manifest import DIRECTIONS, THICKNESSES, CompiledMaterial, Socket
from ..core.space import srgb
from ..core.whole_file import write_whole
from ..core.words import synonyms
from ..films.stack import Layer, Stack, StackError, read_stack
from ..materials.image import save_png
from ..thickness.sources import (
    Input,
    ThicknessError,
    Value,
    Varied,
    read_varied,
    socket_values,
    source,
)
from .batch import Row, make_row
from .gallery_page import Card, Line, Origin, Picture, Setting, page

_ANGLES_DEG = (0, 45, 70)
_SWATCH = (256, 96)  # height, width of the table that it is drawn from
_MANUAL = "manual"  # the folder of the recipes, beside the page as beside the materials
_UNITS = {"nm": " nm", "scale": " ×", "c": " °C", "k": " K", "m": " m", "s": " s"}
_PORTRAYED = "bauble"  # what the stage portrait has for a material without an object of its own


def rows(folder: Path, given: Sequence[str]) -> list[Row]:
    """One picture for each variant of each material, in the order of the page."""
    words = {word.partition("=")[0] for word in given}
    is_varied = words & {"--vary", "--thickness-map"}
    made = []
    for variant in variants(Library.default().entries()).values():
        if variant.is_even and is_varied:
            continue  # the same picture again
        stage = [] if "--stage" in words else ["--stage", "portrait"]
        look = [] if variant.is_even or is_varied else ["--look"]
        arguments = ["--material", variant.entry.id, *stage, *look]
        name = f"{picture_name(variant.key)}.png"
        made.append(make_row(variant.key, folder, name, given, arguments))
    return made


def write_page(folder: Path, shown: Sequence[Row]) -> Path:
    """Beside the pictures of `shown` that are there."""
    library = Library.default()
    there = {row.where: row for row in shown if row.output.is_file()}
    materials = [
        library.load(row.options.material) for key, row in there.items() if not key.endswith(EVEN)
    ]
    recipes = _bring_recipes(folder, library)
    cards = [
        _card(folder, material, there, _recipes_of(material, recipes, materials))
        for material in materials
    ]
    path = folder / "index.html"
    links = [(address, title) for address, (title, _) in recipes.items()]
    write_whole(path, page(cards, links, _ANGLES_DEG))
    return path


# ---- Recipes -----------------------------------------------------------------------------------


def _bring_recipes(folder: Path, library: Library) -> dict[str, tuple[str, set[str]]]:
    """Copies the manual: address of each recipe, its title and the names of the materials that it takes.
    Nothing where no manual is at hand, as in a checkout whose extension was never packaged."""
    places = (manual.FOLDER, library.root.parent / _MANUAL)
    found = next((place for place in places if (place / "recipes.html").is_file()), None)
    if found is None:
        return {}
    shutil.copytree(found, folder / _MANUAL, dirs_exist_ok=True)
    text = (found / "recipes.html").read_text("utf-8")
    parts = re.findall(r'<h2 id="([^"]+)">(.*?)</h2>(.*?)(?=<h2|\Z)', text, re.DOTALL)
    return {
        f"{_MANUAL}/recipes.html#{anchor}": (
            html.unescape(title),
            {html.unescape(name) for name in re.findall(r"<em>Assign (.+?)</em>", body)},
        )
        for anchor, title, body in parts
    }


def _recipes_of(
    material: CompiledMaterial,
    recipes: dict[str, tuple[str, set[str]]],
    materials: Sequence[CompiledMaterial],
) -> list[tuple[str, str]]:
    """Its own; else that of a material like it, of which it goes the same way."""
    own, kindred = [], []
    for address, (title, names) in recipes.items():
        if material.name in names:
            own.append((address, f"Recipe in five steps: {title}"))
        for other in materials:
            if other.name in names and _is_kin(material, other):
                kindred.append((address, f"Recipe in five steps, with {other.name}: {title}"))
    return own or kindred


def _is_kin(material: CompiledMaterial, other: CompiledMaterial) -> bool:
    return material.category == other.category and not set(material.tags).isdisjoint(other.tags)


# ---- What stands beside a picture --------------------------------------------------------------


def _card(
    folder: Path,
    material: CompiledMaterial,
    there: dict[str, Row],
    recipes: Sequence[tuple[str, str]],
) -> Card:
    row, even = there[material.id], there.get(material.id + EVEN)
    stack = _stack(material)
    picture, dots = _colours(folder, material, stack) if stack else (None, ())
    origins = _origins(material, row)
    entry = Library.default().entries()[material.id]
    return Card(
        id=material.id,
        name=material.name,
        category=material.category,
        description=material.description,
        picture=Picture(row.output.name, _where(material, row), row.options.size),
        even=even and Picture(even.output.name, even_name(material.name), even.options.size),
        swatch=picture,
        dots=dots,
        settings=[_setting(socket, bool(origins)) for socket in material.sockets],
        origins=origins,
        stack=list(_lines(stack)) if stack else (),
        recipes=recipes,
        facts=_facts(material),
        words=(*material.tags, *synonyms(entry)),
    )


def _stack(material: CompiledMaterial) -> Stack | None:
    if not material.traits.editable_stack or not material.template:
        return None
    try:
        return read_stack(material.template)
    except StackError:  # of a later version
        return None


def _where(material: CompiledMaterial, row: Row) -> str:
    """On what it is pictured, in the words of `--stage` and of looks."""
    stage = row.options.stage
    shown_on = (material.look.object or _PORTRAYED) if stage == "portrait" else f"stage {stage}"
    return f"{material.name}, shown on: {shown_on.replace('_', ' ')}"


def _origins(material: CompiledMaterial, row: Row) -> list[Origin]:
    """What its thickness follows in the picture, the lowest first."""
    if row.options.look:
        try:
            return [_origin(read_varied(text), material) for text in material.look.thickness]
        except ThicknessError:  # of a later version; the picture is an earlier one's
            return []
    found = [_origin(varied, material) for varied in row.options.vary]
    if row.options.thickness_map:
        picture = source("map")
        name = Path(row.options.thickness_map).name
        found.insert(0, Origin(picture.name, picture.description, [("File", name)]))
    return found


def _setting(socket: Socket, is_varied: bool) -> Setting:
    if socket.type in DIRECTIONS:
        return Setting(socket.label, "of the surface", help=socket.description)
    if socket.type == "color":
        value = ", ".join(f"{channel:g}" for channel in socket.default)
        return Setting(socket.label, value, help=socket.description, colour=_css(socket.default))
    unit = "" if socket.unit == "1" else f" {socket.unit}"
    span = f"{socket.minimum:g}–{socket.maximum:g}{unit}"
    note = "where even" if is_varied and socket.name in THICKNESSES else ""
    return Setting(socket.label, f"{socket.default:g}{unit}", span, socket.description, note)


def _css(linear: Sequence[float]) -> str:
    return "#" + "".join(f"{round(255 * srgb(channel)):02x}" for channel in linear)


def _origin(varied: Varied, material: CompiledMaterial) -> Origin:
    socket = material.thickness
    values: dict[str, Value] = {}
    if socket:
        values = socket_values(varied, socket.name, (socket.minimum, socket.maximum))
    unit = socket.name.removeprefix("thickness_") if socket else ""
    inputs = {item.name: item for item in varied.source.inputs}
    told = [(name, _told(value, inputs[name], unit)) for name, value in values.items()]
    return Origin(varied.source.name, varied.source.description, told)


def _told(value: Value, item: Input, thickness_unit: str) -> str:
    if isinstance(value, tuple):
        return ", ".join(f"{number:g}" for number in value)
    return f"{value:g}{_UNITS.get(thickness_unit if item.is_thickness else item.unit, '')}"


def _facts(material: CompiledMaterial) -> list[tuple[str, str]]:
    licence = re.search(
        r"^(?:#|//) SPDX-License-Identifier: (\S+)$", material.template, re.MULTILINE
    )
    facts = [
        ("Found by", ", ".join(material.tags)),
        ("Source", material.source),
        ("Status", material.status),
        ("Id", material.id),
        ("Licence", licence.group(1) if licence else ""),
        *(("Note", note) for note in material.notes),
    ]
    return [(name, value) for name, value in facts if value]


# ---- Stacks -------------------------------------------------------------------------------------


def _lines(stack: Stack) -> Iterator[Line]:
    """From the light down; layers that repeat are told once."""
    yield Line(_medium(stack.ambient), kind="bulk")
    index = 0
    while index < len(stack.layers):
        length, times = _repeated(stack.layers, index)
        if times > 1:
            yield Line(f"{times} times these {length}:", kind="times")
        for number in range(index, index + length):
            yield _layer_line(stack, number)
        if times > 1 and index + length * times < len(stack.layers):
            yield Line("then:", kind="times")
        index += length * times
    yield Line(_medium(stack.substrate), kind="bulk")


def _repeated(layers: Sequence[Layer], start: int) -> tuple[int, int]:
    """How many layers from `start` on come again, and how often they are there: at least three times."""
    for length in (1, 2, 3, 4):
        first, times = layers[start : start + length], 1
        while layers[start + times * length : start + (times + 1) * length] == first:
            times += 1
        if times >= 3:
            return length, times
    return 1, 1


def _layer_line(stack: Stack, number: int) -> Line:
    layer = stack.layers[number]
    medium = _medium(layer.medium)
    if number == stack.varying:
        medium += " (the slider)"
    if not layer.coherent:
        medium += " (too thick to interfere)"
    return Line(medium, f"{layer.thickness_nm:g} nm")


def _medium(text: str) -> str:
    """Of the optical constants, their name in the library; of a number, what it is."""
    return f"index {text}" if text[:1].isdigit() else text


def _colours(
    folder: Path, material: CompiledMaterial, stack: Stack
) -> tuple[Picture | None, Sequence[tuple[float, str]]]:
    """Strip and dots; nothing where the Python package is not at hand."""
    try:
        import nacre
    except ImportError:
        return None, ()
    from ..core.plot import swatch  # not in Blenders without numpy, which nacre needs too

    varies = stack.varying is not None or stack.has_scale
    height, width = _SWATCH if varies else (1, _SWATCH[1])
    light = material.conditions._asdict()
    table = nacre.preview_tables(material.template, {"R": (height, width)}, **light)["R"]
    name = f"{material.id}_swatch.png"
    save_png(folder / name, swatch(table))
    socket = material.thickness
    value = socket.default if socket else 1.0
    dots = []
    for angle in _ANGLES_DEG:
        rgb = nacre.template_spectrum(material.template, value, angle, **light).colours[0]
        dots.append((angle, _css(rgb)))
    over = "angle and thickness" if varies else "the angle"
    return Picture(name, f"Colours over {over}"), dots
