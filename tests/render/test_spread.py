# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films of an unevenness too fine to be seen against the exact mean over their phases."""

from __future__ import annotations

import numpy as np
import pytest
from harness import delta_e
from rough_truth import furnace_colours
from truth import exact_colours, material_template, pixel_cosines

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
    keys = [(case, form) for case in CASES for form in ("osl", "nodes")]
    pictures = blender.run("furnace_worker.py", [job(*key) for key in keys])
    return dict(zip(keys, pictures, strict=True))


def expected(case: tuple, cosines: np.ndarray, spread: float) -> np.ndarray:
    material, thickness, _, roughness = case
    template = material_template(material)
    if roughness == 0.0:
        return exact_colours(template, thickness, cosines, spread_nm=spread)["R"]
    alpha = (roughness**2, roughness**2)
    return furnace_colours(template, thickness, cosines, alpha, spread_nm=spread)


@pytest.mark.parametrize("form", ["osl", "nodes"])
@pytest.mark.parametrize("case", CASES)
def test_fringes_fade(furnaces, case, form, record_property):
    cosines, counted = pixel_cosines(SIZE)
    distinct, inverse = np.unique(np.round(cosines[counted], 12), return_inverse=True)
    uneven = expected(case, distinct, case[2])[inverse]
    even = expected(case, distinct, 0.0)[inverse]
    errors = delta_e(furnaces[case, form][counted], uneven)
    record_property("dE00", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f}")
    assert errors.mean() <= LIMIT
    assert delta_e(even, uneven).mean() > 4 * LIMIT  # so that the spread is what was tested
