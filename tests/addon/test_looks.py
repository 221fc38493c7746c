# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Looks of the user's own, and variations, in Blender 4.5 and 5.2; what of them needs no Blender."""

from __future__ import annotations

import importlib
import math

import pytest

from support.paths import materials_folder

variations = importlib.import_module("nacre_extension.variations.drawing")
names = importlib.import_module("nacre_extension.looks.file_names")
Knob = variations.Knob

KNOBS = (
    Knob("thickness_nm", 300.0, 0.0, 1000.0, (0.0, 1000.0)),
    Knob("roughness", 0.0, 0.0, 1.0, (0.0, 0.6), ladder=(0.0, 0.05, 0.6)),
    Knob("dispersion", 1.0, 0.0, 5.0),
)


def test_looks_are_saved_and_shared(blender, tmp_path, thin_slick):
    blender.with_environment(NACRE_MATERIALS=thin_slick).script("looks/looks", tmp_path)


@pytest.mark.parametrize("form", ["osl", "nodes"])
def test_variations_of_every_material(blender, form):
    shipped = str(materials_folder())
    blender.with_environment(NACRE_MATERIALS=shipped).script("looks/variations", form)


def test_seeds_give_the_same_again_and_spread():
    drawn = [variations.randomised(KNOBS, seed) for seed in range(8)]
    assert drawn == [variations.randomised(KNOBS, seed) for seed in range(8)]
    nm = sorted(state["thickness_nm"] for state in drawn)
    assert max(b - a for a, b in zip([0.0, *nm], [*nm, 1000.0], strict=True)) < 350.0
    assert {state["dispersion"] for state in drawn} == {1.0}
    assert all(0.0 <= state["roughness"] <= 0.6 for state in drawn)


def test_like_keeps_the_character():
    for seed in range(50):
        state = variations.like(KNOBS, seed)
        assert abs(state["thickness_nm"] - 300.0) <= 36.0
        assert state["roughness"] == 0.0
        assert abs(state["dispersion"] - 1.0) <= 0.12


def test_limits_of_several_values_together():
    knobs = (
        Knob("a/Minimum", 100.0, 0.0, 500.0, (0.0, 500.0)),
        Knob("a/Maximum", 400.0, 0.0, 500.0, (0.0, 500.0), not_below="a/Minimum"),
        Knob("b/Base", 100.0, 0.0, 500.0, (0.0, 500.0)),
        Knob("b/Height", 300.0, 0.0, 500.0, (50.0, 400.0), piled_on="b/Base"),
    )
    for seed in range(200):
        state = variations.randomised(knobs, seed)
        assert state["a/Minimum"] <= state["a/Maximum"]
        assert state["b/Base"] + state["b/Height"] <= 500.0


def test_a_ladder_has_even_steps_of_colour():
    values = [float(i) for i in range(101)]
    colours = [(0.0, 0.0, 0.0) if i < 90 else ((i - 90) / 10.0,) * 3 for i in range(101)]
    ladder = variations.colour_ladder(values, colours)
    assert ladder[0] >= 0.0
    assert ladder[-1] == 100.0
    assert sum(value > 89.0 for value in ladder) >= len(ladder) - 1
    assert variations.colour_ladder(values, [(0.2, 0.2, 0.2)] * 101) == ()
    assert all(map(math.isfinite, ladder))


@pytest.mark.parametrize(
    ("name", "stem"),
    [
        ("Slick", "Slick"),
        ("a/b:c", "a%2Fb%3Ac"),
        ("CON", "%43ON"),
        ("lpt1.x", "%6Cpt1.x"),
        ("..", "%2E%2E"),
        ("end ", "end%20"),
        ("100 %", "100 %25"),
        ("光沢", "光沢"),
    ],
)
def test_names_of_files_and_back(name, stem):
    assert names.stem(name) == stem
    assert names.name_of(stem) == name


def test_names_are_tidied_and_numbered():
    assert names.tidy(" a\nb\t") == "a b"
    assert names.tidy("O\u0308l") == "Öl"
    assert len(names.tidy("ö" * 90).encode()) <= names.LONGEST
    assert names.free("Slick", ["slick", "Slick 2"]) == "Slick 3"
    assert names.is_same("STRASSE", "straße")
