# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films of every kind, thin, as they are and thick, on the furnace sphere against the exact
spectrum: the stacks of stacks.toml, compiled at the default tolerance."""

from __future__ import annotations

import json
import tomllib
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from harness import HERE, delta_e, nacre
from truth import exact_colours, pixel_cosines

STACKS = tomllib.loads((HERE / "stacks.toml").read_text("utf-8"))
SCALES = (0.2, 1.0, 2.0)
FORMS = ("osl", "nodes")
SIZE = 40
# ΔE00 over the pixels of a sphere.
MEAN, LARGEST = 0.01, 0.1
# A channel this far below 0 is cut by the node form, which then cannot be right.
IN_GAMUT = -1e-4


def template(name: str) -> dict:
    """As the template of a material would be read."""
    return {
        "schema": 1,
        "material": {
            "id": name,
            "name": name,
            "category": "Tests",
            "description": "Stack for a test",
            "source": "stacks.toml",
        },
        "ambient": STACKS[name].get("ambient", {"medium": "air"}),
        "layer": STACKS[name]["layers"],
        "substrate": STACKS[name]["substrate"],
        "stack": {"scale": {"default": 1.0, "min": min(SCALES), "max": max(SCALES)}},
    }


def toml(value) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


@pytest.fixture(scope="session")
def compiled(tmp_path_factory) -> Path:
    """The stacks as compiled materials."""
    folder = tmp_path_factory.mktemp("stacks")
    files = []
    for name in STACKS:
        file = folder / f"{name}.toml"
        file.write_text("".join(f"{key} = {toml(item)}\n" for key, item in template(name).items()))
        files.append(file)
    nacre("compile", *files, "-o", folder / "materials", "--quiet")
    return folder / "materials"


@pytest.fixture(scope="module")
def furnaces(blender, compiled) -> dict:
    """Pictures by (stack, scale, form)."""
    cases = [(name, scale, form) for name in STACKS for scale in SCALES for form in FORMS]
    jobs = [
        {
            "material": name,
            "values": {"roughness": 0.0, "thickness_scale": scale},
            "form": form,
            "lit": "all",
            "size": SIZE,
            "samples": 1,
        }
        for name, scale, form in cases
    ]
    pictures = blender.run("furnace_worker.py", jobs, compiled)
    return dict(zip(cases, pictures, strict=True))


@lru_cache
def exact(name: str, scale: float) -> np.ndarray:
    """Colours of the pixels that count."""
    cosines, counted = pixel_cosines(SIZE)
    distinct, inverse = np.unique(np.round(cosines[counted], 12), return_inverse=True)
    return exact_colours(template(name), scale, distinct)["R"][inverse]


def test_there_are_enough_stacks():
    assert len(STACKS) >= 16


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("name", STACKS)
def test_sphere(furnaces, name, scale, form, record_property):
    _, counted = pixel_cosines(SIZE)
    picture, expected = furnaces[name, scale, form][counted], exact(name, scale)
    if form == "nodes":
        inside = expected.min(axis=1) > IN_GAMUT
        picture, expected = picture[inside], expected[inside]
        if not len(picture):
            pytest.skip("every colour is outside the gamut")
    errors = delta_e(picture, expected)
    said = f"mean {errors.mean():.4f}, max {errors.max():.4f} of {errors.size} pixels"
    record_property("dE00", said)
    print("dE00", said)
    assert errors.mean() <= MEAN
    assert errors.max() <= LARGEST
