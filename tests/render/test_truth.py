# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films on the furnace sphere against the exact spectrum, before any stored picture is believed."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from harness import delta_e, manifest
from truth import (
    colours_over_base,
    exact_colours,
    material_template,
    pixel_cosines,
    template_names,
    varied,
)

# The first sample of a pixel lies at its centre, and one is enough where there is one way to go. A
# film with something below picks one of two ways at random; the error of Sobol points falls like 1/N.
ONE_WAY = {"size": 40, "samples": 1}
TWO_WAYS = {"size": 16, "samples": 16384, "quarter": True}
# ΔE00, mean and largest; with two ways the noise of the samples stays.
ONE_WAY_LIMITS, TWO_WAYS_LIMITS = (0.01, 0.1), (0.03, 0.15)
# A channel this far below 0 is cut by the node form, which then cannot be right.
IN_GAMUT = -1e-4

# Thicknesses or scales worth more than the two that every film gets.
CHOSEN = {
    "soap_film": (400.0, 930.0),
    "oil_on_water": (420.0, 1100.0),
    "tempered_steel": (20.0, 48.0),
    "anodised_titanium": (52.0, 180.0),
    "jewel_beetle": (1.0, 1.21),
    "colour_shift_ink": (350.0, 470.0),
}
# Where next to nothing is reflected, few of the paths are, and their noise is seen.
MORE_SAMPLES = {"spectacle_coating": 4}


def values_of(material: str) -> tuple[float | None, ...]:
    """What to render it with: its default, and half-way from there to the end of its range."""
    if material in CHOSEN:
        return CHOSEN[material]
    axis = varied(material_template(material))
    if axis is None:
        return (None,)
    return (float(axis["default"]), 0.5 * (axis["default"] + axis["max"]))


FILMS = [name for name in template_names() if "substrate" in material_template(name)]
CASES = [(name, value) for name in FILMS for value in values_of(name)]
# A light and a dark base; the others differ in numbers only.
OVER_BASE = [case for case in CASES if case[0] in ("pearl_white", "petrol_on_asphalt")]
STRAIGHT_THROUGH = [case for case in CASES if case[0] in ("soap_film", "dichroic_mirror")]


def socket_values(material: str, value: float | None, lit: str) -> dict:
    """Sockets for one case: a mirror-like surface with `value` on the second axis of the tables, and
    a black base where only the film is looked at."""
    names = {socket["name"] for socket in manifest(material)["sockets"]}
    values: dict = {"roughness": 0.0} if "roughness" in names else {}
    if "base_colour" in names and lit == "film":
        values["base_colour"] = (0.0, 0.0, 0.0, 1.0)
    if value is not None:
        values[manifest(material)["tables"][0]["axes"][1]["name"]] = value
    return values


def surface(material: str) -> dict:
    return material_template(material).get("surface", {})


def ways(material: str) -> tuple[str, ...]:
    """What light is let in, one picture for each: see furnace_worker.py. `film` and `base` are `all`
    over a black base and over the material's own."""
    first = "reflected" if surface(material).get("transmission") else "film"
    if any(material == name for name, _ in OVER_BASE):
        return (first, "base")
    return (first, "passed") if any(material == name for name, _ in STRAIGHT_THROUGH) else (first,)


def sampling(material: str, lit: str) -> dict:
    if lit == "film":
        return ONE_WAY
    return {**TWO_WAYS, "samples": TWO_WAYS["samples"] * MORE_SAMPLES.get(material, 1)}


@cache
def exact(material: str, value: float | None, lit: str):
    """Pictures of R and T, or of the film over its base, and the pixels to compare."""
    pixels = sampling(material, lit)
    cosines, counted = pixel_cosines(pixels["size"], quarter=pixels.get("quarter", False))
    # Pixels of equal radius differ in the last bits only.
    distinct, inverse = np.unique(np.round(cosines[counted], 12), return_inverse=True)
    template = material_template(material)
    if lit == "base":
        base = np.array(surface(material)["diffuse_base"])
        colours = {"base": colours_over_base(template, value, distinct, base)}
    else:
        colours = exact_colours(template, value, distinct)
    return {name: rows[inverse] for name, rows in colours.items()}, counted


PICTURES = [
    (material, value, form, lit)
    for material, value in CASES
    for form in ("osl", "nodes")
    for lit in ways(material)
]


@pytest.fixture(scope="module")
def furnaces(blender):
    """Pictures of every case by (material, value, form, lit)."""
    jobs = [
        {
            "material": material,
            "values": socket_values(material, value, lit),
            "form": form,
            "lit": "all" if lit in ("film", "base") else lit,
            **sampling(material, lit),
        }
        for material, value, form, lit in PICTURES
    ]
    return dict(zip(PICTURES, blender.run("furnace_worker.py", jobs), strict=True))


def check(lit: str, picture: np.ndarray, expected: np.ndarray, record_property) -> None:
    errors = delta_e(picture, expected)
    record_property("dE00", f"mean {errors.mean():.4f}, max {errors.max():.4f}")
    print(f"dE00 mean {errors.mean():.4f}, max {errors.max():.4f} of {errors.size} pixels")
    mean, largest = ONE_WAY_LIMITS if lit == "film" else TWO_WAYS_LIMITS
    assert errors.mean() <= mean
    assert errors.max() <= largest


@pytest.mark.parametrize("form", ["osl", "nodes"])
@pytest.mark.parametrize(("material", "value"), CASES)
def test_reflection(furnaces, material, value, form, record_property):
    lit = ways(material)[0]
    colours, counted = exact(material, value, lit)
    picture = furnaces[material, value, form, lit][counted]
    expected = colours["R"]
    if form == "nodes":
        inside = expected.min(axis=1) > IN_GAMUT
        assert inside.any() or material in ("dichroic_mirror", "colour_shift_ink")
        picture, expected = picture[inside], expected[inside]
        if not len(picture):
            return
    check(lit, picture, expected, record_property)


@pytest.mark.parametrize("form", ["osl", "nodes"])
@pytest.mark.parametrize(("material", "value"), STRAIGHT_THROUGH)
def test_transmission(furnaces, material, value, form, record_property):
    """Straight through the film. Cycles cuts negative weights of every closure but the transparent
    one, so that colours outside the gamut pass in both forms. What nodes add to the reflection by
    that they take from what passes."""
    colours, counted = exact(material, value, "passed")
    assert material != "dichroic_mirror" or colours["T"].min() < -0.05
    picture = furnaces[material, value, form, "passed"][counted]
    cut = np.minimum(colours["R"], 0.0) if form == "nodes" else 0.0
    check("passed", picture, colours["T"] + cut, record_property)


@pytest.mark.parametrize("form", ["osl", "nodes"])
@pytest.mark.parametrize(("material", "value"), OVER_BASE)
def test_film_over_its_base(furnaces, material, value, form, record_property):
    colours, counted = exact(material, value, "base")
    picture = furnaces[material, value, form, "base"][counted]
    check("base", picture, colours["base"], record_property)


def test_every_film_is_checked():
    from harness import materials_folder

    films = {
        folder.name
        for folder in materials_folder().iterdir()
        if (folder / f"{folder.name}.json").is_file() and manifest(folder.name)["kind"] == "film"
    }
    assert films == set(FILMS)
    assert set(CHOSEN) <= films


@pytest.mark.parametrize("material", ["n_bk7", "sf11", "water", "diamond"])
def test_glass_leaves_a_white_environment_white(blender, material):
    """Each wavelength's colour is far from white; their mean must not be."""
    (picture,) = blender.run(
        "furnace_worker.py",
        [
            {
                "material": material,
                "values": {},
                "form": "osl",
                "lit": "all",
                "size": 24,
                "samples": 1024,
            }
        ],
    )
    _, counted = pixel_cosines(24, 0.05)
    mean = picture[counted].mean(axis=0)
    print("mean", mean)
    assert np.abs(mean - 1.0).max() <= 0.005
