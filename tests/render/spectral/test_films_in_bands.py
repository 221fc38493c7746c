# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films rendered in bands: smooth ones under any light, rough ones under daylight, and back again."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from support.colours import delta_e as rgb_delta_e
from support.images import read_channels, read_image
from support.paths import manifest
from support.representatives import films
from support.spectral import delta_e, light_at, observer_at, read_spectral
from support.stored_truth import RoughFilm, stored_colours
from support.truth import material_template, pixel_cosines, spectra, varied

SIZE, COLUMNS = 12, 8
"""Pixels of a sphere, and spheres in a row."""
COSINES, COUNTED = pixel_cosines(SIZE)
KINDS = (
    "soap_film",  # a thin wall
    "dichroic_mirror",  # on glass, of steep edges
    "spectacle_coating",
    "oil_on_water",  # fades to the bare surface
    "petrol_on_asphalt",
    "jewel_beetle",  # many layers
    "pearl_red",
    "anodised_titanium",
    "tempered_steel",
)
SOAK = bool(os.environ.get("NACRE_SOAK"))
FILMS = tuple(films()) if SOAK else KINDS
GROUPS = [FILMS[at : at + len(KINDS)] for at in range(0, len(FILMS), len(KINDS))]
"""Of a file each: some films take ten times as many bands as others, and tables in memory of all of them."""
LAMPS = ("A", "F11", "LED-B3", "lamp/hps")
ROUGH = (
    ("anodised_titanium", "thickness_nm", 52.0),
    ("jewel_beetle", "thickness_scale", 1.0),
    ("tempered_steel", "thickness_nm", 48.0),
)
ROUGHNESS = 0.35


def spheres(picture: np.ndarray) -> np.ndarray:
    """Pixels that count of each sphere, (spheres, pixels, 3)."""
    rows, columns = (side // SIZE for side in picture.shape[:2])
    parts = picture.reshape(rows, SIZE, columns, SIZE, 3).swapaxes(1, 2)
    return parts.reshape(rows * columns, SIZE, SIZE, 3)[:, COUNTED]


def cell(material: str, form: str, roughness: float, **values: float) -> dict:
    """Over a black base, where there is one: nothing but the film."""
    given = {"roughness": roughness, "base_colour": (0.0, 0.0, 0.0, 1.0), **values}
    names = {socket["name"] for socket in manifest(material)["sockets"]}
    return {
        "material": material,
        "form": form,
        "values": {name: value for name, value in given.items() if name in names},
        "brush": "tangent" in names,
    }


def in_bands(blender, name: str, cells: list[dict], **more) -> tuple[dict, Path]:
    """What the job says, and the folder with its pictures."""
    folder = blender.folder / name.replace("/", "_")
    folder.mkdir()
    said = blender.call(
        "spectral.scenes.films",
        **{"cells": cells, "columns": COLUMNS, "folder": str(folder), "size": SIZE},
        # One sample in a thousand is half a pixel off, however narrow the filter is.
        **{"samples": 512, "lit": "reflected", **more},
    )
    assert not said["remarks"]
    assert not said["left"]
    return said, folder


def reflected(material: str, light: str) -> tuple[np.ndarray, np.ndarray]:
    """XYZ of the film at the pixels that count, where white has Y = 1, and of white."""
    template = material_template(material)
    value = varied(template)
    reflectance = spectra(template, value and value["default"], COSINES[COUNTED]).R
    nm, power = light_at(light)
    seen = observer_at(nm) * power[:, None]
    white = seen.sum(axis=0)
    fine = np.array([np.interp(nm, np.arange(360, 831), row) for row in reflectance])
    return fine @ seen / white[1], white / white[1]


@pytest.fixture(scope="module", params=range(len(GROUPS)))
def daylight(blender, request):
    """By turns in OSL and in nodes; what is in OSL has nodes while it is spectral."""
    materials = GROUPS[request.param]
    cells = [cell(film, ("osl", "nodes")[at % 2], 0.0) for at, film in enumerate(materials)]
    # Those of every day have enough in 48.
    passes = 0 if SOAK else 16
    said, folder = in_bands(blender, f"daylight {request.param}", cells, passes=passes)
    return said, folder, materials


def test_films_come_back(daylight):
    said, folder, _ = daylight
    np.testing.assert_array_equal(
        read_image(folder / "after.exr"), read_image(folder / "before.exr")
    )
    assert said["spectra"] == said["removed"]
    assert said["blocks"] == said["blocks_before"]


def check(picture: np.ndarray, materials: tuple[str, ...], light: str, record_property) -> None:
    """Where light passes as well, which of both a path does is chance: of such a sphere the mean."""
    for sphere, material in zip(spheres(picture), materials, strict=False):
        pixels, (expected, white) = sphere, reflected(material, light)
        passes = any(table["role"]["of"] == "T" for table in manifest(material)["tables"])
        if passes:
            pixels, expected = (values.mean(0, keepdims=True) for values in (sphere, expected))
        errors = delta_e(pixels, expected, white)
        record_property(material, f"mean {errors.mean():.3f}, max {errors.max():.3f}")
        print(material, f"mean {errors.mean():.3f}, max {errors.max():.3f}")
        assert errors.mean() <= (0.5 if passes else 0.1), material
        assert errors.max() <= 1.0, material


def test_smooth_films_under_daylight(daylight, record_property):
    _, folder, materials = daylight
    check(read_spectral(folder / "bands.exr")[0], materials, "D65", record_property)


@pytest.mark.parametrize("light", LAMPS)
def test_smooth_films_under_a_lamp(blender, light, record_property):
    """As many bands as light and films need."""
    materials = tuple(material for material, _, _ in ROUGH)
    cells = [cell(material, "nodes", 0.0) for material in materials]
    _, folder = in_bands(blender, light, cells, light=light)
    check(read_spectral(folder / "bands.exr")[0], materials, light, record_property)


def test_rough_films_under_daylight(blender, record_property, update_refs):
    cells = [cell(material, "nodes", ROUGHNESS, **{name: value}) for material, name, value in ROUGH]
    _, folder = in_bands(blender, "rough", cells, lit="all", samples=4096)
    found = spheres(read_channels(folder / "bands.exr", "RGB")[0])
    distinct, inverse = np.unique(np.round(COSINES[COUNTED], 9), return_inverse=True)
    for pixels, (material, _, value) in zip(found, ROUGH, strict=False):
        film = RoughFilm(material, value, (ROUGHNESS**2, ROUGHNESS**2))
        errors = rgb_delta_e(pixels, stored_colours(film, distinct, update=update_refs)[inverse])
        record_property(material, f"mean {errors.mean():.3f}, max {errors.max():.3f}")
        print(material, f"mean {errors.mean():.3f}, max {errors.max():.3f}")
        assert errors.mean() <= 0.3, material
