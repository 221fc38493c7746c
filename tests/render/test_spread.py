# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films of an unevenness too fine to be seen against the exact mean over their phases."""

from __future__ import annotations

import numpy as np
import pytest

from support.colours import delta_e
from support.representatives import FORMS
from support.stored_truth import RoughFilm, stored_colours
from support.truth import exact_colours, material_template, pixel_cosines

SIZE, SAMPLES = 10, 4096
# material, thickness, its standard deviation, roughness
CASES = (
    ("oil_on_water", 600.0, 20.0, 0.0),
    ("oil_on_water", 600.0, 60.0, 0.0),
    ("anodised_titanium", 110.0, 15.0, 0.0),
    ("anodised_titanium", 110.0, 15.0, 0.3),
)
LIMIT = 0.3  # mean ΔE00; the noise of the samples is most of it


def job(case: tuple, form: str) -> dict:
    material, thickness, spread, roughness = case
    return {
        "material": material,
        "values": {"thickness_nm": thickness, "roughness": roughness},
        "spread_nm": spread,
        "form": form,
        "lit": "all",
        "size": SIZE,
        "samples": SAMPLES,
    }


@pytest.fixture(scope="module")
def furnaces(blender):
    return blender.pictures("furnace.render", job)


@pytest.fixture(scope="session")
def expected(update_refs):
    def colours(case: tuple, cosines: np.ndarray, spread: float) -> np.ndarray:
        material, thickness, _, roughness = case
        if roughness == 0.0:
            template = material_template(material)
            return exact_colours(template, thickness, cosines, spread_nm=spread)["R"]
        film = RoughFilm(material, thickness, (roughness**2, roughness**2), spread)
        return stored_colours(film, cosines, update=update_refs)

    return colours


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("case", CASES)
def test_fringes_fade(furnaces, expected, case, form, record_property):
    cosines, counted = pixel_cosines(SIZE)
    distinct, inverse = np.unique(np.round(cosines[counted], 9), return_inverse=True)
    uneven = expected(case, distinct, case[2])[inverse]
    even = expected(case, distinct, 0.0)[inverse]
    errors = delta_e(furnaces(case, form)[counted], uneven)
    record_property("dE00", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f}")
    assert errors.mean() <= LIMIT
    assert delta_e(even, uneven).mean() > 4 * LIMIT  # so that the spread is what was tested
