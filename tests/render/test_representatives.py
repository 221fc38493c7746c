# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Which films stand for which."""

from __future__ import annotations

import pytest

from support import representatives as r

PROGRAM = """\
color helper(color c) { return c * 0.5; }
shader nacre_soap
[[ string label = "Soap", string help = "A film" ]]
(
    float thickness_nm = 400.0
        [[ string label = "Thickness (nm)", float max = 1500.0 ]],
    color R_schlick_0_in = color(0.0)
        [[ string label = "R_schlick_0 Colour" ]],
    color R_schlick_1_in = color(0.0)
        [[ string label = "R_schlick_1 Colour" ]],
    output closure color BSDF = 0
)
{
    BSDF = lobe(table("soap_R.exr", 0.0, 17.0), -1.5);
    BSDF = lobe(table("soap_R.exr", 0.5, 17.0), 2.5e-3) + BSDF;
    BSDF = lobe(table("soap_R.exr", 1.0, 17.0), 3.0) + BSDF;
}
"""
ONE_LOBE_LESS = PROGRAM.replace(
    '    BSDF = lobe(table("soap_R.exr", 1.0, 17.0), 3.0) + BSDF;\n', ""
).replace(
    '    color R_schlick_1_in = color(0.0)\n        [[ string label = "R_schlick_1 Colour" ]],\n',
    "",
)


@pytest.mark.parametrize(
    "same",
    [
        pytest.param(PROGRAM.replace("400.0", "25").replace("1500.0", "3e2"), id="other numbers"),
        pytest.param(PROGRAM.replace("soap", "oil").replace("A film", "Oil, 3 layers"), id="names"),
        pytest.param(ONE_LOBE_LESS, id="another count of lobes"),
        pytest.param(PROGRAM.replace("-1.5", "1.5"), id="a sign of a number"),
    ],
)
def test_programs_of_one_shape(same):
    assert same != PROGRAM
    assert r.program_shape(same) == r.program_shape(PROGRAM)


@pytest.mark.parametrize(
    "other",
    [
        pytest.param(PROGRAM.replace("thickness_nm", "thickness_scale"), id="another parameter"),
        pytest.param(
            PROGRAM.replace("    BSDF = lobe(", "    BSDF = 2.0 * lobe(", 1), id="a factor"
        ),
        pytest.param(
            PROGRAM.replace("}\n", "    BSDF = BSDF + transparent();\n}\n"), id="a closure"
        ),
    ],
)
def test_programs_of_other_shapes(other):
    assert r.program_shape(other) != r.program_shape(PROGRAM)


def test_every_shape_has_a_representative():
    assert {r.shape(film) for film in r.representatives()} == {r.shape(film) for film in r.films()}


def test_other_films_go_one_way_each_and_all_ways_are_gone():
    others = [film for film in r.films() if film not in r.representatives()]
    ways = [way for film in others for way in r.ways(film, "reflection")]
    assert len(ways) == len(others)
    if others:  # all are representatives in the soak
        assert {form for _, form in ways} == set(r.FORMS)
        assert {version for version, _ in ways} == set(r.versions())
