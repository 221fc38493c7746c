# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.stack` against the tmm package (Byrnes 2016) and against 60 digits."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
import tmm
from exact import exact_stack
from hypothesis import given, settings
from hypothesis import strategies as st

import nacre


def layers(count, seed, k=0.0, thickest=300.0):
    draw = random.Random(seed)
    n = [complex(draw.uniform(1.2, 2.6), draw.uniform(0.0, k)) for _ in range(count)]
    return n, [draw.uniform(20.0, thickest) for _ in range(count)]


def quarter_waves(pattern, high=2.4, low=1.46, wavelength=550.0):
    n = [high if letter == "H" else low for letter in pattern]
    return n, [wavelength / 4 / index for index in n]


CLEAR_40, CLEAR_40_NM = layers(40, 1)
CLEAR_64, CLEAR_64_NM = layers(64, 2)
LOSSY_12, LOSSY_12_NM = layers(12, 3, k=0.05)
LOSSY_40, LOSSY_40_NM = layers(40, 4, k=0.3)
MIRROR, MIRROR_NM = quarter_waves("HL" * 7 + "H")
CAVITY, CAVITY_NM = quarter_waves("HLHLHL" + "HH" + "LHLHLH")
SILVER, GOLD, IRON, CHROME = 0.06 + 3.6j, 0.42 + 2.35j, 2.9 + 3.1j, 3.1 + 3.3j

# name: n from ambient to substrate, d in nm, angle in degrees, wavelength in nm
STACKS = {
    "bare-glass": ([1, 1.5], [], 0, 550),
    "bare-glass-brewster": ([1, 1.5], [], math.degrees(math.atan(1.5)), 550),
    "bare-gold-60": ([1, GOLD], [], 60, 550),
    "bare-gold-grazing": ([1, GOLD], [], 89.9, 550),
    "soap": ([1, 1.33, 1], [380], 45, 550),
    "black-soap": ([1, 1.33, 1], [6], 45, 550),
    "thick-soap": ([1, 1.33, 1], [20_000], 30, 550),
    "quarter-wave": ([1, 1.38, 1.52], [550 / 4 / 1.38], 0, 550),
    "half-wave": ([1, 2.4, 1.52], [550 / 2 / 2.4], 0, 550),
    "oil-on-water": ([1, 1.47, 1.333], [420], 50, 480),
    "no-contrast": ([1.3, 1.3, 1.3, 1.3], [100, 200], 70, 550),
    "zero-thickness": ([1, 2.4, GOLD, 1.33, 1.5], [0, 0, 0], 30, 550),
    "zero-in-the-middle": ([1, 2.4, SILVER, 1.46, 1.5], [60, 0, 90], 30, 550),
    "oxide-on-iron": ([1, 2.36 + 0.1j, IRON], [45], 20, 600),
    "silver-40": ([1, SILVER, 1.52], [40], 70, 550),
    "plasmon": ([1.515, SILVER, 1.0], [50], 43.5, 550),
    "absorbing-substrate": ([1, 2.1, 1.5 + 0.5j], [120], 75, 420),
    "ink": ([1, CHROME, 1.38, 1.0 + 6.6j], [8, 380], 10, 600),
    "ink-60": ([1.5, CHROME, 1.38, 1.0 + 6.6j], [8, 380], 60, 600),
    "total-reflection": ([1.5, 1.0], [], 60, 550),
    "total-reflection-under-films": ([1.5, 1.38, 2.4, 1.0], [150, 60], 45, 550),
    "frustrated-100": ([1.5, 1.0, 1.5], [100], 60, 550),
    "frustrated-2000": ([1.5, 1.0, 1.5], [2000], 60, 550),
    "past-critical-in-the-middle": ([1.5, 1.38, 1.0], [150], 50, 550),
    "near-critical": ([1.5, 1.0, 1.5], [800], math.degrees(math.asin(1 / 1.5)) + 1e-4, 550),
    "grazing-89.9": ([1, 1.33, 1.5], [500], 89.9, 550),
    "grazing-metal": ([1, 1.45, 0.2 + 3.4j], [100], 89.9, 550),
    "grazing-mirror": ([1, *MIRROR, 1.52], MIRROR_NM, 89.9, 550),
    "mirror-15": ([1, *MIRROR, 1.52], MIRROR_NM, 35, 550),
    "mirror-edge": ([1, *MIRROR, 1.52], MIRROR_NM, 0, 471),
    "cavity": ([1, *CAVITY, 1.52], CAVITY_NM, 0, 549.5),
    "40-clear": ([1, *CLEAR_40, 1.5], CLEAR_40_NM, 25, 633),
    "64-clear": ([1, *CLEAR_64, 1.5], CLEAR_64_NM, 60, 400),
    "12-lossy": ([1, *LOSSY_12, 1.5], LOSSY_12_NM, 50, 450),
    "40-lossy": ([1, *LOSSY_40, 1.5], LOSSY_40_NM, 10, 780),
    "dark-layer-5um": ([1, 1.6 + 0.02j, 1.5], [5000], 40, 550),
    "infrared-scale": ([1, 3.4, 1.4, 3.4], [1500, 3000], 20, 10_600),
}


@pytest.mark.parametrize("pol", ["s", "p"])
@pytest.mark.parametrize("name", STACKS)
def test_coherent_stacks_agree_with_tmm(name, pol):
    n, d_nm, angle, wavelength = STACKS[name]
    expected = tmm.coh_tmm(pol, n, [np.inf, *d_nm, np.inf], math.radians(angle), wavelength)
    ours = nacre.stack(n, d_nm, angle, wavelength, pol)
    assert ours.R == pytest.approx(expected["R"], abs=1e-12)
    assert ours.T == pytest.approx(expected["T"], abs=1e-12)
    assert ours.A == pytest.approx(1 - expected["R"] - expected["T"], abs=1e-12)
    assert abs(ours.r - expected["r"]) <= 1e-12
    assert abs(ours.t - expected["t"]) <= 1e-12 * max(1, abs(expected["t"]))


@pytest.mark.parametrize("name", STACKS)
def test_unpolarised_agrees_with_tmm(name):
    n, d_nm, angle, wavelength = STACKS[name]
    expected = tmm.unpolarized_RT(n, [np.inf, *d_nm, np.inf], math.radians(angle), wavelength)
    ours = nacre.stack(n, d_nm, angle, wavelength)
    assert ours.R == pytest.approx(expected["R"], abs=1e-12)
    assert ours.T == pytest.approx(expected["T"], abs=1e-12)
    assert ours.r is None
    assert ours.t is None


HARD = {
    "silver-50um": ([1, SILVER, 1.5], [50_000], 30, 550),
    "gold-50um-under-film": ([1, 1.38, GOLD, 1.5], [90, 50_000], 89.9, 550),
    "lossy-50um": ([1, 1.6 + 0.3j, 2.1, 1.5], [50_000, 70], 60, 550),
    "weak-50um": ([1, 1.6 + 1e-4j, 1.5], [50_000], 60, 550),
    "clear-1mm": ([1, 1.6, 2.4, 1.5], [1e6, 90], 60, 550),
    "gap-10um": ([1.5, 1.0, 1.5], [10_000], 60, 550),
    "gap-1mm": ([1.5, 1.0, 1.5], [1e6], 75, 550),
    "film-at-its-critical-angle": ([1.25, 0.75, 1.6], [300], 36.86989764584402, 550),
    "thick-film-at-its-critical-angle": ([1.25, 0.75, 1.6], [50_000], 36.86989764584402, 550),
    "film-near-its-critical-angle": ([1.25, 0.75, 1.6], [5000], 36.86989, 550),
    "substrate-near-its-critical-angle": ([1.25, 1.4, 0.75], [200], 36.8, 550),
    "grazing": ([1, 1.33, 1.5], [500], 89.9999, 550),
    "nearly-matched-at-grazing": ([1, 1 + 1e-9, 1.5], [500], 89.99, 550),
    "64-with-metal": ([1, *CLEAR_64[:32], SILVER, *CLEAR_64[33:], 1.5], CLEAR_64_NM, 45, 500),
    "64-lossy": ([1, *layers(64, 5, k=1.0)[0], 1.5], layers(64, 5, k=1.0)[1], 45, 500),
    "64-high-contrast": ([1, *[1.2, 4.0] * 32, 1.5], [90.0, 34.0] * 32, 45, 500),
    "sharp-cavity": (
        [1, *quarter_waves("HL" * 8 + "HH" + "LH" * 8)[0], 1.52],
        quarter_waves("HL" * 8 + "HH" + "LH" * 8)[1],
        0,
        550.001,
    ),
    "sharp-cavity-tilted": (
        [1.5, *quarter_waves("HL" * 9 + "LL" + "LH" * 9)[0], 1.52],
        quarter_waves("HL" * 9 + "LL" + "LH" * 9)[1],
        20,
        533.7,
    ),
    "plasmon-dip": ([1.8, 0.05 + 4.0j, 1.0], [55], 35.3, 600),
    "tiny-index": ([1, 0.05 + 1e-3j, 1.5], [200], 10, 400),
}


def random_stack(seed):
    """Clear, absorbing and metallic layers in any order, at any angle."""
    draw = random.Random(seed)
    n = [draw.uniform(1.0, 1.6)]
    for _ in range(draw.randint(5, 30)):
        kind = draw.random()
        k = 0.0 if kind < 0.5 else draw.uniform(0.0, 0.2 if kind < 0.85 else 5.0)
        n.append(complex(draw.uniform(0.2 if k > 0.2 else 1.2, 2.6), k))
    d_nm = [draw.uniform(0.0, 30.0 if medium.imag > 0.2 else 400.0) for medium in n[1:]]
    return [*n, 1.5], d_nm, draw.uniform(0.0, 89.0), draw.uniform(360.0, 830.0)


HARD |= {f"random-{seed}": random_stack(seed) for seed in range(12)}


@pytest.mark.parametrize("pol", ["s", "p"])
@pytest.mark.parametrize("name", [*STACKS, *HARD])
def test_stacks_agree_with_sixty_digits(name, pol):
    stack = STACKS.get(name) or HARD[name]
    expected = exact_stack(*stack, pol)
    ours = nacre.stack(*stack, pol)
    assert abs(ours.R - expected.R) <= 1e-12
    assert abs(ours.T - expected.T) <= 1e-12
    assert ours.T >= 0
    assert abs(ours.r - expected.r) <= 1e-12
    assert abs(ours.t - expected.t) <= 1e-12 * max(1, abs(expected.t))
    # What is weak keeps its digits, down to where double precision ends.
    if expected.T > 1e-290:
        assert abs(ours.T / expected.T - 1) <= 1e-9


indices = st.one_of(
    st.floats(1.0, 3.0).map(complex),
    st.tuples(st.floats(0.05, 4.0), st.floats(0.0, 6.0)).map(lambda pair: complex(*pair)),
)


@settings(max_examples=150, deadline=None, derandomize=True)
@given(
    film=st.lists(st.tuples(indices, st.floats(0, 2000)), max_size=8),
    substrate=indices,
    ambient=st.floats(1.0, 2.0),
    angle=st.floats(0, 89.99),
    wavelength=st.floats(200, 2000),
    pol=st.sampled_from("sp"),
)
def test_any_stack_agrees_with_sixty_digits(film, substrate, ambient, angle, wavelength, pol):
    n, d_nm = [ambient, *(layer[0] for layer in film), substrate], [layer[1] for layer in film]
    expected = exact_stack(n, d_nm, angle, wavelength, pol)
    ours = nacre.stack(n, d_nm, angle, wavelength, pol)
    # At the critical angle of the substrate the angle in double precision is all that there is.
    sine = ambient * math.sin(math.radians(angle))
    critical = abs(substrate.imag) < 1e-6 and abs(substrate.real - sine) < 1e-6
    tolerance = 1e-6 if critical else 1e-12
    assert abs(ours.R - expected.R) <= tolerance
    assert abs(ours.T - expected.T) <= tolerance


# name: n, d in nm, coherence of the layers ("c", "i"), angle, wavelength
INCOHERENT = {
    "window": ([1, 1.52, 1], [1e6], "i", 40, 550),
    "window-grazing": ([1, 1.52, 1], [1e6], "i", 89.9, 550),
    "coated-window": ([1, 1.38, 1.52, 1], [100, 1e6], "ci", 30, 550),
    "coated-on-both-sides": ([1, 1.38, 1.52, 1.38, 1], [100, 1e6, 100], "cic", 30, 550),
    "two-panes": ([1, 1.52, 1, 1.52, 1], [3e6, 1e7, 3e6], "iii", 55, 550),
    "mirror-on-pane": ([1, *MIRROR, 1.52, 1], [*MIRROR_NM, 1e6], "c" * 15 + "i", 20, 550),
    "tinted": ([1, 2.0, 1.52 + 1e-6j, 1], [80, 1e5], "ci", 20, 550),
    "tinted-over-silver": ([1, 1.52 + 1e-6j, SILVER], [1e5], "i", 20, 550),
    "silver-under-pane": ([1, 1.52, SILVER, 1.38, 1], [1e6, 30, 90], "icc", 65, 480),
    "wet": ([1, 1.333, 1.6, 1.333, 2.0], [1e6, 200, 2e6], "ici", 80, 700),
    "varnish": ([1, 1.5 + 2e-7j, 1.47, IRON], [3e4, 420], "ic", 45, 600),
}


@pytest.mark.parametrize("pol", ["s", "p"])
@pytest.mark.parametrize("name", INCOHERENT)
def test_incoherent_layers_agree_with_tmm(name, pol):
    n, d_nm, coherence, angle, wavelength = INCOHERENT[name]
    expected = tmm.inc_tmm(
        pol, n, [np.inf, *d_nm, np.inf], ["i", *coherence, "i"], math.radians(angle), wavelength
    )
    ours = nacre.stack(
        n, d_nm, angle, wavelength, pol, coherent=[letter == "c" for letter in coherence]
    )
    assert ours.R == pytest.approx(expected["R"], abs=1e-12)
    assert ours.T == pytest.approx(expected["T"], abs=1e-12)
    assert ours.r is None
    assert ours.t is None


def test_unpolarised_incoherent_is_the_mean():
    n, d_nm, coherence, angle, wavelength = INCOHERENT["wet"]
    flags = [letter == "c" for letter in coherence]
    s, p, u = (nacre.stack(n, d_nm, angle, wavelength, pol, flags) for pol in "spu")
    assert u.R == pytest.approx((s.R + p.R) / 2, abs=1e-15)
    assert u.T == pytest.approx((s.T + p.T) / 2, abs=1e-15)


def test_fifty_micrometres_of_metal_reflect_as_the_bulk():
    thick = nacre.stack([1, SILVER, 1.5], [50_000], 45, np.arange(360.0, 831.0))
    bulk = nacre.stack([1, SILVER], np.empty((0,)), 45, np.arange(360.0, 831.0))
    np.testing.assert_allclose(thick.R, bulk.R, rtol=0, atol=1e-15)
    assert np.all(np.isfinite(thick.T))
    assert np.all((thick.T >= 0) & (thick.T < 1e-300))
