# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Bands against colour-science, which sums every tenth of a nanometre."""

from __future__ import annotations

import re

import colour
import numpy as np
import pytest

import nacre
from nacre import library
from support.spectral import FINE, OBSERVERS, observer_at

SHAPE = colour.SpectralShape(360, 830, 1)
LASERS = nacre.Lines([462.0, 532.0, 638.0], [1.0, 0.8, 1.2])
LAMPS = ["D65", "A", "F2", "F11", "LED-B3", "lamp/hps", "lamp/lps"]
CHART = [
    library.spectrum(key) for key in library.keys("spectra") if key.startswith("colorchecker/")
]


def power_of(lamp):
    """Wavelengths and weights: a light as it is."""
    if isinstance(lamp, nacre.Lines):
        return np.asarray(lamp.wavelength_nm), np.asarray(lamp.power)
    if lamp in colour.SDS_ILLUMINANTS or lamp.startswith("F"):
        light = colour.SDS_ILLUMINANTS[lamp if lamp in colour.SDS_ILLUMINANTS else f"FL{lamp[1:]}"]
        return FINE, 0.1 * np.interp(FINE, light.wavelengths, light.values)
    found = library.spectrum(lamp)
    return FINE, 0.1 * np.interp(FINE, found.wavelength_nm, found.values)


def reflectance(patch, nm):
    samples = colour.SpectralDistribution(patch.values, patch.wavelength_nm)
    return np.interp(nm, np.arange(360, 831), samples.align(SHAPE).values)


def differences(bands, lamp):
    """CIEDE2000 of the chart, and how far white is off in XYZ, where its Y is 1."""
    nm, power = power_of(lamp)
    seen = observer_at(nm, bands.observer) * power[:, None]
    white = seen.sum(axis=0) / seen.sum(axis=0)[1]
    light = bands.in_bands(lamp)
    scale = 1.0 / bands.xyz(light)[1]
    exact = np.array([reflectance(patch, nm) @ seen for patch in CHART]) / seen.sum(axis=0)[1]
    banded = scale * np.array(
        [bands.xyz(light * reflectance(patch, bands.wavelength_nm)) for patch in CHART]
    )
    off_white = scale * bands.xyz(light) - white
    if white[2] < 1e-4:  # Z says nothing under sodium
        white[2], exact[:, 2], banded[:, 2] = 1.0, exact[:, 1], banded[:, 1]
    xy = colour.XYZ_to_xy(white)
    errors = colour.delta_E(colour.XYZ_to_Lab(banded, xy), colour.XYZ_to_Lab(exact, xy))
    return errors, off_white


@pytest.mark.parametrize("observer", OBSERVERS)
def test_emission_of_one_is_white(observer):
    bands = nacre.bands(24, observer=observer)
    seen = observer_at(FINE, observer)
    np.testing.assert_allclose(
        bands.xyz(np.ones(24)), seen.sum(axis=0) / seen[:, 1].sum(), rtol=1e-6
    )
    assert bands.XYZ.shape == (24, 3)
    assert bands.edges_nm[[0, -1]] == pytest.approx([360, 830])
    assert not bands.is_line.any()


@pytest.mark.parametrize("lamp", [*LAMPS, LASERS], ids=str)
def test_chart_under_one_lamp_in_eight_passes(lamp):
    errors, off_white = differences(nacre.bands(24, [lamp]), lamp)
    assert len(errors) == 24
    assert errors.mean() <= 0.1
    assert errors.max() <= 0.3
    np.testing.assert_allclose(off_white, 0.0, atol=1e-4)


@pytest.mark.parametrize("observer", OBSERVERS)
def test_chart_under_all_lamps_at_once(observer):
    lamps = [*LAMPS, LASERS]
    bands, choice = nacre.choose_bands(lamps, observer=observer)
    assert choice.met
    assert 8 <= choice.passes <= 16
    assert len(bands) == 3 * choice.passes
    assert choice.error.mean <= 0.1
    for lamp in lamps:
        errors, off_white = differences(bands, lamp)
        assert errors.mean() <= 0.1, lamp
        assert errors.max() <= 0.3, lamp
        np.testing.assert_allclose(off_white, 0.0, atol=1e-4)


def test_error_is_what_colour_science_finds():
    bands = nacre.bands(15, ["D65"])
    for lamp in ("D65", "F11", LASERS):
        errors, _ = differences(bands, lamp)
        nm = np.arange(360.0, 831.0)
        found = bands.error(lamp, nm, [reflectance(patch, nm) for patch in CHART])
        # A few thousandths: values between the nanometres are linear here and of fifth order there.
        assert found.mean == pytest.approx(errors.mean(), rel=0.02)
        assert found.max == pytest.approx(errors.max(), rel=0.02)


def test_lights_in_any_form_are_the_same():
    hps = library.spectrum("lamp/hps")
    bands = nacre.bands(24, ["D65"])
    by_name = bands.in_bands("lamp/hps")
    np.testing.assert_array_equal(by_name, bands.in_bands(hps))
    np.testing.assert_array_equal(
        by_name, bands.in_bands(nacre.LightSamples(hps.wavelength_nm, hps.values))
    )
    lines = bands.in_bands(LASERS)
    np.testing.assert_array_equal(lines, bands.in_bands("line:462@1,532@0.8,638@1.2"))
    both = bands.in_bands(nacre.LightSamples(hps.wavelength_nm, hps.values, LASERS))
    np.testing.assert_allclose(bands.xyz(both), bands.xyz(by_name) + bands.xyz(lines), rtol=1e-3)


def test_films_ask_for_more_passes_than_paint():
    _, paint = nacre.choose_bands(["D65"])
    _, film = nacre.choose_bands(["D65"], films_nm=[4000.0])
    _, glass = nacre.choose_bands(["D65"], wavelength_nm=[400, 700], spreads_px=[[0, 60], [0, 10]])
    assert (paint.passes, paint.held) == (8, "lights")
    assert film.passes > 16
    assert film.held == "films"
    assert 60 / 1.3 < 3 * glass.passes < 120
    assert glass.held == "spreads"
    _, paper = nacre.choose_bands(["F11"], wavelength_nm=[400, 700], reflectances=[1.0, 1.0])
    assert paper.error.max < 1e-3


FILM = """
schema = 1
[material]
id = "film"
name = "Film"
category = "Films"
description = "A film"
source = "made up"
[ambient]
medium = "air"
[[layer]]
n = 1.5
thickness_nm = { default = 300, min = 0, max = 600, varies = true }
[substrate]
n = 2.0
"""


def test_tables_of_a_film_in_bands():
    """Each pass has the reflectance at its three wavelengths, as the film's own spectrum has it."""
    bands = nacre.bands(24, ["F11"])
    passes = [[k, k + 8, k + 16] for k in range(8)]
    tables = nacre.band_tables(FILM, bands, passes, {"R": (7, 5)})
    assert tables["R"].shape == (8, 7, 5, 3)
    assert tables["R"].dtype == np.float32
    for row, thickness in ((0, 0.0), (3, 300.0), (6, 600.0)):
        spectrum = nacre.template_spectrum(FILM, thickness, np.degrees(np.arccos(0.75))).reflectance
        at_bands = np.interp(bands.wavelength_nm, np.arange(360, 831), spectrum)
        np.testing.assert_allclose(tables["R"][:, row, 3], at_bands[np.array(passes)], atol=2e-5)


@pytest.mark.parametrize("angle", [0.0, 60.0])
def test_fringes_are_those_of_the_thickest_films(angle):
    found = nacre.film_fringes(FILM, 3, angle_deg=angle)
    assert found.shape == (3, 471)
    thickest = nacre.template_spectrum(FILM, 600.0, angle).reflectance
    np.testing.assert_allclose(found[2], thickest, rtol=1e-12)
    thinnest = nacre.template_spectrum(FILM, 0.9 * 600.0, angle).reflectance
    np.testing.assert_allclose(found[0], thinnest, rtol=1e-12)
    for wrong in (-1.0, 90.0, float("nan")):
        with pytest.raises(nacre.NacreError, match="angle_deg: must be from 0 to below 90"):
            nacre.film_fringes(FILM, angle_deg=wrong)


def test_optical_thickness_is_that_of_the_thickest_film():
    assert nacre.optical_thickness(FILM) == pytest.approx(900.0, rel=1e-9)


@pytest.mark.parametrize(
    ("passes", "sizes", "message"),
    [
        ([[0, 1]], {}, "passes: must be whole numbers of shape (P, 3)"),
        ([[0.5, 1, 2]], {}, "passes: must be whole numbers"),
        ([[0, 1, 24]], {}, "passes: must be bands from 0 to 23"),
        ([[0, 1, -1]], {}, "passes: must be bands from 0 to 23"),
        ([[0, 1, 2]], {"Q": (1, 1)}, 'must be the name of a table (got "Q")'),
        ([[0, 1, 2]], {"R": (7, 5), "T": (7, 5)}, "film.toml: such a film has no table T"),
        ([[0, 1, 2]], {"R": (0, 5)}, "sizes['R']: must be above 0"),
    ],
)
def test_refusals_of_tables(passes, sizes, message):
    with pytest.raises(nacre.NacreError, match=re.escape(message)):
        nacre.band_tables(FILM, nacre.bands(24), passes, sizes, "film.toml")


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: nacre.bands(2), "bands: must be 3 … 300 (got 2)"),
        (lambda: nacre.bands(24.0), "count: must be a whole number (got 24.0)"),
        (lambda: nacre.bands(24, ["candle"]), "candle"),
        (lambda: nacre.bands(24, [7]), "light: must be a name, a Spectrum, Lines or LightSamples"),
        (lambda: nacre.bands(24, [CHART[0]]), "is a reflectance"),
        (lambda: nacre.bands(24, [nacre.Lines([], [])]), "lines: must be one or more"),
        (lambda: nacre.bands(24, [nacre.Lines([500], [1, 2])]), "lines: must have shape (1,)"),
        (lambda: nacre.bands(24, [nacre.Lines([900], [1])]), "900"),
        (lambda: nacre.bands(4, [LASERS]), "bands: must be 7 … 300, for all the lines (got 4)"),
        (lambda: nacre.bands(24, [nacre.LightSamples([], [])]), "power: must have two or more"),
        (
            lambda: nacre.bands(24, [nacre.LightSamples([400, 700], [1, -1])]),
            "must be ≥ 0 (got -1)",
        ),
        (lambda: nacre.bands(24, observer="cie2006"), "cie2006"),
        (lambda: nacre.bands(24).xyz(np.ones(23)), "values: must have shape (..., 24)"),
        (lambda: nacre.choose_bands([]), "lights: must be one or more"),
        (lambda: nacre.choose_bands(["D65"], mean_error=0.0), "must be > 0"),
        (lambda: nacre.choose_bands(["D65"], films_nm=[-1.0]), "film_nm: must be finite and > 0"),
        (
            lambda: nacre.choose_bands(["D65"], wavelength_nm=[400, 700], reflectances=[1.0]),
            "reflectances: must have shape (..., 2)",
        ),
    ],
)
def test_refusals(call, message):
    with pytest.raises(nacre.NacreError) as refusal:
        call()
    assert message in str(refusal.value)
