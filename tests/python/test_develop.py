# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.develop` against colour-science."""

from __future__ import annotations

import colour
import numpy as np
import pytest

import nacre
from nacre import develop, library
from support.spectral import light_at, observer_at, reflectance_at

D65 = colour.xy_to_XYZ((0.3127, 0.3290))
CHART = [key for key in library.keys("spectra") if key.startswith("colorchecker/")]


@pytest.fixture(scope="module")
def bands():
    return nacre.bands(60, ["E", "A"])


@pytest.fixture(scope="module")
def under_a(bands):
    """Radiances of the chart and of white."""
    light = bands.in_bands("A")
    power = light / bands.xyz(light)[1]
    patches = [reflectance_at(key, bands.wavelength_nm) for key in CHART]
    return np.array([*patches, np.ones(len(bands))]) * power, power


def exact_under_a(observer):
    nm, power = light_at("A")
    surfaces = [*(reflectance_at(key, nm) for key in CHART), np.ones(len(nm))]
    seen = np.array(surfaces) @ (observer_at(nm, observer) * power[:, None])
    return seen / seen[-1, 1]


@pytest.mark.parametrize(
    ("observer", "adaptation"),
    [("cie1931", "bradford"), ("cie1931", "cat16"), ("cie1964", "bradford")],
)
def test_an_eye_that_adapts_sees_as_colour_science_says(bands, under_a, observer, adaptation):
    radiance, power = under_a
    found = radiance @ develop.colours(bands, observer=observer, white=power, adaptation=adaptation)
    exact = exact_under_a(observer)
    transform = {"bradford": "Bradford", "cat16": "CAT16"}[adaptation]
    wanted = colour.adaptation.chromatic_adaptation_VonKries(exact, exact[-1], D65, transform)
    np.testing.assert_allclose(found[-1] / found[-1, 1], D65, atol=1e-12)
    errors = colour.delta_E(
        *(colour.XYZ_to_Lab(xyz / xyz[-1, 1], (0.3127, 0.3290)) for xyz in (found, wanted))
    )
    assert errors.max() < 0.1, errors


def test_a_camera_that_sees_as_the_eye_does_shows_what_it_sees(bands, under_a):
    radiance, power = under_a
    nm = np.arange(360.0, 831.0)
    eye = develop.Sensitivities(nm, np.maximum(observer_at(nm).T, 0.0))
    by_camera = radiance @ develop.colours(bands, camera=eye, white=power)
    by_eye = radiance @ develop.colours(bands, white=power)
    np.testing.assert_allclose(by_camera, by_eye, atol=2e-4)


def test_real_cameras_are_near_the_eye_and_not_it(bands, under_a):
    radiance, power = under_a
    by_eye = radiance @ develop.colours(bands, white=power)
    assert develop.cameras() == ["nikon-d5100", "sigma-sd1-merrill"]
    for key in develop.cameras():
        found = radiance @ develop.colours(bands, camera=key, white=power)
        np.testing.assert_allclose(found[-1], by_eye[-1], atol=1e-9)
        errors = colour.delta_E(
            *(colour.XYZ_to_Lab(xyz / xyz[-1, 1], (0.3127, 0.3290)) for xyz in (found, by_eye))
        )
        assert 0.2 < errors[:-1].mean() < 3.0, (key, errors)
        raw = radiance @ develop.colours(bands, camera=key, raw=True, white=power, exposure=1.0)
        np.testing.assert_allclose(raw[-1], 2.0, atol=1e-9)


def test_an_exchanged_lamp_is_as_if_it_had_been_there(bands, under_a):
    radiance, power = under_a
    exchanged = radiance * develop.exchange(bands, power, "E", "A")
    there = radiance / power * bands.in_bands("E")
    np.testing.assert_allclose(
        exchanged / bands.xyz(exchanged[-1])[1], there / bands.xyz(there[-1])[1], atol=1e-9
    )


def test_metamerism_is_that_of_what_is_seen(bands, under_a):
    radiance, power = under_a
    found = develop.metamerism(bands, radiance[3], radiance[8], power, "E", "A")
    there = bands.xyz(radiance / power * bands.in_bands("E"))
    lab = colour.XYZ_to_Lab(there / there[-1, 1], colour.XYZ_to_xy(there[-1]))
    assert found.difference == pytest.approx(colour.delta_E(lab[3], lab[8]), abs=0.02)
    assert found.index < found.difference


def test_bands_of_a_file_are_those_that_were_written(bands):
    read = develop.bands_of(bands.wavelength_nm, bands.edges_nm, bands.is_line, bands.observer)
    np.testing.assert_allclose(read.XYZ, bands.XYZ, atol=1e-12)
    around = develop.bands_of([400.0, 500.0, 540.0, 700.0], observer="cie1964")
    np.testing.assert_allclose(around.edges_nm, [360, 450, 520, 620, 830])
    assert around.observer == "cie1964"


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda b: develop.colours(b, white=np.zeros(len(b))), "white: is black"),
        (lambda b: develop.colours(b, white=[1.0]), r"white: must have shape \(60,\)"),
        (lambda b: develop.colours(b, raw=True), "raw: is of a camera"),
        (lambda b: develop.colours(b, camera="pinhole"), "camera: must be one of nikon-d5100"),
        (lambda b: develop.colours(b, observer="cat"), "observer"),
        (lambda b: develop.colours(b, exposure=np.nan), "exposure: must be finite"),
        (
            lambda b: develop.colours(b, camera=develop.Sensitivities([400, 700], [[1, -1]] * 3)),
            "sensitivity",
        ),
        (lambda b: develop.exchange(b, b.in_bands("line:650"), "A", "Laser"), "Laser has no light"),
        (lambda _: develop.bands_of([500.0, 400.0]), "wavelength_nm: must be within its band"),
        (lambda _: develop.bands_of([500.0], [360.0, 800.0]), "edges_nm: must be from 360 to 830"),
    ],
)
def test_bad_input_is_refused(bands, call, message):
    with pytest.raises(nacre.NacreError, match=message):
        call(bands)
