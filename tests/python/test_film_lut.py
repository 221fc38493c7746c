# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.film_lut` against `nacre.stack` and the colours of its spectra."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import colour
import numpy as np
import pytest

import nacre
from support.colours import lab

GRID = np.arange(360.0, 831.0)
AIR = 1.0
SOAP = {"media": [AIR, "water/Daimon-20C", AIR], "d_nm": [400], "varying": 0, "range_": (20, 900)}
OXIDE = {
    "media": [AIR, "TiO2/Sarkar", "Ti/Johnson"],
    "d_nm": [80],
    "varying": 0,
    "range_": (20, 160),
}
MIRROR = {
    "media": [AIR, *["TiO2/Sarkar", "SiO2/Malitson"] * 3, "TiO2/Sarkar", 1.52],
    "d_nm": [57.3, 94.2] * 3 + [57.3],
    "varying": "scale",
    "range_": (0.8, 1.25),
}
COATED = {
    "media": [AIR, "SiO2/Malitson", 1.9, AIR],
    "d_nm": [100, 1e6],
    "varying": 0,
    "range_": (0, 300),
    "coherent": [True, False],
}
FILMS = {"soap": SOAP, "oxide": OXIDE, "mirror": MIRROR, "coated": COATED}


def index(medium):
    if isinstance(medium, str):
        return nacre.library.medium(medium).index(GRID)
    return np.full(471, medium, complex)


def exact(film, cosine, value, quantity="R", **colour_options):
    """Colour by the other road: spectrum by `stack`, sum by `spectrum_to_colour`."""
    d_nm = np.array(film["d_nm"], float)
    flags = np.array(film.get("coherent", [True] * d_nm.size))
    if film["varying"] == "scale":
        d_nm[flags] *= value
    else:
        d_nm[film["varying"]] = value
    n = np.stack([index(medium) for medium in film["media"]], axis=-1)
    answer = nacre.stack(n, d_nm, np.degrees(np.arccos(cosine)), GRID, "u", flags)
    return nacre.spectrum_to_colour(GRID, getattr(answer, quantity), **colour_options).rgb


def read(table, x, y):
    """Bilinearly, edge texel centres at the ends of the axes."""
    height, width, _ = table.texels.shape
    column = (x - table.x[1]) / (table.x[2] - table.x[1]) * (width - 1)
    row = (y - table.y[1]) / (table.y[2] - table.y[1]) * (height - 1)
    j, i = min(int(column), width - 2), min(int(row), height - 2)
    u, v = column - j, row - i
    block = table.texels[i : i + 2, j : j + 2].astype(float)
    return np.einsum("i,j,ijc->c", [1 - v, v], [1 - u, u], block)


@pytest.mark.parametrize("name", FILMS)
def test_texels_are_colours_of_spectra(name):
    film = FILMS[name]
    lut = nacre.film_lut(**film, size=(6, 4), transmittance=True)
    assert lut.reflectance.texels.shape == lut.transmittance.texels.shape == (4, 6, 3)
    assert lut.reflectance.texels.dtype == np.float32
    low, high = film["range_"]
    for row, value in enumerate(np.linspace(low, high, 4)):
        for column in range(1, 6):  # column 0 is grazing incidence, outside [0, 90)
            for table, quantity in ((lut.reflectance, "R"), (lut.transmittance, "T")):
                np.testing.assert_allclose(
                    table.texels[row, column],
                    exact(film, column / 5, value, quantity),
                    rtol=0,
                    atol=1e-6,
                )


@pytest.mark.parametrize(
    "options",
    [
        {"illuminant": "A", "observer": "cie1964"},
        {"space": "lin_ap1_scene"},
        {"space": "lin_rec2020_scene", "illuminant": "E"},
    ],
    ids=lambda options: "-".join(options.values()),
)
def test_light_observer_and_space(options):
    lut = nacre.film_lut(**OXIDE, size=(3, 3), **options)
    np.testing.assert_allclose(
        lut.reflectance.texels[1, 2], exact(OXIDE, 1.0, 90.0, **options), rtol=0, atol=1e-6
    )


def test_axes_and_rows():
    lut = nacre.film_lut(**SOAP, size=(4, 3))
    assert lut.transmittance is None
    assert lut.reflectance.x == ("cos_theta", 0.0, 1.0)
    assert lut.reflectance.y == ("thickness_nm", 20.0, 900.0)
    assert nacre.film_lut(**MIRROR, size=(4, 3)).reflectance.y == ("thickness_scale", 0.8, 1.25)
    np.testing.assert_allclose(lut.reflectance.texels[:, 0], 1, atol=1e-6)  # grazing: a mirror
    assert nacre.film_lut(SOAP["media"], [400]).reflectance.texels.shape[0] == 1


@pytest.mark.parametrize("name", ["soap", "oxide", "mirror"])
def test_stated_error_holds_at_random_points(name):
    film, tolerance = FILMS[name], 0.3
    table = nacre.film_lut(**film, tolerance=tolerance).reflectance
    assert table.error_mean < table.error_max <= tolerance
    draw = np.random.default_rng(4)
    errors = []
    for _ in range(120):
        x, y = draw.uniform(0.05, 1), draw.uniform(*film["range_"])
        pair = [read(table, x, y), exact(film, x, y)]
        errors.append(colour.delta_E(*lab(pair), method="CIE 2000"))
    assert max(errors) <= table.error_max * 1.02
    assert np.mean(errors) == pytest.approx(table.error_mean, rel=0.5)


def test_grows_when_the_tolerance_shrinks():
    sizes = [
        nacre.film_lut(**OXIDE, tolerance=tolerance).reflectance.texels.size
        for tolerance in (2.0, 0.5, 0.1)
    ]
    assert sizes == sorted(set(sizes))


def test_equal_input_gives_equal_bytes_in_every_thread():
    def job(_):
        lut = nacre.film_lut(**OXIDE, tolerance=0.5, transmittance=True)
        return [(t.texels.tobytes(), t.error_max, t.error_mean) for t in lut]

    expected = job(None)
    with ThreadPoolExecutor(4) as pool:
        assert all(result == expected for result in pool.map(job, range(8)))


def test_media_as_key_number_and_spectrum_are_the_same():
    by_key = nacre.film_lut(**OXIDE, size=(5, 5)).reflectance.texels
    spectra = [1.0, *(nacre.library.medium(key).index(GRID) for key in OXIDE["media"][1:])]
    by_spectrum = nacre.film_lut(**{**OXIDE, "media": spectra}, size=(5, 5)).reflectance.texels
    np.testing.assert_array_equal(by_key, by_spectrum)


def test_texels_belong_to_the_caller():
    first = nacre.film_lut(**OXIDE, size=(5, 5)).reflectance.texels
    second = nacre.film_lut(**OXIDE, size=(5, 5)).reflectance.texels
    first[...] = 0
    assert second.max() > 0


def test_without_a_tolerance_errors_are_not_measured():
    measured = nacre.film_lut(**SOAP, size=(16, 32))
    quick = nacre.film_lut(**SOAP, size=(16, 32), tolerance=None)
    np.testing.assert_allclose(
        quick.reflectance.texels, measured.reflectance.texels, rtol=0, atol=1e-6
    )
    assert np.isnan(quick.reflectance.error_max)
    assert np.isnan(quick.reflectance.error_mean)
    assert np.isfinite(measured.reflectance.error_max)


@pytest.mark.parametrize("varying", [1, "scale", None])
def test_single_precision_is_good_to_a_hundred_thousandth(varying):
    media = [1, "TiO2/Sarkar", "SiO2/Malitson", "Ag/Johnson", "N-BK7/SCHOTT"]
    options = {
        "varying": varying,
        "range_": (0.0, 900.0 if varying == 1 else 3.0),
        "size": (64, 1 if varying is None else 257),
        "transmittance": True,
        "tolerance": None,
    }
    double = nacre.film_lut(media, [60.0, 300.0, 15.0], **options)
    single = nacre.film_lut(media, [60.0, 300.0, 15.0], precision="single", **options)
    for a, b in zip(double, single, strict=True):
        assert 0 < np.abs(a.texels - b.texels).max() <= 1e-5


def test_single_precision_of_panes_and_bad_words():
    pane = {"coherent": [False, True], "size": (8, 4), "tolerance": None, "varying": "scale"}
    double = nacre.film_lut([1, 1.5, 1.4, 1], [1e6, 200.0], **pane)
    single = nacre.film_lut([1, 1.5, 1.4, 1], [1e6, 200.0], precision="single", **pane)
    assert np.array_equal(double.reflectance.texels, single.reflectance.texels)
    with pytest.raises(nacre.NacreError, match="single_precision: must be 0 where errors"):
        nacre.film_lut(**SOAP, precision="single")
    with pytest.raises(nacre.NacreError, match="precision: must be 'double' or 'single'"):
        nacre.film_lut(**SOAP, precision="half")


def test_without_a_tolerance_the_size_must_be_given():
    with pytest.raises(nacre.NacreError, match="size: must be given"):
        nacre.film_lut(**SOAP, tolerance=None)
