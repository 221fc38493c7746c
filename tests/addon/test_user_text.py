# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What people write: every printable character passes through shaders, files and pages as it is."""

from __future__ import annotations

import html
import json
import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest
from nacre_extension.core.catalogues import catalogue_text
from nacre_extension.core.oso import parse_parameters

from support.images import read_image
from support.paths import tool
from support.tool import nacre

PRINTABLE = "".join(map(chr, range(0x20, 0x7F)))
TEXTS = {
    "trigraphs": "Why??) ??( ??/ ??= ??' ??< ??! ??> ??- ???? What?",
    "printable": PRINTABLE,
    "backwards": PRINTABLE[::-1],
    "quotes": '"" \\" "\\" \\n %s %d {0} {{ }} ${HOME} `id` $(id)',
    "comments": '/* // */ # #include "nacre/x.h" <!-- --> ]]> [[ ]] ; ( )',
    "hints": '%initexpr %meta{string,label,"x"} %filename{"x"} %read{1,1}',
    "letters": "薄膜 é λ \u2028 \u00a0 \U0001f308 ﷽",
}

TEMPLATE = """schema = 1
[material]
id = "odd"
name = {text}
category = {text}
description = {text}
source = {text}
tags = [{text}]
[ambient]
medium = "air"
[[layer]]
n = 2.0
thickness_nm = 300
[substrate]
n = 1.5
k = 3.0
[surface]
roughness = 0.1
[[parameter]]
name = "coverage"
label = {text}
description = {text}
default = 0.5
"""


_VARIES = "= { default = 300, min = 100, max = 500, varies = true }\n"
_LAYER = "[[layer]]\nn = 2.0\nthickness_nm = 300\n"
_BASE = '[ambient]\nmedium = "air"\n' + _LAYER + "[substrate]\nn = 1.5\nk = 3.0\n"
SHAPES = {
    "film": lambda text: text,
    "varies": lambda text: text.replace("= 300\n", _VARIES),
    "mirror": lambda text: text.replace(_LAYER, ""),
    "glass": lambda text: text.replace(
        _BASE, "[glass]\nabbe = { n_d = 1.5, v_d = 64.0 }\n"
    ).replace("coverage", "roughness"),
}


@pytest.fixture
def write(tmp_path):
    """A template that has a text wherever there can be one."""

    def write(text: str):
        path = tmp_path / "odd.toml"
        # JSON's strings are TOML's too.
        path.write_text(TEMPLATE.format(text=json.dumps(text, ensure_ascii=False)), "utf-8")
        return path

    return write


@pytest.mark.parametrize("name", TEXTS)
def test_compiles_and_renders(blender, tmp_path, write, name):
    """What `library check` says is fine compiles in Cycles without a word, and is not black."""
    text, output = TEXTS[name], tmp_path / "a.exr"
    template = write(text)
    nacre("library", "check", template)
    nacre("compile", template, "--quiet", "-o", tmp_path / "made")
    done = blender.render(
        "--compiled", tmp_path / "made" / "odd", "--form", "osl", "--stage", "furnace",
        "--size", "8x8", "--samples", "1", "-o", output,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "trigraph" not in done.stderr
    assert read_image(output).min() > 0.1
    manifest = json.loads((tmp_path / "made" / "odd" / "odd.json").read_text("utf-8"))
    assert manifest["name"] == manifest["description"] == text
    osl = (tmp_path / "made" / "odd" / "odd.osl").read_text("utf-8")
    bytecode, said, wrong = blender.ask("osl.compile_all", shaders={"odd": osl})
    assert not re.search("warning|error:", said + wrong, re.IGNORECASE), said + wrong
    labels = {found.name: found.label for found in parse_parameters(bytecode["odd"])}
    assert labels["coverage"] == text


@pytest.mark.parametrize("name", TEXTS)
def test_the_title_of_a_ramp_is_one_string(tmp_path, write, name):
    template = write(TEXTS[name])
    varies = "{ default = 300, min = 100, max = 500, varies = true }"
    template.write_text(template.read_text("utf-8").replace("= 300\n", f"= {varies}\n"), "utf-8")
    for suffix in ("cube", "csv"):
        nacre("bake", "ramp", template, "--size", "4", "-o", tmp_path / f"a.{suffix}")
    lines = (tmp_path / "a.cube").read_text("utf-8").split("\n")
    assert re.fullmatch(r'TITLE "[^"]+"', lines[0])
    assert lines[3] == "LUT_1D_SIZE 4"
    rows = (tmp_path / "a.csv").read_text("utf-8").split("\n")
    assert rows[0] == f"# {TEXTS[name]}"


@pytest.mark.parametrize(
    ("shape", "name"),
    [
        *(("film", name) for name in TEXTS),
        *((shape, "printable") for shape in SHAPES if shape != "film"),
    ],
)
def test_exports_are_whole_and_have_the_name(tmp_path, write, name, shape):
    """In whatever folder and under whatever name of a file."""
    text, template = TEXTS[name], write(TEXTS[name])
    template.write_text(SHAPES[shape](template.read_text("utf-8")), "utf-8")
    folder = tmp_path / "a&b \"c\" 'd' <e> --f ]]> $g é"
    folder.mkdir()
    stem = folder / "x&y -- '<z>' \"$薄"
    for suffix, command in (("gltf", "gltf"), ("mtlx", "materialx"), ("xml", "mitsuba")):
        (summary,) = json.loads(
            nacre("export", command, template, "--json", "-o", f"{stem}.{suffix}")
        )
        assert summary["name"] == text
    document = json.loads(Path(f"{stem}.gltf").read_text("utf-8"))
    assert document["materials"][0]["extras"]["nacre"]["name"] == text
    nacre("export", "gltf", template, "-o", f"{stem}.glb")
    binary = Path(f"{stem}.glb").read_bytes()
    length = int.from_bytes(binary[12:16], "little")
    document = json.loads(binary[20 : 20 + length])
    assert document["materials"][0]["extras"]["nacre"]["name"] == text
    graph = ElementTree.parse(f"{stem}.mtlx").getroot().find("nodegraph")
    assert graph.get("doc").startswith(f"{text}: ")
    scene = ElementTree.parse(f"{stem}.xml").getroot()
    for root in (graph, scene):
        for file in root.iterfind(".//*[@type='filename']"):
            assert (folder / file.get("value")).is_file()
    for file in scene.iterfind(".//spectrum[@filename]"):
        assert (folder / file.get("filename")).is_file()


def refused(template, *command) -> str:
    done = subprocess.run([tool(), *command, template], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    return done.stderr


@pytest.mark.parametrize("place", range(7))
def test_control_characters_are_refused_in_every_place(tmp_path, write, place):
    """With a line of its own for each; what is checked is what is compiled."""
    whole = write("fine").read_text("utf-8")
    parts = whole.split('"fine"')
    assert len(parts) == 8
    text = ("a\tb", "a\nb", "a\rb", "a\x01b", "a\x7fb", "a\x00b", "")[place]
    quoted = '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text) + '"'
    before, after = '"fine"'.join(parts[: place + 1]), '"fine"'.join(parts[place + 1 :])
    template = tmp_path / "odd.toml"
    template.write_text(before + quoted + after, "utf-8")
    said = refused(template, "library", "check")
    assert f"odd.toml:{before.count(chr(10)) + 1}: " in said
    assert "without control characters" in said
    compiled = refused(template, "compile", "-o", tmp_path / "made")
    assert compiled == said.replace("nacre library check: ", "nacre compile: ")
    assert not (tmp_path / "made").exists()


@pytest.mark.parametrize("name", TEXTS)
def test_catalogues_have_three_fields_a_line(name):
    lines = catalogue_text({TEXTS[name], "//", " a / b:c /"}).split("\n")
    entries = [line for line in lines if line.count(":") and not line.startswith(("#", "VERSION"))]
    assert len(entries) >= 4
    assert all(re.fullmatch(r"[0-9a-f-]{36}:[^:]+:[^:]+", line) for line in entries)


@pytest.mark.parametrize("name", TEXTS)
def test_the_page_shows_the_text(blender45, tmp_path, write, name):
    nacre("compile", write(TEXTS[name]), "--quiet", "-o", tmp_path / "library")
    library = blender45.with_environment(NACRE_MATERIALS=str(tmp_path / "library"))
    done = library.render("--gallery", "--size", "8x8", "--samples", "1", "-o", tmp_path / "page")
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "page" / "index.html").read_text("utf-8")
    assert f"<h3>{html.escape(TEXTS[name])}</h3>" in page
