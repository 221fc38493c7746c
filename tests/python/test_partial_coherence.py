# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spread thicknesses, bands of wavelengths, and absorption layer by layer."""

import math

import numpy as np
import pytest
import tmm

import nacre

GOLD, SILVER = 0.47 + 2.41j, 0.05 + 3.3j


def gaussian(deviation, count=801, reach=8.0):
    """Nodes and weights of the trapezoidal rule, which is exact to rounding here."""
    x = np.linspace(-reach, reach, count)
    return x * deviation, np.exp(-x * x / 2) / math.sqrt(2 * math.pi) * (x[1] - x[0])


@pytest.mark.parametrize("pol", "sp")
@pytest.mark.parametrize("spread", [0.5, 20.0, 80.0])
@pytest.mark.parametrize("angle", [0.0, 50.0, 85.0])
def test_spread_is_the_mean_over_thickness(pol, spread, angle):
    n, d_nm = [1, 2.0, 1.45, 1.7, GOLD], [60.0, 1500.0, 90.0]
    got = nacre.stack(n, d_nm, angle, 550, pol, spread_nm=[0, spread, 0])
    offsets, weights = gaussian(spread)
    each = np.tile(d_nm, (offsets.size, 1))
    each[:, 1] += offsets
    plain = nacre.stack(n, each, angle, 550, pol)
    assert got.R == pytest.approx(plain.R @ weights, abs=1e-12)
    assert got.T == pytest.approx(plain.T @ weights, abs=1e-12)
    assert got.r is None
    assert got.t is None


def test_two_spreads_are_the_mean_over_both():
    n, d_nm, spreads = [1, 1.4, 1.9, 1.5, SILVER], [900.0, 70.0, 1200.0], [25.0, 0.0, 60.0]
    got = nacre.stack(n, d_nm, 40, 500, "p", spread_nm=spreads)
    (first, w), (last, v) = gaussian(25.0, 401), gaussian(60.0, 401)
    each = np.empty((401, 401, 3))
    each[..., 0] = d_nm[0] + first[:, None]
    each[..., 1] = d_nm[1]
    each[..., 2] = d_nm[2] + last
    assert got.R == pytest.approx(w @ nacre.stack(n, each, 40, 500, "p").R @ v, abs=1e-12)


def test_band_of_wavelengths():
    """At constant indices, of a single layer, over a band that is Gaussian in wavenumber."""
    nm, width = 600.0, 4.0
    got = nacre.stack([1, 1.33, 1], [30_000], 20, nm, bandwidth_nm=width)
    deviation = width / (2 * math.sqrt(2 * math.log(2))) / nm**2
    offsets, weights = gaussian(deviation)
    plain = nacre.stack([1, 1.33, 1], [30_000], 20, 1 / (1 / nm + offsets))
    assert got.R == pytest.approx(plain.R @ weights, abs=1e-12)


def test_thick_films_lose_their_fringes():
    nm = np.arange(400.0, 701.0)
    fringes = [
        np.ptp(nacre.stack([1, 1.5, 1], [d], 0, nm, bandwidth_nm=10).R)
        for d in (300, 3e3, 3e4, 3e5)
    ]
    assert fringes[0] > 0.1
    assert fringes[3] < 1e-12
    assert fringes == sorted(fringes, reverse=True)


COHERENT = {
    "gold-film": ([1, GOLD, 1.5], [30.0]),
    "tinted-on-silver": ([1, 1.5 + 0.02j, SILVER, 1.5], [400.0, 60.0]),
    "absorber-in-mirror": (
        [1, 2.3, 1.4, 2.0 + 0.1j, 1.4, 2.3, 1.5],
        [60.0, 95.0, 70.0, 95.0, 60.0],
    ),
    "frustrated": ([1.8, 1.0, 1.7 + 0.3j, 1.0], [120.0, 50.0]),
}


@pytest.mark.parametrize("pol", "sp")
@pytest.mark.parametrize("angle", [0, 35, 70])
@pytest.mark.parametrize("name", COHERENT)
def test_absorption_agrees_with_tmm(name, angle, pol):
    n, d_nm = COHERENT[name]
    data = tmm.coh_tmm(pol, n, [np.inf, *d_nm, np.inf], math.radians(angle), 550)
    expected = tmm.absorp_in_each_layer(data)[1:-1]
    got = nacre.stack(n, d_nm, angle, 550, pol, absorption=True)
    np.testing.assert_allclose(got.A_layers, expected, rtol=0, atol=1e-12)
    assert got.A_layers.sum() == pytest.approx(got.A, abs=1e-14)


INCOHERENT = {
    "tinted-pane": ([1, 1.52 + 1e-6j, 1], [1e6], "i"),
    "silver-under-pane": ([1, 1.52, SILVER, 1.38, 1], [1e6, 30, 90], "icc"),
    "coated-on-both-sides": ([1, GOLD, 1.52, 2.0 + 0.05j, 1], [10, 1e6, 100], "cic"),
    "and-tinted": ([1, GOLD, 1.52 + 1e-7j, 2.0 + 0.05j, 1], [10, 1e6, 100], "cic"),
    "three-coherent-layers": (
        [1, 1.52, 2.0 + 0.05j, SILVER, 1.9 + 0.1j, 1.52, 1],
        [1e6, 90, 10, 70, 2e6],
        "iccci",
    ),
    "two-panes": ([1, 1.52 + 1e-7j, 1, 1.5 + 2e-7j, SILVER, 1], [3e6, 1e7, 3e6, 40], "iiic"),
}


@pytest.mark.parametrize("pol", "sp")
@pytest.mark.parametrize("name", INCOHERENT)
def test_incoherent_absorption_agrees_with_tmm(name, pol):
    n, d_nm, letters = INCOHERENT[name]
    data = tmm.inc_tmm(pol, n, [np.inf, *d_nm, np.inf], ["i", *letters, "i"], 0.6, 550)
    got = nacre.stack(
        n,
        d_nm,
        math.degrees(0.6),
        550,
        pol,
        coherent=[letter == "c" for letter in letters],
        absorption=True,
    )
    expected = tmm.inc_absorp_in_each_layer(data)[1:-1]
    # In an absorbing medium what goes up and down carries power together, of the order of k; tmm
    # leaves it out where two incoherent layers meet, and its list then misses it in the sum.
    tinted = max(complex(n[j + 1]).imag for j, letter in enumerate(letters) if letter == "i")
    np.testing.assert_allclose(got.A_layers, expected, rtol=0, atol=1e-12 + 3 * tinted)
    assert got.A_layers.sum() == pytest.approx(got.A, abs=1e-13)


def test_absorption_broadcasts():
    n = np.array([[1, GOLD, 1.5], [1, SILVER, 1.5]])[:, None, None]
    angle, nm = np.array([0.0, 40.0, 80.0])[:, None], np.linspace(400, 700, 7)
    got = nacre.stack(n, [25.0], angle, nm, absorption=True)
    assert got.A_layers.shape == (2, 3, 7, 1)
    np.testing.assert_allclose(got.A_layers[..., 0], got.A, rtol=0, atol=1e-13)
    assert nacre.stack(n, [25.0], angle, nm).A_layers is None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"spread_nm": [1, 2]}, "spread_nm: must have 1 values (got (2,))"),
        ({"spread_nm": [-1]}, "spread_nm[0]: must be finite and ≥ 0 (got -1)"),
        (
            {"spread_nm": [5], "coherent": [False]},
            "spread_nm[0]: must be 0 in a layer that is incoherent (got 5)",
        ),
        ({"bandwidth_nm": math.nan}, "bandwidth_nm: must be finite and ≥ 0 (got nan)"),
        (
            {"spread_nm": [5], "absorption": True},
            "absorption: by layer is not known where layers have a spread or light a bandwidth",
        ),
    ],
)
def test_bad_coherence(change, message):
    with pytest.raises(nacre.NacreError) as caught:
        nacre.stack([1, 1.5, 1], [300], 0, 550, **change)
    assert str(caught.value) == message
