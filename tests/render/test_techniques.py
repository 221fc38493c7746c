# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Closed forms as techniques of materials: a furnace sphere each, against the form itself, and where
it is exact against the multilayer too."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from nacre import film_reflectance, spectrum_to_colour
from support.colours import delta_e
from support.representatives import FORMS
from support.shared import compiled_once
from support.truth import WAVELENGTHS, exact_colours, index, pixel_cosines

SIZE = 40
MEAN, LARGEST = 0.01, 0.1  # ΔE00 over the pixels of a sphere
# A channel this far below 0 is cut by the node form, which then cannot be right.
IN_GAMUT = -1e-4

SOAP = ({"medium": "water/Daimon-20C"}, {"medium": "air"}, 320.0)
COATING = ({"cauchy": [2.2, 0.032]}, {"abbe": {"n_d": 1.5168, "v_d": 64.2}}, 110.0)
TEMPER = ({"cauchy": [2.2, 0.032]}, {"medium": "Fe/Johnson"}, 60.0)
FILMS = {
    "path_difference": SOAP,
    "airy": COATING,
    "series": COATING,
    "opaque_base": TEMPER,
    "free_film": SOAP,
    "etalon": COATING,
    "recursion": TEMPER,
}
EXACT = ("airy", "opaque_base", "free_film", "recursion")
CELL_POINTS = 25
COSINES, COUNTED = pixel_cosines(SIZE)


def template(technique: str) -> dict:
    film, base, thickness_nm = FILMS[technique]
    return {
        "schema": 1,
        "material": {
            "id": f"by_{technique}",
            "name": technique,
            "category": "Tests",
            "source": "made up",
        },
        "ambient": {"medium": "air"},
        "layer": [{**film, "thickness_nm": thickness_nm}],
        "substrate": base,
        "stack": {"technique": technique},
    }


def form_colours(technique: str, cosines: np.ndarray) -> np.ndarray:
    """Linear Rec. 709 of the form's reflectance, shape (len(cosines), 3)."""
    film, base, thickness_nm = FILMS[technique]
    media = np.stack([np.ones(len(WAVELENGTHS)), index(film), index(base)], axis=-1)
    degrees = np.degrees(np.arccos(cosines))[:, None]
    nm = np.array(WAVELENGTHS, float)
    if technique != "path_difference":
        reflected = film_reflectance(technique, media, thickness_nm, degrees, nm)
        return spectrum_to_colour(WAVELENGTHS, reflected).rgb
    # Each wavelength stands for the wave numbers of its nanometre.
    steps = (np.arange(CELL_POINTS) + 0.5) / CELL_POINTS
    low, high = 1 / (nm + 0.5), 1 / (nm - 0.5)
    reflected = np.mean(
        [
            film_reflectance(technique, media, thickness_nm, degrees, 1 / (low + s * (high - low)))
            for s in steps
        ],
        axis=0,
    )
    return spectrum_to_colour(WAVELENGTHS, reflected).rgb


@cache
def exact(technique: str) -> tuple[np.ndarray, np.ndarray]:
    """Colours of the form and of the multilayer, of the pixels that count."""
    distinct, inverse = np.unique(np.round(COSINES[COUNTED], 12), return_inverse=True)
    multilayer = exact_colours(template(technique), None, distinct)["R"]
    return form_colours(technique, distinct)[inverse], multilayer[inverse]


@pytest.fixture(scope="module")
def compiled(tmp_path_factory) -> Path:
    return compiled_once(tmp_path_factory, "techniques", {name: template(name) for name in FILMS})


@pytest.fixture(scope="module")
def furnaces(blender, compiled):
    def job(technique: str, form: str) -> dict:
        return {
            "material": f"by_{technique}",
            "values": {"roughness": 0.0},
            "form": form,
            "lit": "all",
            "size": SIZE,
            "samples": 1,
        }

    return blender.pictures("furnace.render", job, compiled)


def allowed_mean(technique: str, compiled: Path) -> float:
    """That of every film; of bands with kinks the mean that the table states. Probes of it are
    spread evenly over cosθ, the pixels of a sphere are not."""
    if technique != "path_difference":
        return MEAN
    folder = compiled / f"by_{technique}"
    manifest = json.loads((folder / f"by_{technique}.json").read_text("utf-8"))
    return 1.1 * manifest["tables"][0]["error"]["mean"]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("technique", FILMS)
def test_sphere(furnaces, compiled, technique, form):
    picture = furnaces(technique, form)[COUNTED]
    expected, multilayer = exact(technique)
    if form == "nodes":
        inside = expected.min(axis=1) > IN_GAMUT
        picture, expected, multilayer = picture[inside], expected[inside], multilayer[inside]
    errors = delta_e(picture, expected)
    print(f"dE00 mean {errors.mean():.4f}, max {errors.max():.4f}")
    assert errors.mean() <= allowed_mean(technique, compiled)
    assert errors.max() <= LARGEST
    from_multilayer = delta_e(picture, multilayer)
    print(f"dE00 from the multilayer {from_multilayer.mean():.4f}")
    assert (from_multilayer.mean() <= MEAN) == (technique in EXACT)
