# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.grating_orders`: the conical grating equation, and efficiencies against numpy's FFT."""

from __future__ import annotations

import math

import numpy as np
import pytest

import nacre

NORMAL, ACROSS, DOWN = np.array([0.0, 0, 1]), np.array([1.0, 0, 0]), np.array([0.0, 0, -1])


def unit(v):
    return np.asarray(v, float) / np.linalg.norm(v)


RANDOM = np.random.default_rng(1600)
MOUNTINGS = {
    "normal": (1600, ACROSS, NORMAL, DOWN, 550),
    "classical": (1600, ACROSS, NORMAL, [0.6, 0, -0.8], 633),
    "conical": (740, ACROSS, NORMAL, [0.0, 0.6, -0.8], 450),
    "oblique": (740, [1, 2, 0], NORMAL, [0.3, 0.6, -0.5], 450),
    "blu-ray": (320, ACROSS, NORMAL, [0.95, 0, -0.2], 405),
    "grazing": (1600, ACROSS, NORMAL, [0.7, 0.7, -0.01], 550),
    **{
        f"random-{i}": (
            RANDOM.uniform(400, 4000),
            unit(RANDOM.normal(size=3)),
            (normal := unit(RANDOM.normal(size=3))),
            unit(np.cross(normal, RANDOM.normal(size=3))) - RANDOM.uniform(0.1, 2) * normal,
            RANDOM.uniform(360, 830),
        )
        for i in range(20)
    },
}


@pytest.mark.parametrize("name", MOUNTINGS)
def test_directions_obey_the_grating_equation(name):
    pitch, vector, normal, k_in, wavelength = MOUNTINGS[name]
    result = nacre.grating_orders(pitch, vector, normal, k_in, wavelength, orders=(-6, 6))
    np.testing.assert_array_equal(result.order, np.arange(-6, 7))

    n, k = unit(normal), unit(k_in)
    g = unit(np.asarray(vector) - np.dot(vector, n) * n)
    tangential = k - np.dot(k, n) * n + result.order[:, None] * wavelength / pitch * g
    squared = 1 - (tangential**2).sum(axis=1)
    propagates = squared > 0
    np.testing.assert_array_equal(np.isnan(result.direction).any(axis=1), ~propagates)
    expected = tangential + np.sqrt(np.maximum(squared, 0))[:, None] * n
    np.testing.assert_allclose(
        result.direction[propagates], expected[propagates], rtol=0, atol=1e-12
    )
    mirror = k - 2 * np.dot(k, n) * n
    np.testing.assert_allclose(result.direction[6], mirror, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(result.efficiency[~propagates], 0)


@pytest.mark.parametrize("profile", ["sinusoidal", "rectangular", "blazed"])
@pytest.mark.parametrize("phase", [0.3, 1.0, math.pi, 2 * math.pi, 7.5, -2.0])
def test_efficiencies_are_fourier_coefficients(profile, phase):
    """Of exp(iφ(x)) over one period; a pitch of 2000 wavelengths keeps every order that counts."""
    samples, duty, reach = 1 << 15, 0.375, 12
    x = (np.arange(samples) + 0.5) / samples
    height = {"sinusoidal": np.sin(2 * np.pi * x) / 2, "rectangular": x < duty, "blazed": x}[
        profile
    ]
    spectrum = np.abs(np.fft.fft(np.exp(1j * phase * height)) / samples) ** 2
    result = nacre.grating_orders(
        2000 * 550, ACROSS, NORMAL, DOWN, 550, (-reach, reach), profile, phase, duty
    )
    # What lies beyond ±2000 orders, 1e-4 for edges, is spread over the orders by their share.
    kept = result.efficiency.sum() / spectrum[result.order].sum()
    assert kept == pytest.approx(1, abs=5e-4)
    np.testing.assert_allclose(result.efficiency / kept, spectrum[result.order], rtol=0, atol=1e-7)


@pytest.mark.parametrize("profile", ["sinusoidal", "rectangular", "blazed"])
def test_propagating_orders_share_all_of_the_light(profile):
    for mounting in MOUNTINGS.values():
        result = nacre.grating_orders(*mounting, (-30, 30), profile, 2.2, 0.3)
        assert result.efficiency.sum() == pytest.approx(1, abs=1e-13)
        assert (result.efficiency >= 0).all()
