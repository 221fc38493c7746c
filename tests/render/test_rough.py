# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Rough films on the furnace sphere against light that walks among the facets."""

from __future__ import annotations

import numpy as np
import pytest

from support.colours import delta_e
from support.stored_truth import RoughFilm, stored_colours
from support.truth import exact_colours, material_template, pixel_cosines, pixel_places

SIZE, SAMPLES = 12, 4096
# Pixels of a quarter of the sphere, which has all angles: right, up; cosines, and those that count.
PLACES = pixel_places(SIZE, quarter=True)
COSINES, COUNTED = pixel_cosines(SIZE, quarter=True)
ROUGHNESSES = (0.15, 0.35, 0.6, 0.9)
CASES = [
    (material, value, roughness)
    for material, value in (
        ("anodised_titanium", 52.0),
        ("jewel_beetle", 1.0),
        ("tempered_steel", 48.0),
    )
    for roughness in ROUGHNESSES
]
# form, exact_rough
WAYS = (("osl", 0), ("osl", 1), ("nodes", 0))
SOCKETS = {"jewel_beetle": "thickness_scale"}
# What 4096 samples of a pixel leave of noise is among it: up to 0.15 where the surface is roughest.
LIMIT = 0.3
IN_GAMUT = -1e-4


@pytest.fixture(scope="session")
def truth(update_refs):
    def colours(material: str, value: float, roughness: float) -> np.ndarray:
        distinct, inverse = np.unique(np.round(COSINES[COUNTED], 9), return_inverse=True)
        film = RoughFilm(material, value, (roughness**2, roughness**2))
        return stored_colours(film, distinct, update=update_refs)[inverse]

    return colours


def job(material: str, value: float, roughness: float, form: str, exact: int) -> dict:
    return {
        "material": material,
        "values": {
            SOCKETS.get(material, "thickness_nm"): value,
            "roughness": roughness,
            "exact_rough": exact,
        },
        "form": form,
        "lit": "all",
        "size": SIZE,
        "quarter": True,
        "samples": SAMPLES,
    }


@pytest.fixture(scope="module")
def furnaces(blender):
    return blender.pictures("furnace.render", job)


@pytest.mark.parametrize(("form", "exact"), WAYS)
@pytest.mark.parametrize(("material", "value", "roughness"), CASES)
def test_rough_film(furnaces, truth, material, value, roughness, form, exact, record_property):
    picture = furnaces(material, value, roughness, form, exact)[COUNTED]
    expected = truth(material, value, roughness)
    if form == "nodes":
        inside = expected.min(axis=1) > IN_GAMUT
        picture, expected = picture[inside], expected[inside]
    errors = delta_e(picture, expected)
    record_property("dE00", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f} of {errors.size} pixels")
    assert errors.mean() <= LIMIT


@pytest.mark.parametrize(("form", "exact"), WAYS)
@pytest.mark.parametrize("roughness", [0.3, 0.8])
def test_clear_films_keep_all_light(furnaces, roughness, form, exact):
    """What the facets reflect and what they pass, further bounces among it, is what came."""
    mean = furnaces("soap_film", 400.0, roughness, form, exact)[COUNTED].mean(axis=0)
    print("mean", mean)
    np.testing.assert_allclose(mean, 1.0, atol=2e-3 if exact else 1e-3)


ANGLES = (40.0, 80.0, 130.0)


@pytest.fixture(scope="module")
def lit(blender):
    """Highlights of one sharp light over those of a white surface."""

    def under_sun(material: str | None, exact: int, angle: float) -> dict:
        return {
            **job(material, 52.0, 0.2, "osl", exact),
            "lit": "sun",
            "angle": angle,
            "size": 48,
            "quarter": False,
            "samples": 16,
        }

    pictures = blender.pictures("furnace.render", under_sun)
    # Towards grazing views further bounces, which a white Glossy does not have, are not nothing.
    inner = pixel_cosines(48, 0.1)[1][..., None]

    def colours(exact: int, angle: float) -> np.ndarray:
        white = np.maximum(pictures(None, 0, angle), 1e-9)
        seen = (white > 0.02) & inner
        ratio = np.where(seen, pictures("anodised_titanium", exact, angle) / white, np.nan)
        return ratio[np.isfinite(ratio).all(axis=-1)]

    return colours


@pytest.mark.parametrize("angle", ANGLES)
def test_highlight_has_the_colour_of_its_facets(lit, angle):
    """Every facet that mirrors the light to the camera meets it at half their angle."""
    facet = exact_colours(
        material_template("anodised_titanium"), 52.0, np.cos(np.radians([angle / 2]))
    )["R"]
    exact, fast = lit(1, angle), lit(0, angle)
    errors = delta_e(exact, np.broadcast_to(facet, exact.shape))
    print(f"exact mean {errors.mean():.3f}, max {errors.max():.3f} of {len(exact)} pixels")
    print("fast mean", delta_e(fast, np.broadcast_to(facet, fast.shape)).mean())
    assert errors.mean() <= 0.3
    assert errors.mean() < delta_e(fast, np.broadcast_to(facet, fast.shape)).mean()


BRUSHED = "tempered_stainless_steel"
BRUSHED_NM = 35.0
ANISOTROPY = 0.6
# Largest mean of ΔE00, fast and exact. Surfaces without a direction stand in for brushed ones where
# means over facets and further bounces are looked up, which is worse the rougher they are.
BRUSHED_LIMITS = {0.2: (0.15, 0.1), 0.35: (0.4, 0.15), 0.5: (0.6, 0.3)}


@pytest.fixture(scope="session")
def brushed_truth(update_refs):
    """Tangents X lie along the horizontal of the picture, or across it: N × X."""

    def colours(roughness: float, turned: bool) -> np.ndarray:
        x, y = (place[COUNTED] for place in PLACES)
        z = np.sqrt(1 - x**2 - y**2)
        # The view (0, 0, 1) along X, which is (1, 0, 0) - N x made unit, and along N × X.
        along = x * z / np.sqrt(1 - x**2)
        aside = np.sqrt(np.maximum(0, 1 - z**2 - along**2))
        azimuths = np.arctan2(along, aside) if turned else np.arctan2(aside, along)
        alpha = (roughness**2 * (1 - ANISOTROPY), roughness**2 / (1 - ANISOTROPY))
        film = RoughFilm(BRUSHED, BRUSHED_NM, alpha, turned=turned)
        return stored_colours(film, z, azimuths, update=update_refs)

    return colours


BRUSHED_CASES = [
    (roughness, turned, *way)
    for roughness in BRUSHED_LIMITS
    for turned in (False, True)
    for way in WAYS
]


@pytest.fixture(scope="module")
def brushed(blender):
    def brushed_job(roughness: float, turned: bool, form: str, exact: int) -> dict:
        made = job(BRUSHED, BRUSHED_NM, roughness, form, exact) | {"brush": True}
        made["values"] |= {"anisotropy": ANISOTROPY, "rotation": 0.25 if turned else 0.0}
        return made

    return blender.pictures("furnace.render", brushed_job)


@pytest.mark.parametrize(("roughness", "turned", "form", "exact"), BRUSHED_CASES)
def test_brushed_film(brushed, brushed_truth, roughness, turned, form, exact):
    picture = brushed(roughness, turned, form, exact)
    errors = delta_e(picture[COUNTED], brushed_truth(roughness, turned))
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f} of {errors.size} pixels")
    assert errors.mean() <= BRUSHED_LIMITS[roughness][exact]
