# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The gallery's page: what stands beside each picture, and that it needs nothing but its folder."""

from __future__ import annotations

import html
import re
from pathlib import Path

import pytest
from nacre_extension.background.gallery_page import Card, Line, Origin, Picture, Setting, page

from support.paths import STAGE_EXTENSION, manifest

MATERIALS = ("cd", "jewel_beetle", "lustre_ceramic", "rose_chafer", "soap_film")
FEW = ("--gallery", "--size", "8x8", "--samples", "1")


def articles(text: str) -> dict[str, str]:
    found = re.findall(r'<article id="(.*?)".*?</article>', text, re.DOTALL)
    bodies = re.findall(r"<article .*?</article>", text, re.DOTALL)
    return dict(zip(found, bodies, strict=True))


def words(fragment: str) -> str:
    """What is read of it."""
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", fragment)).split())


def settings(article: str) -> dict[str, tuple[str, str]]:
    """By label: value and range, as they are read."""
    rows = re.findall(
        r'<th scope="row">(.*?)(?:<small>.*?</small>)?</th><td>(.*?)</td><td>(.*?)</td>', article
    )
    return {words(label): (words(value), words(span)) for label, value, span in rows}


@pytest.fixture
def folder(blender45, tmp_path, monkeypatch) -> Path:
    """Of a gallery, the manual beside the materials as the tool has it."""
    library = blender45.with_materials(*MATERIALS)
    monkeypatch.syspath_prepend(STAGE_EXTENSION.parent)
    import write_manual

    write_manual.write_manual(library.folder / "manual")
    done = library.render(*FEW, "-o", tmp_path / "gallery")
    assert done.returncode == 0, done.stderr
    return tmp_path / "gallery"


def test_gallery_is_whole(folder):
    text = (folder / "index.html").read_text("utf-8")
    shown = articles(text)
    assert sorted(shown) == sorted(MATERIALS)
    for material, article in shown.items():
        _settings_are_those_of(manifest(material), article)
        _facts_are_those_of(manifest(material), article)
        assert f'<img src="{material}.png"' in article
    _thickness_is_told(shown)
    _stacks_are_told(shown)
    _recipes_are_there(folder, text, shown)
    _leads_nowhere_else(folder, text)


def _settings_are_those_of(data: dict, article: str) -> None:
    told = settings(article)
    assert list(told) == [socket["label"] for socket in data["sockets"]]
    varies = bool(data.get("look", {}).get("thickness"))
    for socket in data["sockets"]:
        value, span = told[socket["label"]]
        unit = "" if socket["unit"] == "1" else f" {socket['unit']}"
        if socket["type"] == "color":
            assert value == ", ".join(f"{channel:g}" for channel in socket["default"])
        elif socket["type"] in ("float", "int"):
            note = " where even" * (varies and socket["name"].startswith("thickness"))
            assert value == f"{socket['default']:g}{unit}{note}"
            assert span == f"{socket['min']:g}–{socket['max']:g}{unit}"
        assert html.escape(socket.get("description", "")) in article


def _facts_are_those_of(data: dict, article: str) -> None:
    for value in (
        *(data["name"], data["description"], data["source"], ", ".join(data["tags"])),
        *(f"Status: {data['status']}", f"Id: {data['id']}", "Licence: BSD-3-Clause"),
        f"shown on: {data['look']['object'].replace('_', ' ')}",
    ):
        assert value in words(article)


def _thickness_is_told(shown: dict[str, str]) -> None:
    bubble = words(shown["soap_film"])
    assert "Drainage : Bottom 950 nm , Black Film 0.07" in bubble
    assert "Swirl : Time 1 s , Amount 0.3" in bubble
    assert bubble.index("Drainage") < bubble.index("Swirl")
    assert '<img src="soap_film.even.png"' in shown["soap_film"]
    assert "even" not in shown["cd"]
    assert "Thickness follows" not in shown["jewel_beetle"]


def _stacks_are_told(shown: dict[str, str]) -> None:
    assert "air 400 nm water/Daimon-20C (the slider) air" in words(shown["soap_film"])
    repeated = "air 8 times these 2: 80 nm index 1.7 80 nm index 1.6 index 1.6+0.05i"
    assert repeated in words(shown["jewel_beetle"])
    assert "Stack" not in words(shown["cd"])


def _recipes_are_there(folder: Path, text: str, shown: dict[str, str]) -> None:
    recipes = (folder / "manual" / "recipes.html").read_text("utf-8")
    headings = re.findall(r'<h2 id="(.*?)">', recipes)
    assert len(headings) >= 8
    head = text.partition("</header>")[0]
    assert re.findall(r'href="manual/recipes\.html#(.*?)"', head) == headings
    for material, told in (
        ("soap_film", 'recipes.html#bubble">Recipe in five steps: Bubble<'),
        ("jewel_beetle", 'recipes.html#beetle">Recipe in five steps, with Rose Chafer: Beetle<'),
        ("cd", 'recipes.html#cd">Recipe in five steps: CD<'),
    ):
        assert told in shown[material]
    assert "recipes.html" not in shown["lustre_ceramic"]
    for picture in re.findall(r'<img src="(.*?)"', recipes):
        assert (folder / "manual" / picture).is_file(), picture


def _leads_nowhere_else(folder: Path, text: str) -> None:
    """Whatever the page loads or leads to lies in its folder."""
    assert not re.search(r"url\(|@import|<link|<script src|<iframe|fetch\(", text)
    ids = set(re.findall(r' id="(.*?)"', text))
    for target in re.findall(r'(?:src|href)="(.*?)"', text):
        file, _, anchor = html.unescape(target).partition("#")
        assert (folder / file).exists(), target
        assert file or anchor in ids, target


def test_gallery_tells_how_it_was_varied(blender45, tmp_path):
    """Its own look is not what is seen then; nor is there an even picture."""
    library = blender45.with_materials("tempered_steel")
    done = library.render(*FEW, "--vary", "noise:minimum_nm=10,maximum_nm=62", "-o", tmp_path / "g")
    assert done.returncode == 0, done.stderr
    told = words((tmp_path / "g" / "index.html").read_text("utf-8"))
    assert "Noise : Minimum 10 nm , Maximum 62 nm" in told
    assert "Heat over the Object" not in told
    assert not (tmp_path / "g" / "tempered_steel.even.png").exists()


ODD = "<b>\"&'</script>"


def test_page_escapes_whatever_it_is_told():
    card = Card(
        id="odd",
        name=ODD,
        category=ODD,
        description=ODD,
        picture=Picture("odd.png", ODD, (8, 8)),
        even=Picture("odd.even.png", ODD),
        swatch=Picture("odd_swatch.png", ODD),
        dots=[(0, "#102030")],
        settings=[Setting(ODD, ODD, ODD, ODD, ODD, "#102030")],
        origins=[Origin(ODD, ODD, [(ODD, ODD)])],
        stack=[Line(ODD, ODD, "bulk")],
        recipes=[(f"manual/recipes.html#{ODD}", ODD)],
        facts=[(ODD, ODD)],
        words=[ODD],
    )
    text = page([card], [(ODD, ODD)], (0, 45))
    assert ODD not in text
    assert "<b>&quot;" not in text
    assert text.count(html.escape(ODD)) >= 20
    assert text.count("</script>") == 1
    assert "1 material<" in text
    assert "at 0° and 45°," in text


def test_page_without_a_manual_has_no_recipes():
    card = Card("odd", "Odd", "Odd/Things", "Odd", Picture("odd.png", "Odd"))
    text = page([card], [], (0,))
    assert "ecipe" not in re.sub(r"<style>.*?</style>", "", text, flags=re.DOTALL)
    assert '<section id="in-odd-things"><h2>Odd › Things</h2>' in text
    assert 'href="#in-odd-things"' in text
