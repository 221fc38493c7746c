# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Sums of shapes against numpy and scipy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

import nacre
from nacre.shapes import WAVELENGTH_NM, Box, Constant, Gaussian, Points, Scaled, define, total


def bell(nm, centre, fwhm):
    return np.exp(-4 * np.log(2) * ((nm - centre) / fwhm) ** 2)


def test_shapes_add_up():
    shapes = [Constant(0.1), Gaussian(500, 60, 0.3), Box(550, 600, 0.2), Constant(-0.05)]
    wanted = 0.05 + 0.3 * bell(WAVELENGTH_NM, 500, 60)
    wanted += 0.2 * ((WAVELENGTH_NM >= 550) & (WAVELENGTH_NM <= 600))
    np.testing.assert_allclose(total(shapes), wanted, rtol=0, atol=1e-15)
    nm = np.linspace(480, 700, 333)
    np.testing.assert_allclose(
        total(Gaussian(500, 60, 2), nm), 2 * bell(nm, 500, 60), rtol=0, atol=1e-15
    )


def test_a_soft_box_keeps_the_area_of_the_hard_one():
    nm = np.arange(400, 700.01, 0.05)
    soft = total(Box(500, 600, 1, 40), nm)
    assert soft[np.isin(nm.round(2), [500, 600])] == pytest.approx([0.5, 0.5], abs=1e-9)
    assert np.sum(soft) * 0.05 == pytest.approx(100, abs=1e-6)


def test_smooth_points_are_monotone_as_those_of_scipy():
    points = [400, 430, 500, 505, 700], [0.1, 0.2, 0.9, 0.9, 0.3]
    inside = np.arange(400.0, 701.0)
    np.testing.assert_allclose(
        total(Points(*points, smooth=True), inside),
        PchipInterpolator(*points)(inside),
        rtol=0,
        atol=1e-12,
    )
    np.testing.assert_allclose(
        total(Points(*points)), np.interp(WAVELENGTH_NM, *points), rtol=0, atol=1e-15
    )


def test_what_is_defined_can_be_used_and_kept(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    teal = define(Gaussian(490, 80, 0.4), "reflectance", key="mine/teal", name="Teal", tags=["x"])
    assert teal.comments == "gaussian 490:80:0.4"
    nacre.library.add(teal)
    kept = nacre.library.spectrum("mine/teal")
    assert (kept.name, kept.kind, kept.tags) == ("Teal", "reflectance", ("x",))
    np.testing.assert_array_equal(kept.values, teal.values)
    by_key, by_hand = (total(Scaled(which, 0.5)) for which in ("mine/teal", teal))
    np.testing.assert_array_equal(by_key, by_hand)
    np.testing.assert_allclose(by_key, 0.5 * teal.values, rtol=1e-15)
    colour = nacre.spectrum_to_colour(teal.wavelength_nm, teal.values, teal.kind)
    assert colour.rgb[1] > colour.rgb[0]


WRONG = {
    "narrow": (lambda: total(Gaussian(550, 0.5, 1)), "must be ≥ 1 nm, the step"),
    "between": (lambda: total(Box(550.2, 550.8, 1)), "lie between two wavelengths"),
    "nothing": (lambda: total([]), "must be at least one"),
    "width": (lambda: total(Gaussian(550, -1, 1)), "the width must be finite and > 0"),
    "text": (lambda: total(Constant("x")), "Constant: must be 1 numbers"),
    "no shape": (lambda: total([3.0]), "must be Constant, Box, Gaussian, Points or Scaled"),
    "points": (lambda: total(Points([400, 300], [1, 1])), "ascending"),
    "lengths": (lambda: total(Points([400, 500], [1])), r"values: must have shape \(2,\)"),
    "flat": (lambda: total(Constant(1), [[400, 500]]), "wavelength_nm: must have shape"),
    "key": (lambda: total(Scaled("colorchecker/dark-skim")), "perhaps colorchecker/dark-skin"),
    "kind": (lambda: define(Constant(1), "Reflectance"), "must be emission or reflectance"),
    "suits": (lambda: define(Constant(3), "reflectance"), "a reflectance must be in"),
    "dark": (lambda: define(Constant(0), "emission"), "an emission must be"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_shapes_are_refused(name):
    call, message = WRONG[name]
    with pytest.raises(nacre.NacreError, match=message):
        call()
