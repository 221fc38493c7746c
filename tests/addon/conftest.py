# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Blenders that have the extension's folder, and for each test a user folder and materials."""

from __future__ import annotations

import importlib
import importlib.util
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from blender.harness import Blender
from support.paths import ADDON, FIXTURES, STAGE_EXTENSION, TEMPLATES, materials_folder
from support.tool import nacre

INSIDE = Path(__file__).resolve().parent / "inside"
SHARED = INSIDE.parents[1] / "blender"


def _load_extension():
    """As far as it works without Blender, which is out of reach here, though the environment has it."""
    sys.modules["bpy"] = None
    spec = importlib.util.spec_from_file_location(
        "nacre_driver", ADDON / "background" / "driver.py"
    )
    driver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(driver)
    return driver.load_package()


_load_extension()


class ExtensionBlender(Blender):
    """`folder` is the test's own: what is found there was left by what it tests."""

    def script(self, name: str, *arguments: object) -> str:
        """Runs inside/FAMILY/NAME.py, whose own asserts decide; returns what it printed."""
        return super().script(INSIDE / f"{name}.py", *arguments)

    def script_process(self, name: str, *arguments: object) -> None:
        """The same in a process of its own, which finds what scripts share."""
        own = self.with_environment(PYTHONPATH=str(SHARED))
        done = own.process(INSIDE / f"{name}.py", *arguments)
        assert done.returncode == 0, f"{done.stdout[-4000:]}\n{done.stderr[-8000:]}"

    def with_materials(self, *names: str) -> ExtensionBlender:
        """With these materials alone, as they were built."""
        library = self.folder / "library"
        library.mkdir()
        for name in names:
            (library / name).symlink_to(materials_folder().absolute() / name)
        return self.with_environment(NACRE_MATERIALS=str(library))


def _own(shared: Blender, folder: Path) -> ExtensionBlender:
    user = folder / "user"
    user.mkdir()
    environment = {"BLENDER_USER_RESOURCES": str(user), "NACRE_MATERIALS": str(FIXTURES)}
    return ExtensionBlender(shared.version, shared.python, shared.server, folder, environment)


@pytest.fixture
def blender(blender, tmp_path) -> ExtensionBlender:
    return _own(blender, tmp_path)


@pytest.fixture
def blender45(blenders, tmp_path) -> ExtensionBlender:
    """For what does not depend on the version."""
    shared = blenders.get("4.5", tmp_path)
    if shared is None:
        pytest.skip("NACRE_BPY45 names no Python with bpy 4.5")
    return _own(shared, tmp_path)


@pytest.fixture(scope="session")
def thin_slick(tmp_path_factory) -> str:
    """A library of `oil_on_water` alone, up to 200 nm and not 1200: its tables are smaller, so that
    each edit of its stack compiles in a third of the time."""
    folder = tmp_path_factory.mktemp("slick")
    text, _, _ = (TEMPLATES / "oil_on_water.toml").read_text("utf-8").partition("\n[look]")
    whole = "default = 450, min = 0, max = 1200"
    assert whole in text
    template = folder / "oil_on_water.toml"
    template.write_text(text.replace(whole, "default = 150, min = 0, max = 200"), "utf-8")
    nacre("compile", template, "--quiet", "-o", folder / "library")
    return str(folder / "library")


@pytest.fixture(scope="session")
def sodium_slick(thin_slick, tmp_path_factory) -> str:
    """The same under a lamp that no menu offers, whose colour is in the tables."""
    folder = tmp_path_factory.mktemp("sodium")
    template = Path(thin_slick).parent / "oil_on_water.toml"
    light = ("--illuminant", "lamp/hps", "--cat", "none", "--observer", "cie1964")
    nacre("compile", template, "--quiet", *light, "-o", folder / "library")
    return str(folder / "library")


@pytest.fixture(scope="session")
def archive(blenders, tmp_path_factory) -> Path:
    """The extension with the fixtures as its materials and without a wheel."""
    folder = tmp_path_factory.mktemp("archive")
    shared = blenders.get("4.5", folder)
    if shared is None:
        pytest.skip("NACRE_BPY45 names no Python with bpy 4.5")
    path = folder / "nacre.zip"
    done = subprocess.run(
        [sys.executable, STAGE_EXTENSION, "--blender-ext", shared.blender_ext,
         "--materials", FIXTURES, "-o", path],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return path


@pytest.fixture
def film():
    """A compiled material; without Blender, as the two below."""
    return _manifests().load_folder(FIXTURES / "test_film")


@pytest.fixture
def grating():
    return _manifests().load_folder(FIXTURES / "test_grating")


@pytest.fixture
def edited(tmp_path):
    """Loads the film after a change to its manifest."""

    def load(change):
        folder = tmp_path / "test_film"
        shutil.copytree(FIXTURES / "test_film", folder)
        path = folder / "test_film.json"
        data = json.loads(path.read_text("utf-8"))
        change(data)
        path.write_text(json.dumps(data), "utf-8")
        return _manifests().load_folder(folder)

    return load


def _manifests():
    return importlib.import_module("nacre_extension.core.manifest")
