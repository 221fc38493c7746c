# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.spectrum_to_colour` against colour-science on the same 1 nm tables."""

from __future__ import annotations

import colour
import numpy as np
import pytest

import nacre

GRID = np.arange(360.0, 831.0)
FIVE, TEN = np.arange(380.0, 781.0, 5), np.arange(360.0, 831.0, 10)
SHAPE = colour.SpectralShape(360, 830, 1)
OBSERVERS = {
    "cie1931": "CIE 1931 2 Degree Standard Observer",
    "cie1964": "CIE 1964 10 Degree Standard Observer",
}
RANDOM = np.random.default_rng(36)


def bell(centre, width, wavelengths=GRID):
    return np.exp(-(((wavelengths - centre) / width) ** 2))


SPECTRA = {
    "white": (GRID, np.ones(471)),
    "bell-450": (GRID, bell(450, 15)),
    "bell-550": (GRID, bell(550, 60)),
    "line-589": (GRID, bell(589, 1)),
    "notch": (GRID, 1 - 0.95 * bell(580, 12)),
    "fringes": (GRID, np.cos(3e4 / GRID) ** 2),
    "ramp": (GRID, (GRID - 360) / 470),
    "rough": (GRID, RANDOM.random(471)),
    "bell-5nm": (FIVE, bell(520, 30, FIVE)),
    "rough-5nm": (FIVE, RANDOM.random(FIVE.size)),
    "rough-10nm": (TEN, RANDOM.random(TEN.size)),
    "film": (GRID, nacre.stack([1, 1.33, 1], [380], 30, GRID).R),
}


def on_grid(wavelengths, values):
    """Sprague's interpolation; the nearest sample outside, as CIE 15 recommends."""
    samples = colour.SpectralDistribution(values, wavelengths)
    return samples.align(SHAPE).values


def sums(wavelengths, values, observer, light):
    cmfs = colour.MSDS_CMFS[OBSERVERS[observer]].copy().align(SHAPE).values
    weighted = light[:, None] * cmfs
    return on_grid(wavelengths, values) @ weighted / weighted[:, 1].sum()


def illuminant(name):
    if name == "E":
        return np.ones(471)
    light = colour.SDS_ILLUMINANTS[name]
    return np.interp(GRID, light.wavelengths, light.values)


@pytest.mark.parametrize("observer", OBSERVERS)
@pytest.mark.parametrize("name", SPECTRA)
def test_emission_agrees_with_colour_science(name, observer):
    wavelengths, values = SPECTRA[name]
    expected = sums(wavelengths, values, observer, np.ones(471))
    ours = nacre.spectrum_to_colour(wavelengths, values, "emission", observer=observer)
    np.testing.assert_allclose(ours.XYZ, expected, rtol=0, atol=1e-9)
    white = [0.3127, 0.3290]
    if observer == "cie1964":
        white = colour.XYZ_to_xy(sums(GRID, np.ones(471), observer, illuminant("D65")))
    lab = colour.XYZ_to_Lab(expected, white)
    np.testing.assert_allclose(ours.Lab, lab, rtol=0, atol=1e-7)


@pytest.mark.parametrize("observer", OBSERVERS)
@pytest.mark.parametrize("light", ["D65", "A", "E"])
@pytest.mark.parametrize("name", SPECTRA)
def test_reflectance_agrees_with_colour_science(name, light, observer):
    wavelengths, values = SPECTRA[name]
    power = illuminant(light)
    expected = sums(wavelengths, values, observer, power)
    white = sums(GRID, np.ones(471), observer, power)
    ours = nacre.spectrum_to_colour(wavelengths, values, illuminant=light, observer=observer)
    np.testing.assert_allclose(ours.XYZ, expected, rtol=0, atol=1e-9)
    lab = colour.XYZ_to_Lab(expected, colour.XYZ_to_xy(white))
    np.testing.assert_allclose(ours.Lab, lab, rtol=0, atol=1e-6)


@pytest.mark.parametrize(
    ("space", "name"),
    [
        ("lin_rec709_scene", "ITU-R BT.709"),
        ("lin_rec2020_scene", "ITU-R BT.2020"),
        ("lin_ap1_scene", "ACEScg"),
    ],
)
def test_rgb_agrees_with_colour_science(space, name):
    target = colour.RGB_COLOURSPACES[name].copy()
    target.use_derived_matrix_RGB_to_XYZ = target.use_derived_matrix_XYZ_to_RGB = True
    for wavelengths, values in SPECTRA.values():
        ours = nacre.spectrum_to_colour(wavelengths, values, "emission", space=space)
        expected = colour.XYZ_to_RGB(
            ours.XYZ, target, illuminant=[0.3127, 0.3290], chromatic_adaptation_transform="Bradford"
        )
        # The white of the space is the sum of its primaries there and ours to all digits.
        np.testing.assert_allclose(ours.rgb, expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("light", ["D65", "A", "E", "D50", "D55", "D75"])
@pytest.mark.parametrize("space", ["lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene"])
def test_a_perfect_white_is_one(light, space):
    white = nacre.spectrum_to_colour([360, 830], [1, 1], illuminant=light, space=space)
    np.testing.assert_allclose(white.rgb, 1, rtol=0, atol=1e-12)
    assert white.XYZ[1] == pytest.approx(1, abs=1e-14)


def test_an_emission_is_relative_to_what_the_observer_sees_of_d65():
    warm = bell(600, 80)
    xyz = sums(GRID, warm, "cie1964", np.ones(471))
    white = sums(GRID, np.ones(471), "cie1964", illuminant("D65"))
    answer = nacre.spectrum_to_colour(GRID, warm, "emission", observer="cie1964", space="xyz_d65")
    d65 = colour.xy_to_XYZ((0.3127, 0.3290))
    adapted = colour.adaptation.chromatic_adaptation_VonKries(xyz, white, d65, "Bradford")
    np.testing.assert_allclose(answer.rgb, adapted, rtol=0, atol=1e-9)
    lab = colour.XYZ_to_Lab(xyz, colour.XYZ_to_xy(white))
    np.testing.assert_allclose(answer.Lab, lab, rtol=0, atol=1e-6)


def test_samples_outside_hold_the_nearest():
    inner = nacre.spectrum_to_colour([500.0, 600.0], [0.2, 0.8], "emission")
    values = np.interp(GRID, [500, 600], [0.2, 0.8])
    np.testing.assert_allclose(
        inner.XYZ, nacre.spectrum_to_colour(GRID, values, "emission").XYZ, rtol=0, atol=1e-14
    )


def test_spectra_of_an_array_are_those_one_by_one():
    values = RANDOM.random((4, 3, 471))
    together = nacre.spectrum_to_colour(GRID, values, illuminant="A")
    assert together.XYZ.shape == together.Lab.shape == together.rgb.shape == (4, 3, 3)
    for index in np.ndindex(4, 3):
        alone = nacre.spectrum_to_colour(GRID, values[index], illuminant="A")
        for part in ("XYZ", "Lab", "rgb"):
            np.testing.assert_array_equal(getattr(together, part)[index], getattr(alone, part))
    assert nacre.spectrum_to_colour(GRID, values[:0]).rgb.shape == (0, 3, 3)


def test_adaptation_is_that_of_colour_science():
    values = bell(550, 60)
    d65 = colour.xy_to_XYZ((0.3127, 0.3290))
    white = sums(GRID, np.ones(471), "cie1931", illuminant("A"))
    for ours, theirs in {"bradford": "Bradford", "cat16": "CAT16"}.items():
        answer = nacre.spectrum_to_colour(
            GRID, values, illuminant="A", space="xyz_d65", adaptation=ours
        )
        expected = colour.adaptation.chromatic_adaptation_VonKries(
            answer.XYZ, white, d65, transform=theirs
        )
        np.testing.assert_allclose(answer.rgb, expected, rtol=0, atol=1e-9)
    plain = nacre.spectrum_to_colour(
        GRID, values, illuminant="A", space="xyz_d65", adaptation="none"
    )
    np.testing.assert_array_equal(plain.rgb, plain.XYZ)


def test_gamut_mappings():
    values = bell(510, 15)
    kept = nacre.spectrum_to_colour(GRID, values).rgb
    assert kept.min() < 0
    assert kept.max() < 1
    clipped = nacre.spectrum_to_colour(GRID, values, gamut="clip").rgb
    np.testing.assert_array_equal(clipped, np.clip(kept, 0, 1))
    np.testing.assert_array_equal(
        nacre.spectrum_to_colour(GRID, values, gamut="scale").rgb, clipped
    )
    grey = nacre.spectrum_to_colour(GRID, values, gamut="desaturate").rgb
    luminance = nacre.spectrum_to_colour(GRID, values, space="xyz_d65").rgb[1]
    weights = np.linalg.inv(colour.RGB_COLOURSPACES["sRGB"].matrix_XYZ_to_RGB)[1]
    assert grey.min() >= 0
    assert weights @ grey == pytest.approx(luminance, abs=1e-3)


def test_a_light_keeps_its_colour_however_bright():
    bulb = nacre.illuminant("A") * 5.0
    kept = nacre.spectrum_to_colour(GRID, bulb, "emission").rgb
    assert kept.min() > 0
    assert kept.max() > 1
    mapped = nacre.spectrum_to_colour(GRID, bulb, "emission", gamut="desaturate").rgb
    np.testing.assert_array_equal(mapped, kept)
    white = nacre.spectrum_to_colour(GRID, np.full(471, 2.0), gamut="desaturate").rgb
    np.testing.assert_array_equal(white, 1.0)  # of a surface


def test_rgb_goes_to_a_spectrum_and_back():
    rgb = RANDOM.random((5, 40, 3))
    risen = nacre.rgb_to_spectrum(rgb)
    assert risen.values.shape == (5, 40, 471)
    assert risen.error_dE00.shape == (5, 40)
    assert risen.error_dE00.max() <= 1e-6
    assert risen.values.min() >= 0
    assert risen.values.max() <= 1
    back = nacre.spectrum_to_colour(risen.wavelength_nm, risen.values).rgb
    np.testing.assert_allclose(back, rgb, rtol=0, atol=1e-9)
    c0, c1, c2 = (risen.coefficients[..., i, None] for i in range(3))
    x = (c0 * GRID + c1) * GRID + c2
    np.testing.assert_allclose(risen.values, 0.5 + x / (2 * np.sqrt(1 + x * x)), atol=1e-9)


def test_one_rgb_and_the_older_method():
    risen = nacre.rgb_to_spectrum([0.6, 0.3, 0.1], "smits")
    assert risen.values.shape == (471,)
    assert risen.coefficients is None
    expected = colour.recovery.RGB_to_sd_Smits1999([0.6, 0.3, 0.1]).values
    np.testing.assert_allclose(risen.values[37::34][:10], expected, atol=1e-12)
    back = nacre.spectrum_to_colour(risen.wavelength_nm, risen.values).rgb
    assert np.abs(back - [0.6, 0.3, 0.1]).max() < 0.1


def test_a_light_of_the_white_is_d65():
    risen = nacre.rgb_to_spectrum([4, 4, 4], kind="emission")
    shape = risen.values / illuminant("D65")
    np.testing.assert_allclose(shape, shape[0], rtol=1e-12)
    light = nacre.spectrum_to_colour(risen.wavelength_nm, risen.values, "emission")
    assert light.XYZ[1] == pytest.approx(4, abs=1e-12)
    wide = nacre.rgb_to_spectrum([0.1, 0.5, 0.1], space="lin_ap1_scene")
    back = nacre.spectrum_to_colour(wide.wavelength_nm, wide.values, space="lin_ap1_scene").rgb
    np.testing.assert_allclose(back, [0.1, 0.5, 0.1], atol=1e-9)


def test_illuminants_by_name_and_form():
    for ours, theirs in (("D65", "D65"), ("A", "A"), ("F11", "FL11")):
        power = nacre.illuminant(ours)
        expected = colour.SDS_ILLUMINANTS[theirs].copy()
        at = np.arange(380, 781, 5)
        np.testing.assert_allclose(power[at - 360], [expected[nm] for nm in at], rtol=1e-12)
    line = nacre.illuminant("line:500.25@2")
    assert line[500 - 360 : 502 - 360].tolist() == [1.5, 0.5]
    assert line.sum() == 2.0
    with pytest.raises(nacre.NacreError, match="daylight"):
        nacre.illuminant("sun")


@pytest.mark.parametrize("kelvin", [1500, 2856, 4000, 6504, 15000])
def test_colour_temperature_of_black_bodies(kelvin):
    found = nacre.spectrum_to_colour(GRID, nacre.illuminant(f"blackbody:{kelvin}"), "emission")
    cct, duv = nacre.colour_temperature(found.XYZ)
    assert cct == pytest.approx(kelvin, abs=0.1)
    assert duv == pytest.approx(0, abs=1e-6)


def test_colour_temperature_has_the_shape_of_the_colours():
    d65, green = [0.95047, 1.0, 1.08883], [0.2, 1.0, 0.1]
    cct, duv = nacre.colour_temperature([[d65, green], [green, np.zeros(3)]])
    assert cct.shape == duv.shape == (2, 2)
    assert np.isnan(cct).tolist() == np.isnan(duv).tolist() == [[False, True], [True, True]]
    uv = colour.UCS_to_uv(colour.XYZ_to_UCS(d65))
    theirs = colour.temperature.uv_to_CCT_Ohno2013(uv)
    assert cct[0, 0] == pytest.approx(theirs[0], abs=0.5)
    assert duv[0, 0] == pytest.approx(theirs[1], abs=1e-5)
    with pytest.raises(nacre.NacreError, match=r"XYZ: must have shape \(\.\.\., 3\)"):
        nacre.colour_temperature([1.0, 2.0])


@pytest.mark.parametrize("observer", OBSERVERS)
def test_colour_matching_functions(observer):
    ours = nacre.colour_matching(observer)
    np.testing.assert_allclose(ours, colour.MSDS_CMFS[OBSERVERS[observer]].values, atol=1e-12)
    with pytest.raises(nacre.NacreError, match="cie1964"):
        nacre.colour_matching("eye")


def test_basis_has_the_colours_of_its_primaries():
    basis = nacre.rgb_basis()
    assert basis.shape == (471, 3)
    np.testing.assert_allclose(basis.sum(axis=1), 1.0, atol=1e-9)
    assert basis.min() >= 0.0
    assert basis.max() <= 1.0
    for rgb in (*np.eye(3), (0.5, 0.25, 0.8), (0.02, 0.9, 0.4)):
        found = nacre.spectrum_to_colour(GRID, basis @ np.array(rgb)).rgb
        np.testing.assert_allclose(found, rgb, atol=2e-6)
