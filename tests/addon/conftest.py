# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs scripts inside Blender: the bpy wheels named by NACRE_BPY45 and NACRE_BPY52 (Python programs)."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FIXTURES = HERE / "fixtures"
PACKAGE = ROOT / "cpp_tools" / "python"
LINES = {"4.5": "NACRE_BPY45", "5.2": "NACRE_BPY52"}

sys.path.insert(0, str(PACKAGE))


def _load_extension():
    spec = importlib.util.spec_from_file_location("nacre_driver", ROOT / "addon" / "driver.py")
    driver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(driver)
    return driver.load_package("nacre_extension")


_load_extension()


class Blender:
    """One line of Blender, each run in a process and a user folder of its own."""

    def __init__(self, python: str, scratch: Path):
        self.python = python
        self.environment = {
            **os.environ,
            "BLENDER_USER_RESOURCES": str(scratch / "user"),
            "NACRE_MATERIALS": str(FIXTURES),
            "PYTHONWARNINGS": "ignore",
            # The extension's wheel brings the package where it is installed.
            "PYTHONPATH": str(PACKAGE),
        }
        (scratch / "user").mkdir(parents=True, exist_ok=True)

    def command(self, *arguments: object) -> list[str]:
        return [self.python, *map(str, arguments)]

    def run(self, *arguments: object, **options) -> subprocess.CompletedProcess:
        return subprocess.run(
            self.command(*arguments), env=self.environment, capture_output=True, text=True,
            timeout=600, check=False, **options,
        )  # fmt: skip

    def script(self, name: str, *arguments: object) -> str:
        """Runs tests/addon/inside/NAME.py, whose own asserts decide; returns what it printed."""
        done = self.run(HERE / "inside" / f"{name}.py", ROOT / "addon", *arguments)
        assert done.returncode == 0, f"{done.stdout[-4000:]}\n{done.stderr[-8000:]}"
        return done.stdout

    def render(self, *arguments: object) -> subprocess.CompletedProcess:
        return self.run(ROOT / "addon" / "driver.py", "render", *arguments)

    @property
    def blender_ext(self) -> str:
        find = "import bpy; print(bpy.utils.system_resource('SCRIPTS'))"
        scripts = self.run("-c", find).stdout.strip().splitlines()[-1]
        return str(Path(scripts, "addons_core", "bl_pkg", "cli", "blender_ext.py"))


@pytest.fixture(params=LINES)
def blender(request, tmp_path) -> Blender:
    python = os.environ.get(LINES[request.param])
    if not python:
        pytest.skip(f"{LINES[request.param]} names no Python with bpy {request.param}")
    return Blender(python, tmp_path)


@pytest.fixture
def blender45(tmp_path) -> Blender:
    return Blender(os.environ.get("NACRE_BPY45", sys.executable), tmp_path)


@pytest.fixture
def library(tmp_path):
    """A folder with these materials, compiled by the tool that NACRE names."""

    def compile_into(*names: str) -> Path:
        templates = [ROOT / "osl" / "templates" / f"{name}.toml" for name in names]
        tool = os.environ.get("NACRE", ROOT / "build" / "release" / "bin" / "nacre")
        folder = tmp_path / "library"
        subprocess.run([tool, "compile", *templates, "--quiet", "-o", folder], check=True)
        return folder

    return compile_into
