# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery's page: HTML that asks no other machine for anything, wide, narrow and without scripts."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import groupby

STYLE = """
html { scroll-padding-top: 4rem }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0; background: #131416; color: #cfd1d4 }
header { position: sticky; top: 0; z-index: 1; background: #131416f2; border-bottom: 1px solid #2b2d31;
  padding: .6rem max(1rem, 50vw - 680px); display: flex; flex-wrap: wrap; align-items: baseline;
  gap: .3rem 1.5rem }
main, nav { max-width: 1360px; margin: 0 auto; padding: 0 1rem }
h1, h2, h3, h4 { color: #f2f2f3; font-weight: 600; line-height: 1.2; margin: 0 }
h1 { font-size: 1.15rem } h2 { font-size: 1.6rem; margin: 4rem 0 1rem } h3 { font-size: 1.9rem }
h4 { font-size: 1rem; margin: 1.5rem 0 .35rem }
a { color: #8ab8ff; text-decoration: none } a:hover { text-decoration: underline }
label { margin-left: auto }
input { font: inherit; width: 15rem; max-width: 60vw; background: #1f2125; color: inherit;
  border: 1px solid #3d4046; border-radius: 6px; padding: .25rem .6rem }
nav { display: grid; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); gap: 1.2rem 2rem;
  margin-top: 1.5rem }
nav p { margin: .15rem 0; font-size: .9rem } nav b { font-weight: 600 }
nav p a + a::before { content: "· "; color: #6d7076 }
.lead { max-width: 1360px; margin: 1.5rem auto 0; padding: 0 1rem; color: #a4a7ad }
article { display: grid; grid-template-columns: minmax(0, 1.3fr) minmax(0, 1fr); gap: 2rem; align-items: start;
  padding: 1.75rem 0; border-top: 1px solid #2b2d31 }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: .6rem 1rem }
.pictures > * { margin: 0 } .pictures img { display: block; width: 100%; height: auto; border-radius: 8px }
.large, .alone { grid-column: 1 / -1 }
.swatch img { aspect-ratio: 1 } .alone img { aspect-ratio: auto; height: 72px }
figcaption, small, .quiet { color: #9a9da4; font-size: .85rem }
.dots span { display: inline-block; width: 1.3em; height: 1.3em; border-radius: 50%;
  vertical-align: -.3em; margin-right: .3em }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums }
td, th { text-align: left; vertical-align: top; font-weight: 400; padding: .3rem .6rem .3rem 0;
  border-bottom: 1px solid #26282c }
th[scope=col] { color: #9a9da4; font-size: .85rem } td { white-space: nowrap }
td:last-child { padding-right: 0 } table small { display: block }
p { margin: .4rem 0 } ul, ol { margin: 0; padding: 0; list-style: none }
li { padding: .15rem 0 } li b { font-weight: 600; color: #e8e9ea }
.stack li { border-left: 3px solid #3d4046; padding-left: .7rem }
.stack .bulk { border-color: #6d7076; color: #9a9da4 }
.stack .times { border-color: #8ab8ff }
.chip { display: inline-block; width: 1.1em; height: 1.1em; border-radius: 3px; vertical-align: -.2em;
  margin-right: .4em; border: 1px solid #4a4d54 }
.recipe { display: inline-block; margin: .9rem .5rem 0 0; padding: .35rem .8rem; border: 1px solid #3d5a85;
  border-radius: 6px }
[hidden] { display: none !important }
@media (max-width: 860px) {
  article { grid-template-columns: minmax(0, 1fr); gap: 1rem }
  header { position: static } html { scroll-padding-top: 0 }
  nav { grid-template-columns: 1fr 1fr; gap: .5rem 1rem } nav p { display: none }
  h3 { font-size: 1.5rem } h2 { margin-top: 2.5rem }
}
"""

# Each word that is typed has to be in a material's words.
SCRIPT = """
const field = document.querySelector("input"), cards = [...document.querySelectorAll("article")];
field.parentElement.hidden = false;
field.addEventListener("input", () => {
  const typed = field.value.toLowerCase().split(/\\s+/);
  for (const card of cards) card.hidden = !typed.every(word => card.dataset.words.includes(word));
  for (const part of document.querySelectorAll("section"))
    part.hidden = !part.querySelector("article:not([hidden])");
  const left = cards.filter(card => !card.hidden).length;
  document.querySelector("output").textContent = left < cards.length ? left + " of " + cards.length : "";
});
"""

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Nacre: {count} material{s}</title>
<style>{style}</style>
</head>
<body>
<header><h1>Nacre: {count} material{s}</h1>{recipes}
<label hidden>Search <input type="search" placeholder="soap, rainbow, car paint"> <output></output></label>
</header>
<p class="lead">Each picture shows a material as it comes from the tab <i>Nacre</i>; beside it is what its
sliders stand at, and how far they go. Strips: the colour of the film alone, over the angle from 0° on the left
to 85°, and over what varies, upwards. Dots: at {angles}, as the material comes. Colours outside sRGB are held
to it.</p>
<nav>
{contents}
</nav>
<main>
{sections}
</main>
<script>{script}</script>
</body>
</html>
"""


@dataclass(frozen=True)
class Setting:
    """A socket, in the words of the panel."""

    label: str
    value: str
    span: str = ""
    help: str = ""
    note: str = ""  # about the value
    colour: str = ""  # of CSS


@dataclass(frozen=True)
class Origin:
    """Something that a thickness follows, and its values."""

    name: str
    help: str
    values: Sequence[tuple[str, str]] = ()


@dataclass(frozen=True)
class Line:
    """Of a stack, from the light down; `bulk` has no thickness."""

    medium: str
    thickness: str = ""
    kind: str = ""


@dataclass(frozen=True)
class Picture:
    file: str
    text: str
    size: tuple[int, int] | None = None


@dataclass(frozen=True)
class Card:
    """All that the page tells of a material."""

    id: str
    name: str
    category: str
    description: str
    picture: Picture
    even: Picture | None = None
    swatch: Picture | None = None
    dots: Sequence[tuple[float, str]] = ()  # angle in degrees, colour of CSS
    settings: Sequence[Setting] = ()
    origins: Sequence[Origin] = ()
    stack: Sequence[Line] = ()
    recipes: Sequence[tuple[str, str]] = ()  # address, text
    facts: Sequence[tuple[str, str]] = ()
    words: Sequence[str] = field(default=())  # it is found by


def page(
    cards: Sequence[Card], recipes: Sequence[tuple[str, str]], angles_deg: Sequence[int]
) -> str:
    """`recipes` are addresses and names; none where there is no manual to link to."""
    groups = [(name, list(group)) for name, group in groupby(cards, key=lambda card: card.category)]
    return _PAGE.format(
        count=len(cards),
        s="s" * (len(cards) != 1),
        style=STYLE,
        script=SCRIPT,
        angles=_list([f"{angle}°" for angle in angles_deg]),
        recipes=_recipe_list(recipes),
        contents="\n".join(_contents(name, group) for name, group in groups),
        sections="\n".join(_section(name, group) for name, group in groups),
    )


def _list(words: Sequence[str]) -> str:
    return " and ".join(filter(None, (", ".join(words[:-1]), *words[-1:])))


def _recipe_list(recipes: Sequence[tuple[str, str]]) -> str:
    if not recipes:
        return ""
    links = ", ".join(_link(address, name) for address, name in recipes)
    return f"\n<span>Recipes of five steps: {links}</span>"


def _link(address: str, text: str, css: str = "") -> str:
    named = f' class="{css}"' if css else ""
    return f'<a{named} href="{html.escape(address)}">{html.escape(text)}</a>'


def _anchor(category: str) -> str:
    """No id of a material has a dash."""
    return "in-" + "-".join(category.lower().replace("/", " ").split())


def _title(category: str) -> str:
    return category.replace("/", " › ")


def _contents(category: str, cards: Iterable[Card]) -> str:
    names = " ".join(_link(f"#{card.id}", card.name) for card in cards)
    head = _link(f"#{_anchor(category)}", _title(category))
    return f"<div><b>{head}</b><p>{names}</p></div>"


def _section(category: str, cards: Iterable[Card]) -> str:
    articles = "\n".join(map(article, cards))
    return (
        f'<section id="{html.escape(_anchor(category))}"><h2>{html.escape(_title(category))}</h2>\n'
        f"{articles}\n</section>"
    )


def article(card: Card) -> str:
    text = html.escape
    found = " ".join((card.name, card.id, card.category, card.description, *card.words)).lower()
    parts = (
        f"<h3>{text(card.name)}</h3>",
        f"<p>{text(card.description)}</p>",
        _dots(card.dots),
        _origins(card.origins),
        _settings(card.settings),
        _stack(card.stack),
        "".join(_link(address, name, "recipe") for address, name in card.recipes),
        _facts(card.facts),
    )
    beside = "\n".join(filter(None, parts))
    return (
        f'<article id="{text(card.id)}" data-words="{text(found)}">\n{_pictures(card)}\n'
        f'<div class="text">\n{beside}\n</div></article>'
    )


def _image(picture: Picture) -> str:
    text = html.escape
    size = " width={} height={}".format(*picture.size) if picture.size else ""
    return f'<img src="{text(picture.file)}" alt="{text(picture.text)}"{size} loading="lazy">'


def _pictures(card: Card) -> str:
    text = html.escape
    lines = ['<div class="pictures">']
    large = f'<a href="{text(card.picture.file)}">{_image(card.picture)}</a>'
    lines.append(
        f'<figure class="large">{large}<figcaption>{text(card.picture.text)}</figcaption></figure>'
    )
    if card.even:
        link = f'<a href="{text(card.even.file)}">{_image(card.even)}</a>'
        lines.append(
            f'<figure class="even">{link}<figcaption>{text(card.even.text)}</figcaption></figure>'
        )
    if card.swatch:
        css = "swatch" if card.even else "swatch alone"
        caption = f"<figcaption>{text(card.swatch.text)}</figcaption>"
        lines.append(f'<figure class="{css}">{_image(card.swatch)}{caption}</figure>')
    return "\n".join([*lines, "</div>"])


def _dots(dots: Sequence[tuple[float, str]]) -> str:
    if not dots:
        return ""
    spans = "".join(
        f'<span style="background:{colour}" title="{angle:g}°: {colour}"></span>'
        for angle, colour in dots
    )
    angles = ", ".join(f"{angle:g}°" for angle, _ in dots)
    return f'<p class="dots">{spans} <small>at {angles}</small></p>'


def _settings(settings: Sequence[Setting]) -> str:
    if not settings:
        return ""
    rows = [
        '<tr><th scope="col">Setting</th><th scope="col">As it comes</th><th scope="col">Range</th></tr>'
    ]
    for item in settings:
        text = html.escape
        chip = f'<span class="chip" style="background:{item.colour}"></span>' if item.colour else ""
        label = (
            f"{text(item.label)}<small>{text(item.help)}</small>" if item.help else text(item.label)
        )
        note = f"<small>{text(item.note)}</small>" if item.note else ""
        rows.append(
            f'<tr><th scope="row">{label}</th><td>{chip}{text(item.value)}{note}</td>'
            f"<td>{text(item.span)}</td></tr>"
        )
    return "<h4>Settings</h4>\n<table>\n" + "\n".join(rows) + "\n</table>"


def _origins(origins: Sequence[Origin]) -> str:
    if not origins:
        return ""
    text = html.escape
    lines = []
    for item in origins:
        values = ", ".join(f"{text(name)} <b>{text(value)}</b>" for name, value in item.values)
        lines.append(
            f"<li><b>{text(item.name)}</b>{': ' * bool(values)}{values}<br>"
            f"<small>{text(item.help)}</small></li>"
        )
    return '<h4>Thickness follows</h4>\n<ul class="origins">' + "".join(lines) + "</ul>"


def _stack(stack: Sequence[Line]) -> str:
    if not stack:
        return ""
    text = html.escape
    lines = []
    for line in stack:
        css = f' class="{line.kind}"' if line.kind else ""
        thickness = f"<b>{text(line.thickness)}</b> " if line.thickness else ""
        lines.append(f"<li{css}>{thickness}{text(line.medium)}</li>")
    return '<h4>Stack</h4>\n<ol class="stack">' + "".join(lines) + "</ol>"


def _facts(facts: Sequence[tuple[str, str]]) -> str:
    if not facts:
        return ""
    rows = "<br>\n".join(f"{html.escape(name)}: {html.escape(value)}" for name, value in facts)
    return f'<p class="quiet">{rows}</p>'
