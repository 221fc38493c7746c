# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films on clear glass and over a matt base: no light is lost or made, and what is seen from inside."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest

from support.colours import delta_e
from support.representatives import FORMS
from support.shared import made_once
from support.tool import nacre
from support.truth import colour, pixel_cosines, spectra

TEMPLATE = """\
schema = 1
[material]
id = "{name}"
name = "{name}"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
n = 2.2
thickness_nm = {{ default = 150, min = 50, max = 300, varies = true }}
[substrate]
n = 1.5
[surface]
{surface}
"""
SURFACES = {
    "matt": "diffuse_base = [1, 1, 1]",
    "grey": "diffuse_base = [0.5, 0.5, 0.5]",
    "solid": "transmission = true",
}
SIZE = 24
SAMPLES = {"matt": 4096, "grey": 4096, "solid": 1024}
CASES = [(name, form) for name in SURFACES for form in FORMS]


@pytest.fixture(scope="module")
def pictures(blender, tmp_path_factory):
    def make(folder: Path) -> None:
        files = []
        for name, surface in SURFACES.items():
            files.append(folder / f"{name}.toml")
            files[-1].write_text(TEMPLATE.format(name=name, surface=surface), "utf-8")
        nacre("compile", *files, "-o", folder, "--quiet")

    folder = made_once(tmp_path_factory, "interiors", make)

    def job(name: str, form: str) -> dict:
        return {
            "material": name,
            "form": form,
            "values": {"roughness": 0.0},
            "lit": "all",
            "size": SIZE,
            "samples": SAMPLES[name],
        }

    return blender.pictures("furnace.render", job, folder)


@pytest.mark.parametrize(("name", "form"), [case for case in CASES if case[0] != "grey"])
def test_white_stays_white(pictures, name, form):
    _, counted = pixel_cosines(SIZE)
    picture = pictures(name, form)[counted]
    print(f"mean {picture.mean():.5f}, {picture.min():.4f} … {picture.max():.4f}")
    assert picture.max() <= 1 + 1e-3 if name == "matt" else picture.mean() <= 1 + 1e-3
    np.testing.assert_allclose(picture.mean(), 1.0, atol=1e-3)


@pytest.mark.parametrize("form", FORMS)
def test_grey_base_absorbs(pictures, form):
    _, counted = pixel_cosines(SIZE)
    picture = pictures("grey", form)[counted]
    assert 0.2 < picture.mean() < 0.8


# Oil between water and air, as a fish sees it: beyond 48.6 degrees all light comes back.
FISH = (
    TEMPLATE.format(name="fish", surface="transmission = true")
    .replace(
        "n = 2.2\nthickness_nm = { default = 150, min = 50, max = 300, varies = true }",
        "n = 1.47\nthickness_nm = { default = 300, min = 100, max = 600, varies = true }",
    )
    .replace("[substrate]\nn = 1.5", "[substrate]\nn = 1.333")
)
INSIDE_DEG = (0.0, 25.0, 40.0, 46.0, 52.0, 70.0)


@pytest.fixture(scope="module")
def from_inside(blender, tmp_path_factory):
    def make(folder: Path) -> None:
        (folder / "fish.toml").write_text(FISH, "utf-8")
        nacre("compile", folder / "fish.toml", "-o", folder, "--quiet")

    folder = made_once(tmp_path_factory, "inside", make)

    def job(form: str, deg: float) -> dict:
        return {
            "material": "fish",
            "form": form,
            "values": {"roughness": 0.0},
            "lit": "reflected",
            "inside_deg": deg,
            "size": 8,
            "samples": 16384,
        }

    return blender.pictures("furnace.render", job, folder)


@pytest.mark.parametrize("deg", INSIDE_DEG)
@pytest.mark.parametrize("form", FORMS)
def test_film_seen_from_inside(from_inside, form, deg, record_property):
    seen = from_inside(form, deg).reshape(-1, 3).mean(axis=0)
    cosines = np.cos(np.radians([deg]))
    expected = colour(spectra(tomllib.loads(FISH), 300.0, cosines, from_below=True).R)[0]
    error = float(delta_e(seen[None], expected[None])[0])
    record_property("dE00", f"{error:.4f}")
    print(f"{deg} deg: seen {seen}, expected {expected}, dE00 {error:.4f}")
    assert error <= 0.1
