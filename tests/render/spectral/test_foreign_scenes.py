# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes that nobody here made go through *Make Spectral*, bands and back."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile

import numpy as np
import pytest

from support.images import read_image
from support.spectral import delta_e_of_parts

SIZE = 64
SAMPLES = 64
OWN = [("template", "Sculpting"), ("template", "VFX"), ("template", "2D_Animation"),
       ("hair", "Generate Hair Curves")]  # fmt: skip
GLTF = ("Duck.glb", "Fox.gltf")
_WHEEL = "gradio==6.31.0"
"""A package on PyPI that has two of Khronos's samples in it."""


@pytest.fixture(scope="session")
def samples(tmp_path_factory):
    """Folder of glTF files by others."""
    folder = tmp_path_factory.mktemp("gltf")
    command = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", folder, _WHEEL]
    if subprocess.run(command, capture_output=True, check=False).returncode:
        pytest.skip(f"{_WHEEL} cannot be had, which has glTF files by others in it")
    (wheel,) = folder.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if name.endswith(GLTF):
                (folder / name.rpartition("/")[2]).write_bytes(archive.read(name))
    return folder


def there_and_back(blender, kind, what):
    """The same picture where nothing is rendered in bands, and hardly another in bands: under daylight both
    have the same colours, but where light goes through several of them in turn."""
    said = blender.call(
        "spectral.foreign.there_and_back",
        kind=kind, what=str(what), folder=str(blender.folder), size=SIZE, samples=SAMPLES, triples=8,
    )  # fmt: skip
    pictures = [
        read_image(blender.folder / f"{name}.exr")[..., :3]
        for name in ("before", "rgb", "after", "bands", "again")
    ]
    before, rgb, after, bands, again = pictures
    np.testing.assert_array_equal(rgb, before)
    np.testing.assert_array_equal(after, before)
    assert said["spectra"] == said["removed"] > 0
    assert not said["left"]
    noise = delta_e_of_parts(again, before)
    assert delta_e_of_parts(bands, before) < 0.5 * noise + 0.3
    return said


@pytest.mark.parametrize(("kind", "what"), OWN)
def test_what_blender_brings_with_it(blender, kind, what):
    said = there_and_back(blender, kind, what)
    drawings = [where for where, text in said["remarks"] if "drawing" in text]
    assert bool(drawings) == (what == "2D_Animation")


@pytest.mark.skipif(not os.environ.get("NACRE_SOAK"), reason="downloads a package; NACRE_SOAK=1")
@pytest.mark.parametrize("name", GLTF)
def test_gltf(blender, samples, name):
    assert not there_and_back(blender, "gltf", samples / name)["remarks"]
