# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films on the furnace sphere against the exact spectrum, before any stored picture is believed."""

from __future__ import annotations

from functools import cache
from itertools import product

import numpy as np
import pytest

from blender.harness import VERSIONS
from support.colours import delta_e
from support.paths import manifest
from support.representatives import FORMS, films, representatives, ways
from support.truth import (
    colours_over_base,
    exact_colours,
    layers_of,
    material_template,
    pixel_cosines,
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
# Layers below an incoherent one whose spectrum is cheap enough for every pixel.
MOST_BELOW_A_COAT = 20
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


def held(film: str, quantity: str, every: bool = False) -> list[tuple]:
    """(version, form, film, value) for what is looked at; `every`: of a film in the full product."""
    if every or film in representatives():
        return [
            (version, form, film, value)
            for version, form in product(VERSIONS, FORMS)
            for value in values_of(film)
        ]
    return [
        (version, form, film, value)
        for version, form, value in ways(film, quantity, values_of(film))
    ]


REFLECTION = [case for film in films() for case in held(film, "reflection")]
# A light and a dark base; the others differ in numbers only.
OVER_BASE = [
    case for film in ("pearl_white", "petrol_on_asphalt") for case in held(film, "base", every=True)
]
STRAIGHT_THROUGH = [
    case for film in ("soap_film", "dichroic_mirror") for case in held(film, "passed", every=True)
]


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


def reflected_light(material: str) -> str:
    """What light is let in to see the film alone: see jobs/furnace.py. `film` and `base` are `all`
    over a black base and over the material's own."""
    return "reflected" if surface(material).get("transmission") else "film"


def sampling(material: str, lit: str) -> dict:
    if lit == "film":
        return ONE_WAY
    return {**TWO_WAYS, "samples": TWO_WAYS["samples"] * MORE_SAMPLES.get(material, 1)}


def pixels(material: str, lit: str) -> tuple[np.ndarray, np.ndarray]:
    """Cosines at the pixels' centres, and the pixels to compare: those of one angle in ten where the
    exact spectrum of an angle takes a third of a second."""
    given = sampling(material, lit)
    cosines, counted = pixel_cosines(given["size"], quarter=given.get("quarter", False))
    cosines = np.round(cosines, 12)  # pixels of equal radius differ in the last bits only
    layers = layers_of(material_template(material))
    if len(layers) > MOST_BELOW_A_COAT and not all(layer.get("coherent", True) for layer in layers):
        counted = counted & np.isin(cosines, np.unique(cosines[counted])[::10])
    return cosines, counted


@cache
def exact(material: str, value: float | None, lit: str):
    """Pictures of R and T, or of the film over its base, and the pixels to compare."""
    cosines, counted = pixels(material, lit)
    distinct, inverse = np.unique(cosines[counted], return_inverse=True)
    template = material_template(material)
    if lit == "base":
        base = np.array(surface(material)["diffuse_base"])
        colours = {"base": colours_over_base(template, value, distinct, base)}
    else:
        colours = exact_colours(template, value, distinct)
    return {name: rows[inverse] for name, rows in colours.items()}, counted


def job(material: str, value: float | None, form: str, lit: str) -> dict:
    return {
        "material": material,
        "values": socket_values(material, value, lit),
        "form": form,
        "lit": "all" if lit in ("film", "base") else lit,
        **sampling(material, lit),
    }


@pytest.fixture(scope="module")
def furnaces(blender):
    return blender.pictures("furnace.render", job)


def each(cases: list[tuple]):
    return pytest.mark.parametrize(
        ("blender_version", "form", "material", "value"), cases, indirect=["blender_version"]
    )


def check(lit: str, picture: np.ndarray, expected: np.ndarray, record_property) -> None:
    errors = delta_e(picture, expected)
    record_property("dE00", f"mean {errors.mean():.4f}, max {errors.max():.4f}")
    print(f"dE00 mean {errors.mean():.4f}, max {errors.max():.4f} of {errors.size} pixels")
    mean, largest = ONE_WAY_LIMITS if lit == "film" else TWO_WAYS_LIMITS
    assert errors.mean() <= mean
    assert errors.max() <= largest


@each(REFLECTION)
def test_reflection(furnaces, material, value, form, record_property):
    lit = reflected_light(material)
    colours, counted = exact(material, value, lit)
    picture = furnaces(material, value, form, lit)[counted]
    expected = colours["R"]
    if form == "nodes":
        inside = expected.min(axis=1) > IN_GAMUT
        assert inside.any() or material in ("dichroic_mirror", "colour_shift_ink")
        picture, expected = picture[inside], expected[inside]
        if not len(picture):
            return
    check(lit, picture, expected, record_property)


@each(STRAIGHT_THROUGH)
def test_transmission(furnaces, material, value, form, record_property):
    """Straight through the film. Cycles cuts negative weights of every closure but the transparent
    one, so that colours outside the gamut pass in both forms. What nodes add to the reflection by
    that they take from what passes."""
    colours, counted = exact(material, value, "passed")
    assert material != "dichroic_mirror" or colours["T"].min() < -0.05
    picture = furnaces(material, value, form, "passed")[counted]
    cut = np.minimum(colours["R"], 0.0) if form == "nodes" else 0.0
    check("passed", picture, colours["T"] + cut, record_property)


@each(OVER_BASE)
def test_film_over_its_base(furnaces, material, value, form, record_property):
    colours, counted = exact(material, value, "base")
    picture = furnaces(material, value, form, "base")[counted]
    check("base", picture, colours["base"], record_property)


def test_every_film_is_checked():
    assert {material for _, _, material, _ in REFLECTION} == set(films())
    assert set(CHOSEN) <= set(films())


@pytest.mark.parametrize("material", ["n_bk7", "sf11", "water", "diamond"])
def test_glass_leaves_a_white_environment_white(blender, material):
    """Each wavelength's colour is far from white; their mean must not be."""
    picture = blender.picture(
        "furnace.render", material=material, values={}, form="osl", lit="all", size=24, samples=1024
    )
    _, counted = pixel_cosines(24, 0.05)
    mean = picture[counted].mean(axis=0)
    print("mean", mean)
    assert np.abs(mean - 1.0).max() <= 0.005
