# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Every example of every `--help` runs, in a folder that has what it names; each command has one."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from support.paths import ROOT, TEMPLATES, tool
from support.spectral_picture import shop
from support.typed import examples, run

CORPUS = ROOT / "cpp_tools" / "fuzz" / "corpus"
MINE = """schema = 1
material = { id = "my_film", name = "My Film", category = "Films", source = "an example" }
layer = [{ n = 2.0, thickness_nm = { default = 320, min = 300, max = 340, varies = true } }]
ambient = { medium = "air" }
substrate = { n = 1.5, k = 3.0 }
"""
FILES = {
    "my_film.toml": MINE,
    "film.json": {"ambient": {"n": 1.0}, "layer": [{"n": 1.33, "thickness_nm": 300}], "substrate": {"n": 1.0}},
    "stack.json": {"n": [1, 1.33, 1], "d_nm": [300], "angle_deg": 0, "wavelength_nm": 550, "pol": "u"},
    "stacks.json": [{"n": [1, 1.5], "d_nm": [], "angle_deg": 0, "wavelength_nm": 550, "pol": "s"}],
    "chips.json": [{"spectrum": "colorchecker/red"}, {"spectrum": "colorchecker/blue"}],
    "config.ocio": (ROOT / "tests/support/studio.ocio").read_text("utf-8").replace("Working", "ACEScg"),
    "my_glass.yml": (CORPUS / "yaml" / "formula_and_k.yml").read_text("utf-8"),
    "my_chart.cgats": (CORPUS / "cgats" / "chart.cgats").read_text("utf-8"),
    "chart.cgats": (CORPUS / "cgats" / "chart.cgats").read_text("utf-8"),
    "lamp.spdx": (CORPUS / "spdx" / "lamp.spdx").read_text("utf-8"),
    "film.csv": "wavelength_nm,n,k\n350,1.5,0\n850,1.46,0\n",
    "Au.eta.spd": "380 1.4\n760 0.2\n",
    "looks.csv": "output,material,thickness_nm\nthin.png,soap_film,100\nthick.png,soap_film,700\n",
    "Au.k.spd": "380 1.9\n760 4.3\n",
}  # fmt: skip
IMAGES = {
    "soap_film.exr": ("stack", "film.json", "--size", "4x1"),
    "lights.png": ("lights", "D65", "A"),
    "new.exr": ("cmf",),
    "reference.exr": ("cmf",),
}
# Examples of pictures are made as small as they can be.
SMALL = " --size 8x8 --samples 1"


@cache
def help_of(*command: str) -> str:
    done = subprocess.run(
        [tool(), *command, "--help"], capture_output=True, text=True, check=True
    )  # fmt: skip
    return done.stdout


def commands(*command: str) -> list[tuple[str, ...]]:
    """This one and all below it."""
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", help_of(*command), re.MULTILINE)
    names = re.findall(r"^  (\w+)", listed[1], re.MULTILINE) if listed else []
    return [command, *(found for name in names for found in commands(*command, name))]


COMMANDS = commands() if tool().is_file() else []


@pytest.fixture(scope="session")
def inputs(nacre, tmp_path_factory) -> Path:
    """A folder that has what the examples name."""
    folder = tmp_path_factory.mktemp("inputs")
    for name, content in FILES.items():
        text = content if isinstance(content, str) else json.dumps(content)
        (folder / name).write_text(text, "utf-8")
    (folder / "osl" / "templates").mkdir(parents=True)
    for name in ("soap_film", "tempered_steel"):
        text = (TEMPLATES / f"{name}.toml").read_text("utf-8")
        # A thinner film has a smaller table.
        text = re.sub(
            r"default = \d+, min = \d+, max = \d+", "default = 40, min = 20, max = 60", text
        )
        (folder / "osl" / "templates" / f"{name}.toml").write_text(text, "utf-8")
    for name, arguments in IMAGES.items():
        nacre.ok("bake", *arguments, "-o", name, cwd=folder)
    shop(folder / "shop.exr")
    return folder


# Those of `render` run in tests/addon/test_examples.py.
@pytest.mark.parametrize("command", [c for c in COMMANDS if c != ("render",)], ids=" ".join)
def test_every_example_runs(nacre, inputs, tmp_path, command):
    """In the order in which they stand: one may use what another has made."""
    own = [
        text for text in examples(help_of(*command)) if f"nacre {' '.join(command)}".strip() in text
    ]
    assert own, f"nacre {' '.join(command)} --help has no example of its own"
    folder = tmp_path / "folder"
    shutil.copytree(inputs, folder)
    for text in examples(help_of(*command)):
        renders = "nacre render" in text
        if renders and not any(os.environ.get(name) for name in ("NACRE_PYTHON", "NACRE_BPY45")):
            pytest.skip("needs a Blender")
        run("sh", text + SMALL if renders else text, folder, nacre.program)


def test_help_of_render_is_that_of_its_options():
    """Python words help otherwise from one version to the next: that of Blender 4.5 it is."""
    python = os.environ.get("NACRE_BPY45")
    if not python:
        pytest.skip("NACRE_BPY45 names no Python with bpy 4.5")
    written = subprocess.run(
        [python, ROOT / "cpp_tools/generators/write_render_help.py"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert help_of("render") == written.stdout


def test_all_commands_are_found():
    assert {("eval", "stack"), ("library", "schema"), ("export", "mitsuba"), ("render",)} <= set(
        COMMANDS
    )
