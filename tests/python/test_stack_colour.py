# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours of stacks from few wavelengths, and ranges of images."""

from __future__ import annotations

import numpy as np
import pytest

import nacre

SOAP = [1, "water/Daimon-20C", 1]
GRID_NM = np.arange(360.0, 831.0)


def test_arrays_broadcast():
    d_nm, angle = np.linspace(0, 1500, 31)[:, None, None], np.array([0.0, 40.0, 80.0])
    soap = nacre.stack_colour(SOAP, d_nm, angle)
    assert soap.reflectance.rgb.shape == soap.transmittance.XYZ.shape == (31, 3, 3)
    assert soap.wavelengths.shape == (31, 3)
    assert soap.wavelengths.max() <= 16
    one = nacre.stack_colour(SOAP, [750.0], 40.0)
    assert one.reflectance.rgb.shape == (3,)
    assert np.array_equal(one.reflectance.rgb, soap.reflectance.rgb[15, 1])


@pytest.mark.parametrize("pol", "spu")
def test_full_is_the_colour_of_the_spectrum(pol):
    index = nacre.library.medium("Ag/Johnson").index(GRID_NM)
    n = np.stack([np.full(471, 1.0), np.full(471, 1.8 + 0.01j), index], axis=-1)
    spectrum = nacre.stack(n, [230.0], 35.0, GRID_NM, pol=pol)
    wanted = nacre.spectrum_to_colour(GRID_NM, spectrum.R, illuminant="A", observer="cie1964")
    for media in ([1, 1.8 + 0.01j, "Ag/Johnson"], [1, 1.8 + 0.01j, index]):
        got = nacre.stack_colour(
            media,
            [230.0],
            35.0,
            pol=pol,
            sampling="full",
            illuminant="A",
            observer="cie1964",
        )
        for key in ("XYZ", "Lab", "rgb"):
            assert np.allclose(
                getattr(got.reflectance, key), getattr(wanted, key), rtol=0, atol=1e-9
            )
        assert got.wavelengths == 471


def test_adaptive_is_near_the_reference():
    rng = np.random.default_rng(7)
    media = [1, "TiO2/Sarkar", "SiO2/Malitson", "TiO2/Sarkar", "N-BK7/SCHOTT"]
    d_nm, angle = rng.uniform(0, 600, (200, 3)), rng.uniform(0, 80, 200)
    few = nacre.stack_colour(media, d_nm, angle)
    reference = nacre.stack_colour(media, d_nm, angle, sampling="reference")
    assert np.abs(few.reflectance.rgb - reference.reflectance.rgb).max() <= 1e-3
    assert np.abs(few.transmittance.rgb - reference.transmittance.rgb).max() <= 1e-3
    assert few.wavelengths.mean() <= 40


def test_panes_and_empty_arrays():
    pane = nacre.stack_colour([1, 1.5, 1], [1e6], coherent=[False])
    face = 0.04
    assert pane.reflectance.XYZ[1] == pytest.approx(2 * face / (1 + face), abs=1e-6)
    bare = nacre.stack_colour([1, 1.5], np.empty((4, 0)))
    assert np.allclose(bare.reflectance.rgb, 0.04, atol=2e-6)
    none = nacre.stack_colour(SOAP, np.empty((0, 1)))
    assert none.reflectance.rgb.shape == (0, 3)


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        ((SOAP, [1.0, 2.0]), {}, r"d_nm: must have one thickness for each of the 1 layers"),
        ((SOAP, [-1.0]), {}, r"d_nm\[0\]: must be finite and ≥ 0"),
        ((SOAP, [[1.0], [np.nan]]), {}, r"d_nm\[0\]: .*item 1"),
        ((SOAP, [1.0], 90.0), {}, r"angle_deg: must be in \[0, 90\)"),
        ((SOAP, np.ones((3, 1)), [1, 2]), {}, "angle_deg: "),
        (([1, "watre", 1], [1.0]), {}, r"media\[1\]: "),
        (([1, [1.3, 1.4], 1], [1.0]), {}, r"media\[1\]: must be a library key"),
        (([1, -1.3, 1], [1.0]), {}, r"media\[1\]\.n: must be finite and > 0"),
        (([1 + 0.5j, 1.3, 1], [1.0]), {}, r"n\[0\]: must not absorb"),
        (([1, "TiO2/Devore-o", 1], [1.0]), {}, r"media\[1\]: must be within the data"),
        (
            ([1, "BaTiO3/Wemple-o", 1], [1.0]),
            {"strict_range": True},
            "BaTiO3/Wemple-o: wavelength_nm: must be within the data, 400 … 700 nm",
        ),
        ((SOAP, [1.0]), {"sampling": "few"}, "sampling: must be adaptive"),
        ((SOAP, [1.0]), {"pol": "x"}, "pol: "),
        ((SOAP, [1.0]), {"coherent": [True, True]}, "coherent: must have 1 flags"),
        ((SOAP, [1.0]), {"illuminant": "D64"}, "illuminant: "),
    ],
)
def test_bad_arguments(arguments, options, message):
    with pytest.raises(nacre.NacreError, match=message):
        nacre.stack_colour(*arguments, **options)


def test_range_of_an_image():
    image = np.random.default_rng(3).uniform(-0.2, 5.0, (4, 5, 3))
    assert np.array_equal(nacre.map_range(image, "clamp"), np.clip(image, 0, 1))
    assert np.allclose(nacre.map_range(image), image / image.max(), rtol=1e-15)
    kept = nacre.map_range(image, "none")
    assert np.array_equal(kept, image)
    assert kept is not image
    black = np.zeros((2, 3))
    assert np.array_equal(nacre.map_range(black), black)
    with pytest.raises(nacre.NacreError, match="rgb: must have 3 channels"):
        nacre.map_range([1.0, 2.0])
    with pytest.raises(nacre.NacreError, match="range: must be one of"):
        nacre.map_range(image, "loud")
