# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every material of the library on its stage, and a page with pictures, swatches and numbers."""

from __future__ import annotations

import html
from collections.abc import Sequence
from pathlib import Path

from .batch import Row, make_row
from .core.library import Library
from .core.looks import EVEN, picture_name, variants
from .core.manifest import CompiledMaterial
from .core.stack import read_stack
from .core.whole_file import write_whole
from .nodes.image import save_png

_ANGLES_DEG = (0, 45, 70)
_SWATCH = (64, 96)  # height, width of the table that it is drawn from

_PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Nacre: {count} materials</title>
<style>
body {{ font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 1180px; padding: 0 1rem;
  background: #17181a; color: #d8d9db }}
h1, h2 {{ font-weight: 600 }} h2 {{ margin: 2.2rem 0 .8rem; color: #f0f0f0 }}
.grid {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(260px, 1fr)); gap: 1rem }}
article {{ background: #212327; border-radius: 8px; overflow: hidden }}
article > img {{ width: 100%; display: block }}
.text {{ padding: .7rem .9rem 1rem }}
h3 {{ margin: 0 0 .2rem; font-size: 1rem }}
p {{ margin: .3rem 0 }}
.swatch {{ width: 100%; height: 64px; border-radius: 4px; image-rendering: auto }}
.dots span {{ display: inline-block; width: 1.1em; height: 1.1em; border-radius: 50%;
  vertical-align: -.2em; margin-right: .25em }}
small, code {{ color: #a4a7ad; font-size: .8rem }}
</style>
<h1>Nacre: {count} materials</h1>
<p>Strips: colour of the film alone over the angle, 0° on the left to 85°, and over what varies, upwards.
Dots: at 0°, 45° and 70°, as the material comes. Colours outside sRGB are held to it.</p>
{sections}
</html>
"""


def rows(folder: Path, given: Sequence[str]) -> list[Row]:
    """One picture for each variant of each material, in the order of the page."""
    words = {word.partition("=")[0] for word in given}
    is_varied = words & {"--vary", "--thickness-map"}
    made = []
    for variant in variants(Library.default().entries()).values():
        stage = [] if "--stage" in words else ["--stage", "portrait"]
        look = [] if variant.is_even or is_varied else ["--look"]
        arguments = ["--material", variant.entry.id, *stage, *look]
        name = f"{picture_name(variant.key)}.png"
        made.append(make_row(variant.key, folder, name, given, arguments))
    return made


def write_page(folder: Path, shown: Sequence[Row]) -> Path:
    library = Library.default()
    sections: list[str] = []
    category = None
    for row in shown:
        if not row.output.is_file() or row.where.endswith(EVEN):
            continue
        material = library.load(row.options.material)
        if material.category != category:
            category = material.category
            sections.append(f"{'</div>' if sections else ''}<h2>{html.escape(category)}</h2>")
            sections.append('<div class="grid">')
        sections.append(_article(folder, material))
    if sections:
        sections.append("</div>")
    page = folder / "index.html"
    count = sum("<article" in text for text in sections)
    write_whole(page, _PAGE.format(count=count, sections="\n".join(sections)))
    return page


def _article(folder: Path, material: CompiledMaterial) -> str:
    text = html.escape
    lines = [f'<article><img src="{material.id}.png" alt="{text(material.name)}" loading="lazy">']
    even = f"{picture_name(material.id + EVEN)}.png"
    if (folder / even).is_file():
        lines.append(f'<img class="even" src="{even}" alt="of one thickness" loading="lazy">')
    lines.append(f'<div class="text"><h3>{text(material.name)}</h3>')
    if material.kind == "film" and material.template:
        lines += _film_lines(folder, material)
    lines.append(f"<p>{text(material.description)}</p>")
    lines.append(f"<p><code>{material.id}</code> <small>{material.status}</small></p>")
    lines.append(f"<p><small>{text(material.source)}</small></p></div></article>")
    return "\n".join(lines)


def _film_lines(folder: Path, material: CompiledMaterial) -> list[str]:
    """Strip, dots and numbers; nothing where the Python package is not at hand."""
    try:
        import nacre
    except ImportError:
        return []
    from .core import plot

    stack = read_stack(material.template)
    varies = stack.varying is not None or stack.has_scale
    height, width = _SWATCH if varies else (1, _SWATCH[1])
    light = material.conditions._asdict()
    table = nacre.preview_tables(material.template, {"R": (height, width)}, **light)["R"]
    name = f"{material.id}_swatch.png"
    save_png(folder / name, plot.swatch(table))
    socket = material.socket("thickness_nm") or material.socket("thickness_scale")
    value = socket.default if socket else 1.0
    dots = []
    for angle in _ANGLES_DEG:
        rgb = nacre.template_spectrum(material.template, value, angle, **light).colours[0]
        code = "#" + "".join(f"{round(255 * channel):02x}" for channel in plot.encode(rgb))
        dots.append(f'<span style="background:{code}" title="{angle}°: {code}"></span>')
    said = [f"{len(stack.layers)} layer{'s' * (len(stack.layers) != 1)}"]
    if socket:
        unit = "" if socket.unit == "1" else f" {socket.unit}"
        said.append(f"{socket.minimum:g}–{socket.maximum:g}{unit}")
    lines = [f'<img class="swatch" src="{name}" alt="colours over the angle">']
    lines.append(f'<p class="dots">{"".join(dots)} <small>{", ".join(said)}</small></p>')
    return lines
