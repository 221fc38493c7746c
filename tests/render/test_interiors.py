# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""White furnace for films on clear glass and over a matt base: no light is lost or made."""

from __future__ import annotations

import numpy as np
import pytest
from harness import nacre
from truth import pixel_cosines

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
CASES = [(name, form) for name in SURFACES for form in ("osl", "nodes")]


@pytest.fixture(scope="module")
def pictures(blender, tmp_path_factory):
    folder = tmp_path_factory.mktemp("interiors")
    files = []
    for name, surface in SURFACES.items():
        files.append(folder / f"{name}.toml")
        files[-1].write_text(TEMPLATE.format(name=name, surface=surface), "utf-8")
    nacre("compile", *files, "-o", folder, "--quiet")
    jobs = [
        {
            "material": name,
            "form": form,
            "values": {"roughness": 0.0},
            "lit": "all",
            "size": SIZE,
            "samples": SAMPLES[name],
        }
        for name, form in CASES
    ]
    rendered = blender.run("furnace_worker.py", jobs, folder)
    return dict(zip(CASES, rendered, strict=True))


@pytest.mark.parametrize(("name", "form"), [case for case in CASES if case[0] != "grey"])
def test_white_stays_white(pictures, name, form):
    _, counted = pixel_cosines(SIZE)
    picture = pictures[name, form][counted]
    print(f"mean {picture.mean():.5f}, {picture.min():.4f} … {picture.max():.4f}")
    assert picture.max() <= 1 + 1e-3 if name == "matt" else picture.mean() <= 1 + 1e-3
    np.testing.assert_allclose(picture.mean(), 1.0, atol=1e-3)


@pytest.mark.parametrize("form", ["osl", "nodes"])
def test_grey_base_absorbs(pictures, form):
    _, counted = pixel_cosines(SIZE)
    picture = pictures["grey", form][counted]
    assert 0.2 < picture.mean() < 0.8
