# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Header functions, run inside Cycles, against the same formulas in double precision."""

from __future__ import annotations

import numpy as np
import pytest

from support.osl import osl_array

tmm = pytest.importorskip("tmm")


def test_complex_arithmetic(blender):
    rng = np.random.default_rng(1)
    a = rng.normal(size=16) + 1j * rng.normal(size=16)
    b = rng.normal(size=16) + 1j * rng.normal(size=16)
    body = (
        osl_array("ar", a.real)
        + osl_array("ai", a.imag)
        + osl_array("br", b.real)
        + osl_array("bi", b.imag)
        + """
    nacre_complex a = { ar[i % 16], ai[i % 16] };
    nacre_complex b = { br[i % 16], bi[i % 16] };
    nacre_complex c;
    if (i < 16) c = a + b;
    else if (i < 32) c = a - b;
    else if (i < 48) c = a * b;
    else if (i < 64) c = a / b;
    else if (i < 80) c = nacre_sqrt_upper(a);
    else c = nacre_exp_i(a);
    value = color(c.re, c.im, 0.0);"""
    )
    got = blender.values(["nacre_complex.h"], body, 96)
    root = np.sqrt(a)
    root = np.where(root.imag < 0, -root, root)
    expected = np.concatenate([a + b, a - b, a * b, a / b, root, np.exp(1j * a)])
    got = got[:, 0] + 1j * got[:, 1]
    np.testing.assert_allclose(got[:80], expected[:80], rtol=2e-6, atol=1e-6)
    # OSL's own exp and sincos are approximations, good to about 1e-5.
    np.testing.assert_allclose(got[80:], expected[80:], rtol=2e-5, atol=1e-6)


def test_root_takes_the_branch_that_carries_power(blender):
    """On the real axis: forward for a clear medium, decaying past the critical angle."""
    body = """
    nacre_complex z = { i == 0 ? 4.0 : -4.0, 0.0 };
    nacre_complex c = nacre_sqrt_upper(z);
    value = color(c.re, c.im, 0.0);"""
    got = blender.values(["nacre_complex.h"], body, 2)
    np.testing.assert_allclose(got[:, :2], [[2.0, 0.0], [0.0, 2.0]])


INTERFACES = [
    (1.0, 1.5 + 0j),
    (1.5, 1.0 + 0j),
    (1.0, 0.1 + 3.0j),
    (1.33, 2.9 + 3.1j),
    (1.0, 1.0 + 0j),
]
COSINES = [1.0, 0.9, 0.55, 0.2, 0.01]


def test_reflectance_of_an_interface(blender):
    """Dielectric, total reflection, metals, matched media; five angles each."""
    body = (
        osl_array("n_i", [n for n, _ in INTERFACES])
        + osl_array("re", [n.real for _, n in INTERFACES])
        + osl_array("im", [n.imag for _, n in INTERFACES])
        + osl_array("cosines", COSINES)
        + """
    nacre_complex n_t = { re[i / 5], im[i / 5] };
    value = nacre_reflectance(n_i[i / 5], n_t, cosines[i % 5]);"""
    )
    got = blender.values(["nacre_fresnel.h"], body, 25)[:, 0]
    expected = [
        tmm.unpolarized_RT([n_i, n_t], [np.inf, np.inf], np.arccos(c), 1.0)["R"]
        for n_i, n_t in INTERFACES
        for c in COSINES
    ]
    np.testing.assert_allclose(got, expected, rtol=1e-5, atol=2e-6)


FILMS = [
    # film, substrate, nm
    (1.33, 1.0, 400.0),
    (2.45, 1.5, 55.0),
    (2.4 + 0.3j, 2.9 + 3.1j, 40.0),
    (1.38, 1.52, 99.6),
    (1.46, 0.05 + 4.0j, 1800.0),
    (1.5 + 2.0j, 1.0, 5e4),
]


def test_film_reflectance(blender):
    """Clear, absorbing and opaque films on clear and metallic substrates, at 450 and 650 nm."""
    body = (
        osl_array("film_re", [complex(f[0]).real for f in FILMS])
        + osl_array("film_im", [complex(f[0]).imag for f in FILMS])
        + osl_array("sub_re", [complex(f[1]).real for f in FILMS])
        + osl_array("sub_im", [complex(f[1]).imag for f in FILMS])
        + osl_array("nm", [f[2] for f in FILMS])
        + osl_array("cosines", COSINES)
        + """
    int f = i / 10;
    nacre_complex n_1 = { film_re[f], film_im[f] };
    nacre_complex n_2 = { sub_re[f], sub_im[f] };
    value = nacre_film_reflectance(1.0, n_1, n_2, nm[f], cosines[i % 5],
                                   (i / 5) % 2 == 0 ? 450.0 : 650.0);"""
    )
    got = blender.values(["nacre_film.h"], body, 60)[:, 0]
    expected = [
        tmm.unpolarized_RT([1.0, n_1, n_2], [np.inf, d, np.inf], np.arccos(c), wavelength)["R"]
        for n_1, n_2, d in FILMS
        for wavelength in (450.0, 650.0)
        for c in COSINES
    ]
    np.testing.assert_allclose(got, expected, rtol=3e-5, atol=1e-5)


def sellmeier(b, c, nm):
    l2 = (np.asarray(nm) * 1e-3) ** 2
    return np.sqrt(1.0 + sum(bi * l2 / (l2 - ci) for bi, ci in zip(b, c, strict=True)))


# SCHOTT data sheet N-BK7; the catalogue prints n_F 1.52238, n_d 1.51680, n_C 1.51432.
BK7 = (
    [1.03961212, 0.231792344, 1.01046945],
    [0.00600069867, 0.0200179144, 103.560653],
)
LINES = [486.1327, 587.5618, 656.2725]


def test_sellmeier_gives_the_catalogue_indices(blender):
    body = (
        osl_array("b", BK7[0])
        + osl_array("c", BK7[1])
        + osl_array("nm", LINES)
        + "value = nacre_sellmeier(b, c, nm[i]);"
    )
    got = blender.values(["nacre_dispersion.h"], body, 3)[:, 0]
    np.testing.assert_allclose(got, [1.52238, 1.51680, 1.51432], atol=5e-6)
    np.testing.assert_allclose(got, sellmeier(*BK7, LINES), atol=3e-7)


def test_index_between_knots(blender):
    """Cubics through knots 10 nm apart, at both ends and in between."""
    wavelengths = np.linspace(360.0, 830.0, 95)
    body = (
        osl_array("knots", sellmeier(*BK7, np.arange(360.0, 831.0, 10.0)))
        + "value = nacre_index(knots, 360.0, 10.0, 360.0 + 5.0 * i);"
    )
    got = blender.values(["nacre_dispersion.h"], body, 95)[:, 0]
    np.testing.assert_allclose(got, sellmeier(*BK7, wavelengths), atol=5e-7)


def test_abbe_curve_has_its_abbe_number(blender):
    body = osl_array("nm", LINES) + (
        "value = nacre_cauchy(0.0, nacre_abbe_slope(1.6, 30.0), 0.0, nm[i]);"
    )
    blue, _, red = blender.values(["nacre_dispersion.h"], body, 3)[:, 0]
    assert 0.6 / (blue - red) == pytest.approx(30.0, rel=1e-5)


PROFILES = [(0, 2.0, 0.5), (0, 7.5, 0.5), (1, 2.3, 0.3125), (1, np.pi, 0.5), (2, 6.9, 0.5)]


def phase_profile(kind: int, phase: float, duty: float, samples: int = 1 << 14) -> np.ndarray:
    """Phase over one period; the Fourier series of exp(i phase) gives the amplitudes."""
    x = (np.arange(samples) + 0.5) / samples
    if kind == 0:
        return 0.5 * phase * np.sin(2.0 * np.pi * x)
    if kind == 1:
        return np.where(x < duty, phase, 0.0)
    return phase * x


def test_efficiencies_are_fourier_coefficients(blender):
    orders = range(-6, 7)
    body = "int kind[5] = { 0, 0, 1, 1, 2 };\n"
    body += osl_array("phase", [p[1] for p in PROFILES])
    body += osl_array("duty", [p[2] for p in PROFILES])
    body += """
    int j = i / 13;
    nacre_grating grating = { kind[j], phase[j], duty[j] };
    value = nacre_efficiency(grating, i % 13 - 6);"""
    got = blender.values(["nacre_grating.h"], body, 13 * len(PROFILES))[:, 0]
    expected = []
    for profile in PROFILES:
        spectrum = np.fft.fft(np.exp(1j * phase_profile(*profile))) / (1 << 14)
        expected += [abs(spectrum[m]) ** 2 for m in orders]
    np.testing.assert_allclose(got, expected, atol=2e-5)


def test_grating_equation_in_conical_mounting(blender):
    """An order's tangential direction, and the share of light in orders that propagate."""
    body = """
    vector lateral = vector(0.3, -0.2, 0.0);
    vector across = vector(0.6, 0.8, 0.0);
    nacre_grating grating = { 1, 2.0, 0.4 };
    if (i < 5)
        value = (color)nacre_order_direction(lateral, across, 550.0 / 1600.0, i - 2);
    else
        value = nacre_propagating_share(grating, lateral, across, 550.0 / 1600.0);"""
    got = blender.values(["nacre_grating.h"], body, 6)
    lateral, across = np.array([0.3, -0.2, 0.0]), np.array([0.6, 0.8, 0.0])
    ratio = 550.0 / 1600.0
    expected = [lateral + m * ratio * across for m in range(-2, 3)]
    np.testing.assert_allclose(got[:5], expected, atol=1e-6)

    def efficiency(m):
        if m == 0:
            return 1.0 - 2.0 * 0.4 * 0.6 * (1.0 - np.cos(2.0))
        return 2.0 * (1.0 - np.cos(2.0)) * (np.sin(np.pi * m * 0.4) / (np.pi * m)) ** 2

    share = sum(
        efficiency(m) for m in range(-9, 10) if np.linalg.norm(lateral + m * ratio * across) < 1
    )
    np.testing.assert_allclose(got[5], share, rtol=1e-5)


def test_wavelength_of_a_path(blender):
    """A cell's ends, its middle, and numbers outside [0, 1)."""
    body = """
    float edges[3] = { 400.0, 500.0, 700.0 };
    color weight[2] = { color(-0.5, 1.0, 2.0), color(2.5, 1.0, 0.0) };
    float chosen[5] = { 0.0, 0.25, 0.5, 0.75, 0.9999 };
    nacre_wavelength drawn = nacre_draw_wavelength(edges, weight, chosen[i]);
    value = color(drawn.nm, drawn.weight[0], drawn.weight[2]);"""
    got = blender.values(["nacre_wavelength.h"], body, 5)
    expected = [
        [400.0, -0.5, 2.0],
        [450.0, -0.5, 2.0],
        [500.0, 2.5, 0.0],
        [600.0, 2.5, 0.0],
        [699.96, 2.5, 0.0],
    ]
    np.testing.assert_allclose(got, expected, rtol=1e-6)


def test_colour_of_a_metal_is_the_mean_over_its_wavelengths(blender):
    """Saturated ones too; and no wavelength gets more than nothing taken from it by white."""
    body = """
    color tints[5] = { color(1.0), color(1.0, 0.5, 0.25), color(0.0, 0.0, 1.0), color(0.0, 1.0, 0.0),
                       color(1.0, 0.0, 0.0) };
    color weight[NACRE_CELLS] = NACRE_WAVELENGTH_WEIGHT;
    color basis[NACRE_CELLS] = NACRE_TINT_BASIS;
    for (int j = 0; j < NACRE_CELLS; j++) {
        float scalar = nacre_at_wavelength(tints[i % 5], basis[j]);
        if (i < 5)
            value += weight[j] * scalar / NACRE_CELLS;
        else
            value = max(value, color(fabs(scalar - 1.0)));
    }"""
    got = blender.values(["nacre_colour_tables.h", "nacre_wavelength.h"], body, 6)
    expected = [[1, 1, 1], [1, 0.5, 0.25], [0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, 0]]
    np.testing.assert_allclose(got, expected, atol=1e-5)


def test_mean_weight_of_all_cells_is_white(blender):
    body = """
    color weight[NACRE_CELLS] = NACRE_WAVELENGTH_WEIGHT;
    color cumulative[NACRE_CUMULATIVE_SIZE] = NACRE_CUMULATIVE_WEIGHT;
    if (i == 0)
        for (int j = 0; j < NACRE_CELLS; j++)
            value += weight[j] / NACRE_CELLS;
    else
        value = nacre_cumulative(cumulative, i == 1 ? 0.0 : 470.0);"""
    got = blender.values(["nacre_colour_tables.h"], body, 3)
    np.testing.assert_allclose(got, [[1, 1, 1], [0, 0, 0], [1, 1, 1]], atol=2e-6)


def test_wavelengths_at_different_depths_are_independent(blender):
    """White through two and three surfaces stays white: the mean product of their weights is 1."""
    body = """
    float edges[NACRE_EDGES] = NACRE_WAVELENGTH_EDGES;
    color weight[NACRE_CELLS] = NACRE_WAVELENGTH_WEIGHT;
    int numbers = 65536;
    for (int j = 0; j < numbers; j++) {
        float u = (j + 0.5) / numbers;
        nacre_wavelength bent = nacre_draw_wavelength(edges, weight, u);
        nacre_wavelength seen =
            nacre_draw_wavelength(edges, weight, nacre_second_random(u, NACRE_CELLS));
        nacre_wavelength first = nacre_draw_wavelength(edges, weight, nacre_later_random(u, 1));
        nacre_wavelength second = nacre_draw_wavelength(edges, weight, nacre_later_random(u, 2));
        if (i == 0) value += first.weight;
        else if (i == 1) value += bent.weight * first.weight;
        else if (i == 2) value += bent.weight * second.weight;
        else if (i == 3) value += seen.weight * first.weight;
        else if (i == 4) value += first.weight * second.weight;
        else value += bent.weight * first.weight * second.weight;
    }
    value /= numbers;"""
    got = blender.values(["nacre_colour_tables.h", "nacre_wavelength.h"], body, 6)
    np.testing.assert_allclose(got[:5], 1.0, atol=1e-3)
    np.testing.assert_allclose(got[5], 1.0, atol=3e-3)


def test_table_holds_the_ends_of_its_axes_at_the_edges(blender):
    """Both corners of the diagonal, the middle, and values beyond the axes; row 0 is y = 0."""
    x, y = np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 3))
    path = blender.write_table(np.stack([x, y, np.ones_like(x)], axis=-1))
    body = (
        osl_array("xs", [0.0, 1.0, 0.5, 0.1, -1.0, 2.0])
        + osl_array("ys", [0.0, 1.0, 0.5, 0.8, -1.0, 2.0])
        + f'value = nacre_table("{path}", xs[i], ys[i], 5, 3, {blender.table_origin_top});'
    )
    got = blender.values(["nacre_table.h"], body, 6)
    expected = [[0, 0, 1], [1, 1, 1], [0.5, 0.5, 1], [0.1, 0.8, 1], [0, 0, 1], [1, 1, 1]]
    np.testing.assert_allclose(got, expected, atol=2e-3)


def test_direction_of_t_is_what_the_version_says(blender):
    """Cycles changed it after 5.1. A table of two rows shows which way up a texture is."""
    path = blender.write_table([[[1.0, 0.0, 0.0]], [[0.0, 0.0, 1.0]]])
    body = f'value = (color)texture("{path}", 0.5, 0.25, 0.0, 0.0, 0.0, 0.0);'
    got = blender.values([], body, 1)[0]
    top_row_is_at_low_t = got[0] > got[2]
    assert top_row_is_at_low_t == bool(blender.table_origin_top), got
