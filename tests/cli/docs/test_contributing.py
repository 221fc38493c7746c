# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What CONTRIBUTING tells one to write works, and is all that there is to do: its files and lines go into a
copy of the sources, where a new kind, command, stage and shader are built and run.

    <!-- file: PATH -->   the block is a new file
    <!-- edit: PATH -->   a context line and the line that goes below it, as a diff has them
"""

from __future__ import annotations

import json
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from support.images import read_image
from support.paths import ROOT

pytestmark = pytest.mark.xdist_group("contributing")

TEXT = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
SECTIONS = {
    match["what"]: match["text"]
    for match in re.finditer(
        r"^## How to add a (?P<what>\w+)[^\n]*\n(?P<text>.*?)(?=^## )", TEXT, re.M | re.S
    )
}
FILE = re.compile(r"<!-- file: (\S+) -->\n```\w+\n(.*?)```", re.S)
EDIT = re.compile(r"<!-- edit: (\S+) -->\n```diff\n (.*?)\n\+(.*?)\n```", re.S)

# Beside these: tests, and the picture of a material.
MOST = {"kind": (8, 3), "command": (2, 1), "stage": (2, 1), "shader": (2, 1)}


def walk(what: str, copy: Path) -> list[Path]:
    """Does in a copy of the checkout what the section says; returns the new files."""
    made = []
    for name, text in FILE.findall(SECTIONS[what]):
        file = copy / name
        assert not file.exists()
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, "utf-8")
        made.append(file)
    for name, context, line in EDIT.findall(SECTIONS[what]):
        before = (copy / name).read_text("utf-8")
        assert before.count(f"{context}\n") == 1, f"{name}: {context}"
        (copy / name).write_text(before.replace(f"{context}\n", f"{context}\n{line}\n"), "utf-8")
    return made


@pytest.mark.parametrize("what", MOST)
def test_little_is_to_be_done(what):
    files, edits = MOST[what]
    materials = 2 if what == "kind" else what == "shader"  # a test, a picture
    assert 1 <= len(FILE.findall(SECTIONS[what])) + materials <= files
    assert 1 <= len(EDIT.findall(SECTIONS[what])) <= edits


def commands_of(build: Path) -> list[str]:
    """What ninja runs for the tool, the link last."""
    listed = subprocess.run(
        ["ninja", "-C", build, "-t", "commands", "bin/nacre"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return [line.removeprefix(": && ").removesuffix(" && :") for line in listed.stdout.splitlines()]


def _compiled_together(source: Path) -> list[str]:
    """What a source of CMake's own includes; else the source itself."""
    if source.parent.name != "Unity":
        return [str(source)]
    return re.findall(r'^#include "(.+)"$', source.read_text("utf-8"), re.M)


class Overlay:
    """A build of the tool, where the copy takes the place of some folders of sources."""

    def __init__(self, build: Path, copy: Path, scratch: Path) -> None:
        self.build, self.copy, self.scratch = build, copy, scratch
        self.commands = commands_of(build)

    def compiled(self, name: str, folder: str, new: list[Path]) -> tuple[str, Path]:
        """The object that has this source of the folder in it, and the same of the copy with new sources."""
        words, source = next(
            (words, source)
            for words in map(shlex.split, self.commands)
            if "-c" in words
            for source in [Path(words[words.index("-c") + 1])]
            if str(ROOT / folder / name) in _compiled_together(source)
        )
        theirs, ours = str(ROOT / folder), str(self.copy / folder)
        copied = [path.replace(theirs, ours) for path in _compiled_together(source)]
        unity = self.scratch / f"{Path(name).stem}_copy.cpp"
        unity.write_text("".join(f'#include "{file}"\n' for file in [*copied, *new]), "utf-8")
        made = unity.with_suffix(".o")
        options = [word.replace(theirs, ours) for word in words[: words.index("-MD")]]
        subprocess.run([*options, "-O0", "-o", made, "-c", unity], cwd=self.build, check=True)
        return words[words.index("-o") + 1], made

    def linked(self, replaced: list[tuple[str, Path]]) -> Path:
        tool = self.scratch / "bin" / "nacre"
        tool.parent.mkdir()
        words = shlex.split(self.commands[-1])
        words[words.index("-o") + 1] = str(tool)
        words = words[: words.index("&&")] if "&&" in words else words
        instead = {was: str(made) for was, made in replaced}
        words = [instead.pop(word, word) for word in words]
        # Objects come before libraries, which then are not asked for what these have.
        first = words.index("-o")
        words[first:first] = instead.values()
        subprocess.run(words, cwd=self.build, check=True)
        return tool


@pytest.fixture(scope="module")
def copy(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("copy")
    for name in ("cpp_tools/src/kinds", "cpp_tools/apps/nacre", "cpp_tools/doc", "addon"):
        shutil.copytree(
            ROOT / name, folder / name, ignore=shutil.ignore_patterns("*.pyc", "wheels")
        )
    return folder


@pytest.fixture(scope="module")
def build(nacre) -> Path:
    """Of the tool that is tested; one that was installed has none."""
    folder = nacre.program.parent.parent
    if not (folder / "build.ninja").is_file() or shutil.which("ninja") is None:
        pytest.skip("the tool is not in its build tree")
    return folder


@pytest.fixture(scope="module")
def tool(build, copy, tmp_path_factory) -> Path:
    """With the new kind and the new command in it."""
    overlay = Overlay(build, copy, tmp_path_factory.mktemp("overlay"))
    kind = [file for file in walk("kind", copy) if file.suffix == ".cpp"]
    command = walk("command", copy)
    return overlay.linked(
        [
            overlay.compiled("read_template.cpp", "cpp_tools/src/kinds", kind),
            overlay.compiled("commands.cpp", "cpp_tools/apps/nacre", command),
        ]
    )


def run(*words: object) -> str:
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_kind_and_command(tool, copy, nacre, tmp_path):
    ids = nacre.ok("library", "list", "--kind", "templates").split()
    assert run(tool, "library", "count") == f"{len(ids)}\n"
    assert "nacre library count" in run(tool, "library", "count", "--help")
    run(tool, "compile", copy / "osl/templates/glow_worm.toml", "-o", tmp_path)
    manifest = json.loads((tmp_path / "glow_worm" / "glow_worm.json").read_text("utf-8"))
    assert manifest["kind"] == "glow"
    assert [socket["name"] for socket in manifest["sockets"]] == ["power", "normal"]
    assert manifest["traits"]["closures"] == [{"output": "BSDF", "role": "emission"}]
    assert all(manifest["graphs"].values())
    schema = json.loads(run(tool, "library", "schema"))
    assert {"required": ["glow"]} in schema["oneOf"]
    assert set(schema["properties"]["glow"]["properties"]) == {"power", "focus"}
    (tmp_path / "wrong.toml").write_text(
        (copy / "osl/templates/glow_worm.toml")
        .read_text("utf-8")
        .replace("focus = 3", "focus = -3"),
        "utf-8",
    )
    refused = subprocess.run(
        [tool, "library", "check", tmp_path / "wrong.toml"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert refused.returncode == 1
    assert "wrong.toml:13: glow.focus: must be in [0, 100] (got -3)" in refused.stderr


def render(blender, copy: Path, picture: Path, *words: object) -> np.ndarray:
    """By the copy's extension."""
    driver = copy / "addon" / "background" / "driver.py"
    done = blender.process(
        driver, "render", *words, "--size", "16x16", "--samples", "4", "--quiet", "-o", picture
    )
    assert done.returncode == 0, done.stderr
    return read_image(picture)


@pytest.fixture
def blender(blenders, tmp_path):
    found = blenders.get("4.5", tmp_path)
    if found is None:
        pytest.skip("NACRE_BPY45 names no Python with bpy 4.5")
    return found


def test_stage(blender, copy, tmp_path):
    walk("stage", copy)
    shown = blender.process(copy / "addon/background/driver.py", "render", "--help").stdout
    assert "portrait, hall" in " ".join(shown.split())
    picture = render(
        blender, copy, tmp_path / "hall.exr", "--material", "soap_film", "--stage", "hall"
    )
    assert picture.max() > 0.0


def test_kind_in_blender(tool, blender, copy, tmp_path):
    run(tool, "compile", copy / "osl/templates/glow_worm.toml", "-o", tmp_path)
    for form in ("osl", "nodes"):
        picture = render(
            blender, copy, tmp_path / f"{form}.exr",
            "--compiled", tmp_path / "glow_worm", "--set", "power=4", "--form", form,
        )  # fmt: skip
        assert picture.max() > 2.0


def test_shader(nacre, blender, copy, tmp_path):
    (shader,) = walk("shader", copy)
    nacre.ok("compile", shader, "-o", tmp_path)
    manifest = json.loads((tmp_path / "dusk" / "dusk.json").read_text("utf-8"))
    assert [socket["name"] for socket in manifest["sockets"]] == ["tint", "roughness", "normal"]
    picture = render(
        blender, copy, tmp_path / "dusk.exr",
        "--compiled", tmp_path / "dusk", "--set", "tint=0.9,0.5,0.3", "--stage", "furnace",
    )  # fmt: skip
    np.testing.assert_allclose(picture[8, 8], (0.9, 0.5, 0.3), atol=2e-3)
