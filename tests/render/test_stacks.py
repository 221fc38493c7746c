# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films of every kind, thin, as they are and thick, on the furnace sphere against the exact
spectrum: the stacks of stacks.toml, compiled at the default tolerance."""

from __future__ import annotations

import tomllib
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest

from support.colours import delta_e
from support.representatives import FORMS
from support.shared import compiled_once
from support.truth import exact_colours, pixel_cosines

STACKS = tomllib.loads(Path(__file__).with_name("stacks.toml").read_text("utf-8"))
SCALES = (0.2, 1.0, 2.0)
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


@pytest.fixture(scope="session")
def compiled(tmp_path_factory) -> Path:
    """The stacks as compiled materials: two minutes of one core."""
    return compiled_once(tmp_path_factory, "stacks", {name: template(name) for name in STACKS})


@pytest.fixture(scope="module")
def furnaces(blender, compiled):
    def job(name: str, scale: float, form: str) -> dict:
        return {
            "material": name,
            "values": {"roughness": 0.0, "thickness_scale": scale},
            "form": form,
            "lit": "all",
            "size": SIZE,
            "samples": 1,
        }

    return blender.pictures("furnace.render", job, compiled)


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
    picture, expected = furnaces(name, scale, form)[counted], exact(name, scale)
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
