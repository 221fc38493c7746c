# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the documents tell a reader to type works.

A fenced block of commands has a mark on the line before it:

    <!-- run -->         it is run, as a shell or Python does
    <!-- render -->      so are its commands, with few pixels and frames, where there is a Blender
    <!-- file: NAME -->  it is that file, there for the blocks after it
    <!-- prints -->      it is what the block before it prints, with numbers cut as the page likes
    <!-- not run -->     it needs what a test has not, or takes too long; the page says so
"""

from __future__ import annotations

import inspect
import json
import operator
import re
from collections import Counter
from pathlib import Path

import pytest
from PIL import Image

from support.paths import ROOT
from support.typed import run

DOCUMENTS = (
    "README.md",
    "CONTRIBUTING.md",
    *sorted(f"cpp_tools/doc/{page.name}" for page in (ROOT / "cpp_tools/doc").glob("*.md")),
)
BLOCK = re.compile(
    r"<!-- (?P<kind>run|render|prints|not run|file: (?P<name>\S+)) -->\n"
    r"```(?P<language>\w+)\n(?P<text>.*?)```",
    re.DOTALL,
)
FENCE = re.compile(r"^(?P<before>[^\n]*)\n```(?P<language>\w*)\n.*?^```$", re.MULTILINE | re.DOTALL)
COMMANDS = {"", "sh", "bash", "console", "python", "c", "cpp"}
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def marked_blocks(document: str) -> list[re.Match]:
    return list(BLOCK.finditer((ROOT / document).read_text(encoding="utf-8")))


def without_numbers(text: str) -> str:
    return re.sub(r"\s+", "", NUMBER.sub("#", text))


def assert_prints(shown: str, printed: str) -> None:
    """The same words, and every number within one unit of the last digit that is shown."""
    assert without_numbers(printed) == without_numbers(shown)
    for number, full in zip(NUMBER.findall(shown), NUMBER.findall(printed), strict=True):
        mantissa, _, exponent = number.partition("e")
        digits = len(mantissa.partition(".")[2])
        unit = 10.0 ** (int(exponent or 0) - digits)
        assert abs(float(number) - float(full)) <= 0.51 * unit, f"{number} stands for {full}"


RENDERING = [
    document
    for document in DOCUMENTS
    if any(block["kind"] == "render" for block in marked_blocks(document))
]


def small(command: str) -> str:
    """`nacre render` as quick as it can be; a pixel that is probed needs no picture."""
    command = re.sub(r"--frames 1-\d+", "--frames 1-2", command)
    return command if "--pixel" in command else f"{command} --size 8x8 --samples 1"


def write(block: re.Match, folder: Path) -> None:
    file = folder / block["name"]
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(block["text"], encoding="utf-8")


@pytest.mark.parametrize("document", DOCUMENTS)
def test_commands_of_the_document_run(document, nacre, tmp_path):
    printed = ""
    for block in marked_blocks(document):
        if block["name"]:
            write(block, tmp_path)
        elif block["kind"] == "prints":
            assert_prints(block["text"], printed)
        elif block["kind"] == "run":
            printed = run(block["language"], block["text"], tmp_path, nacre.program)


@pytest.mark.parametrize("document", RENDERING)
def test_commands_that_render_run(document, blenders, nacre, tmp_path):
    blender = blenders.get("4.5", tmp_path)
    if blender is None:
        pytest.skip("NACRE_BPY45 names no Python with bpy 4.5")
    Image.new("L", (4, 4), 128).save(tmp_path / "spill.png")
    blender.call("program.save_scene", file=str(tmp_path / "shot.blend"))
    for block in marked_blocks(document):
        if block["name"]:
            write(block, tmp_path)
        elif block["kind"] == "render":
            for command in block["text"].splitlines():
                run("sh", small(command), tmp_path, nacre.program)


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_block_of_commands_is_marked(document):
    text = (ROOT / document).read_text(encoding="utf-8")
    unmarked = [
        found.group()
        for found in FENCE.finditer(text)
        if found["language"] in COMMANDS and not found["before"].startswith("<!-- ")
    ]
    assert not unmarked


def test_readme_has_commands_to_run():
    languages = [
        block["language"] for block in marked_blocks("README.md") if block["kind"] == "run"
    ]
    assert {"sh", "python"} <= set(languages)


@pytest.mark.parametrize("document", DOCUMENTS)
def test_links_of_the_document_lead_somewhere(document):
    text = (ROOT / document).read_text(encoding="utf-8")
    targets = re.findall(r"\]\(([^)#:]+)\)", text) + re.findall(r'src="([^":]+)"', text)
    folder = (ROOT / document).parent
    missing = [target for target in targets if not (folder / target).exists()]
    assert not missing


def test_pictures_of_the_readme_are_large_and_light():
    """As `./dev demo --pictures` makes them: sharp on any screen, and few bytes in each clone."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    pictures = [ROOT / name for name in re.findall(r'<img src="(examples/[^"]+)"', text)]
    assert len(pictures) == 6
    assert all(Image.open(path).size == (1200, 800) for path in pictures)
    sizes = [path.stat().st_size for path in pictures]
    assert max(sizes) <= 180e3
    assert sum(sizes) <= 900e3


def test_library_page_counts_what_is_there(nacre):
    media = json.loads(nacre.ok("library", "list", "--json"))
    text = (ROOT / "cpp_tools/doc/library.md").read_text(encoding="utf-8")
    assert f"carries {sum(entry['range_nm'] is not None for entry in media)} optical" in text
    counted = Counter(tag for entry in media for tag in entry["tags"])
    assert dict(re.findall(r"`(\w+)` \| (\d+)", text)) == {
        tag: str(count) for tag, count in counted.items()
    }


def test_library_page_counts_the_spectra(nacre):
    spectra = json.loads(nacre.ok("library", "list", "--kind", "spectra", "--json"))
    text = (ROOT / "cpp_tools/doc/library.md").read_text(encoding="utf-8")
    assert f"{len(spectra)} named spectra" in text
    counted = Counter(entry["key"].split("/")[0] for entry in spectra)
    families = dict(re.findall(r"^\| `([\w.]+)/` \| (\d+) \| [a-z]+ \|", text, re.MULTILINE))
    assert families == {family: str(count) for family, count in counted.items()}


def names_of_interfaces(column: int) -> set[str]:
    """In one column of the table that puts tool, Python and C side by side."""
    text = (ROOT / "cpp_tools/doc/interfaces.md").read_text(encoding="utf-8")
    rows = [row.split("|") for row in text.splitlines() if row.startswith("|")][2:]
    return {name for row in rows for name in re.findall(r"`([^`]+)`", row[column])}


def test_interfaces_page_has_every_function_of_c():
    headers = ROOT / "cpp_tools" / "include" / "nacre"
    declared = {
        name
        for header in (headers / "capi.h", *(headers / "capi").glob("*.h"))
        for name in re.findall(
            r"\b(nacre_\w+)\(", re.sub(r"/\*.*?\*/", "", header.read_text(), flags=re.S)
        )
    }
    assert names_of_interfaces(4) == declared


def test_interfaces_page_has_every_function_of_python():
    import nacre

    def functions(module, prefix=""):
        return {
            prefix + name
            for name, value in vars(module).items()
            if callable(value)
            and not isinstance(value, type)
            and not name.startswith("_")
            and value.__module__.startswith("nacre")
            and (prefix == "" or value.__module__ == module.__name__)
        }

    expected = (
        functions(nacre)
        | functions(nacre.develop, "develop.")
        | functions(nacre.library, "library.")
        | functions(nacre.shapes, "shapes.")
        | functions(nacre.textures, "textures.")
    )
    named = names_of_interfaces(3) - {"FilmLut", "CompiledMaterial", "NacreError", "__version__"}
    methods = {name for name in named if re.fullmatch(r"(library\.)?[A-Z]\w+\.\w+", name)}
    assert all(callable(operator.attrgetter(name)(nacre)) for name in methods)
    arguments = {name for name in named if name.endswith("=")}
    taken = {
        f"{argument}="
        for name in expected
        for argument in inspect.signature(operator.attrgetter(name)(nacre)).parameters
    }
    assert arguments <= taken
    assert named - methods - arguments == expected


def test_interfaces_page_has_every_command_that_computes(nacre):
    named = names_of_interfaces(2)
    for command in ("eval", "bake"):
        listed = re.findall(r"^  (\w+) {4,}", nacre.ok(command, "--help"), re.MULTILINE)
        assert listed
        assert {f"{command} {name}" for name in listed} <= named
