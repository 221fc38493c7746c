# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Closed forms beside the multilayer, and slits."""

import numpy as np
import pytest

import nacre

SOAP, OIL, TEMPER = [1, 1.33, 1], [1, 1.47, 1.33], [1, 2.2, 2.9 + 3.1j]


@pytest.mark.parametrize("pol", "spu")
@pytest.mark.parametrize(
    ("model", "n"),
    [
        ("airy", OIL),
        ("opaque_base", TEMPER),
        ("free_film", SOAP),
        ("etalon", SOAP),
        ("recursion", TEMPER),
        ("recursion", [1.5, 1, 1.5]),
    ],
)
def test_exact_forms_agree_with_the_stack(model, n, pol):
    d_nm = np.linspace(0, 1500, 61)[:, None]
    angle, nm = np.array([0.0, 30.0, 75.0, 89.0]), 550.0
    reflected = nacre.film_reflectance(model, n, d_nm, angle, nm, pol)
    exact = nacre.stack(n, d_nm[..., None], angle, nm, pol).R
    assert reflected.shape == (61, 4)
    np.testing.assert_allclose(reflected, exact, rtol=0, atol=1e-12)


def test_the_series_loses_energy():
    d_nm = np.arange(0.0, 1001.0)
    reflected = nacre.film_reflectance("series", [1, 2.4, 3.5], d_nm, 0, 550)
    error = reflected - nacre.stack([1, 2.4, 3.5], d_nm[:, None], 0, 550).R
    assert np.abs(error).max() == pytest.approx(9.41e-4, rel=1e-2)


def test_etalon_of_given_mirrors():
    d_nm = np.linspace(0, 1000, 11)
    reflected = nacre.film_reflectance("etalon", [1, 1.5, 1], d_nm, 0, 600, mirror_reflectance=0.9)
    expected = 1 - 1 / (1 + 360 * np.sin(2 * np.pi * 1.5 * d_nm / 600) ** 2)
    np.testing.assert_allclose(reflected, expected, rtol=0, atol=1e-10)


def test_media_broadcast():
    n = np.array([SOAP, OIL])[:, None]
    reflected = nacre.film_reflectance("airy", n, [100.0, 200.0, 300.0], 10, 550)
    assert reflected.shape == (2, 3)
    assert reflected[1, 2] == nacre.film_reflectance("airy", OIL, 300, 10, 550)


def test_slits():
    angle = np.linspace(-60, 60, 241)
    sine = np.sin(np.radians(angle))
    one = nacre.slit_intensity(2000, angle, 550)
    np.testing.assert_allclose(one, np.sinc(2000 * sine / 550) ** 2, rtol=0, atol=1e-13)
    two = nacre.slit_intensity(2000, angle, 550, spacing_nm=6000)
    fringes = np.cos(np.pi * 6000 * sine / 550) ** 2
    np.testing.assert_allclose(two, one * fringes, rtol=0, atol=1e-13)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"model": "magic"},
            "model: must be one of path_difference, airy, series, opaque_base, free_film, etalon, "
            "recursion (got 'magic')",
        ),
        ({"n": [1, 1.5]}, "n: must list ambient, film and base (got shape (2,))"),
        (
            {"n": [1, 1.5 + 0.1j, 1]},
            "n: must be clear in ambient and film; nacre.stack takes absorbing films",
        ),
        ({"angle_deg": [0, 90]}, "angle_deg: must be in [0, 90) (got 90) (item 1)"),
        ({"pol": "x"}, "pol: must be 's', 'p' or 'u' (got 'x')"),
        ({"mirror_reflectance": 0.5}, "mirror_reflectance: belongs to the model 'etalon'"),
        (
            {"model": "etalon", "mirror_reflectance": 1},
            "mirror_reflectance: must be in [0, 1)",
        ),
        ({"d_nm": [1, 2], "wavelength_nm": [1, 2, 3]}, "n_ambient, n_film, n_base,"),
    ],
)
def test_bad_input(change, message):
    good = {"model": "airy", "n": OIL, "d_nm": 300, "angle_deg": 0, "wavelength_nm": 550}
    with pytest.raises(nacre.NacreError) as caught:
        nacre.film_reflectance(**{**good, **change})
    assert str(caught.value).startswith(message)


def test_total_reflection_is_outside_the_domain():
    with pytest.raises(nacre.NacreError, match=r"\(item 1\)"):
        nacre.film_reflectance("airy", [1.5, 1.0, 1.5], 300, [30, 60], 550)


def test_bad_slits():
    with pytest.raises(nacre.NacreError, match=r"width_nm: .*\(item 0\)"):
        nacre.slit_intensity(0, 0, 550)
    with pytest.raises(nacre.NacreError, match=r"angle_deg: must be in \[-90, 90\]"):
        nacre.slit_intensity(1000, 91, 550)
