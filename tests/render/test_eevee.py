# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films as nodes in EEVEE against the exact spectrum, on a display that nobody sees.

The wheels of Blender render with EEVEE under Xvfb with Mesa's drivers in software. Compiling the
shaders takes most of the time: one picture a version holds all spheres.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from support.colours import delta_e
from support.paths import manifest
from support.representatives import chosen, films, representatives
from support.stored_truth import RoughFilm, stored_colours
from support.truth import exact_colours, layers_of, material_template, pixel_cosines, varied

# EEVEE reads textures through mip maps, which blur a table along its thickness too where a sphere is
# small: mean ΔE00 of up to 4 at 32 pixels, 1.7 at 64.
SIZE, COLUMNS = 96, 6
# Without the rim, where a pixel sees past the sphere.
COSINES, COUNTED = pixel_cosines(SIZE, 0.05)
ROUGHNESSES = (0.0, 0.35)
IN_GAMUT = -1e-4
# Where the mip map changes, pixels two by two show another place of a table: one in fifty at most. ΔE00
# of the others, mean and largest.
SEAMS, LIMITS = 0.02, (0.55, 3.0)
# EEVEE keeps the colour of a closure in ten bits, which is much of a dark one.
STEP = 1.5 / 1023
# Looked at since there has been EEVEE in these tests, at these thicknesses.
CHOSEN = {"anodised_titanium": 52.0, "oil_on_water": 420.0, "tempered_steel": 20.0}


def is_seen(film: str, roughness: float) -> bool:
    """EEVEE picks the closures of a pixel by chance, so that films which let light through, or brushed
    ones that are rough, take as many samples as a path tracer; and many layers below an incoherent one
    take minutes to walk among facets."""
    template = material_template(film)
    brushed = any(socket["name"] == "tangent" for socket in manifest(film)["sockets"])
    slow = len(layers_of(template)) > 20 and len(template["layer"]) > 1
    passes = template.get("surface", {}).get("transmission", False)
    return not passes and not slow and not (brushed and roughness > 0.0)


CASES = [
    (film, roughness)
    for film in films()
    if film in {*representatives(), *CHOSEN}
    for roughness in ROUGHNESSES
    if is_seen(film, roughness) and (roughness == 0.0 or film in {*chosen(), *CHOSEN})
]


def value_of(film: str) -> float | None:
    axis = varied(material_template(film))
    return CHOSEN.get(film, axis and float(axis["default"]))


def cell(film: str, roughness: float) -> dict:
    """Over black where there is a base: the film alone."""
    values = {"roughness": roughness, "base_colour": (0.0, 0.0, 0.0, 1.0)}
    if value_of(film) is not None:
        values[manifest(film)["tables"][0]["axes"][1]["name"]] = value_of(film)
    names = {socket["name"] for socket in manifest(film)["sockets"]}
    return {"material": film, "values": {k: v for k, v in values.items() if k in names}}


@pytest.fixture(scope="module")
def spheres(displayed):
    def job() -> dict:
        cells = [cell(*case) for case in CASES]
        return {"cells": cells, "columns": COLUMNS, "size": SIZE, "samples": 1}

    pictures = displayed.pictures("eevee.atlas", job)

    def sphere(film: str, roughness: float) -> np.ndarray:
        row, column = divmod(CASES.index((film, roughness)), COLUMNS)
        return pictures()[SIZE * row :, SIZE * column :][:SIZE, :SIZE]

    return sphere


@pytest.fixture(scope="session")
def expected(update_refs):
    @cache
    def colours(film: str, roughness: float) -> np.ndarray:
        # A hundredth of the cosine is a hundredth of a colour at most.
        distinct, inverse = np.unique(np.round(COSINES[COUNTED], 2), return_inverse=True)
        if roughness == 0.0:
            return exact_colours(material_template(film), value_of(film), distinct)["R"][inverse]
        alpha = roughness**2
        rough = RoughFilm(film, value_of(film), (alpha, alpha), paths=10_000)
        return stored_colours(rough, distinct, update=update_refs)[inverse]

    return colours


@pytest.mark.parametrize(("film", "roughness"), CASES)
def test_film_in_eevee(spheres, expected, film, roughness, record_property):
    colours = expected(film, roughness)
    inside = colours.min(axis=1) > IN_GAMUT  # EEVEE clips the others, as every form of nodes does
    seen, colours = spheres(film, roughness)[COUNTED][inside], colours[inside]
    errors = delta_e(seen, np.clip(seen, colours - STEP, colours + STEP))
    record_property("dE00", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f} of {errors.size} pixels")
    assert errors.size >= 0.2 * math.pi / 4 * SIZE**2
    others = np.sort(errors)[: math.ceil((1 - SEAMS) * errors.size)]
    assert others.mean() <= LIMITS[0]
    assert others.max() <= LIMITS[1]
