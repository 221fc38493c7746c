# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Tables, templates and single colours are adapted alike."""

from __future__ import annotations

import numpy as np
import pytest

import nacre

GRID = np.arange(360.0, 831.0)
TEMPLATE = """
schema = 1
[material]
id = "film"
name = "Film"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
n = 1.45
thickness_nm = { default = 330, min = 300, max = 360, varies = true }
[substrate]
n = 3.5
"""
HOW = ("bradford", "cat16", "none")


def expected(how: str, thickness_nm: float = 330.0) -> np.ndarray:
    """At normal incidence under an incandescent lamp."""
    power = nacre.stack([1.0, 1.45, 3.5], [thickness_nm], 0.0, GRID).R
    return nacre.spectrum_to_colour(GRID, power, illuminant="A", adaptation=how).rgb


@pytest.mark.parametrize("how", HOW)
def test_film_lut(how):
    lut = nacre.film_lut(
        [1.0, 1.45, 3.5], [330.0], size=(9, 1), tolerance=None, illuminant="A", adaptation=how
    )
    np.testing.assert_allclose(lut.reflectance.texels[0, -1], expected(how), atol=2e-6)


@pytest.mark.parametrize("how", HOW)
def test_templates(how):
    light = {"illuminant": "A", "adaptation": how}
    found = nacre.template_spectrum(TEMPLATE, 330.0, 0.0, **light)
    np.testing.assert_allclose(found.colours[0], expected(how), atol=1e-9)
    preview = nacre.preview_tables(TEMPLATE, {"R": (2, 9)}, **light)["R"]
    np.testing.assert_allclose(preview[0, -1], expected(how, 300.0), atol=2e-6)
    compiled = nacre.compile_template(TEMPLATE, tolerance=2.0, **light)
    assert compiled.manifest["adaptation"] == how
    assert compiled.manifest["illuminant"] == "A"
    np.testing.assert_allclose(compiled.tables["R"][0, -1], expected(how, 300.0), atol=0.01)


def test_they_differ():
    bradford, cat16, none = map(expected, HOW)
    assert np.abs(bradford - cat16).max() > 1e-3
    assert none[0] > 1.3 * bradford[0]
    assert none[2] < 0.5 * bradford[2]


def test_an_unknown_one_is_refused():
    with pytest.raises(nacre.NacreError, match="bradford, cat16, none"):
        nacre.film_lut([1.0, 1.5], [], size=(2, 1), tolerance=None, adaptation="by eye")
    with pytest.raises(nacre.NacreError, match="bradford, cat16, none"):
        nacre.compile_template(TEMPLATE, adaptation="by eye")
