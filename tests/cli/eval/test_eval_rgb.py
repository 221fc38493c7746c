# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours to spectra with `nacre eval spectrum`, summed up again by colour-science."""

from __future__ import annotations

import json

import colour
import numpy as np
import pytest
from colour.recovery import RGB_to_sd_Smits1999

GRID = np.arange(360.0, 831.0)
D65 = np.interp(
    GRID, colour.SDS_ILLUMINANTS["D65"].wavelengths, colour.SDS_ILLUMINANTS["D65"].values
)
CMFS = (
    colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    .copy()
    .align(colour.SpectralShape(360, 830, 1))
    .values
)


def rgb_of(values):
    """Linear Rec.709 of a reflectance on the grid, its white adapted by Bradford."""
    weights = D65[:, None] * CMFS
    xyz, white = values @ weights, weights.sum(axis=0)
    primaries = colour.RGB_COLOURSPACES["sRGB"]
    d65 = colour.xy_to_XYZ((0.3127, 0.3290))
    adapted = colour.adaptation.chromatic_adaptation_VonKries(
        xyz / white[1], white / white[1], d65, transform="Bradford"
    )
    derived = colour.models.normalised_primary_matrix(primaries.primaries, (0.3127, 0.3290))
    return np.linalg.inv(derived) @ adapted


def record(rgb, **more):
    return {"rgb": [float(value) for value in rgb], "wavelength_nm": GRID.tolist(), **more}


def test_random_colours_come_back(nacre):
    colours = np.random.default_rng(550).random((60, 3))
    answers = nacre.evaluate("spectrum", [record(c) for c in colours])
    for rgb, answer in zip(colours, answers, strict=True):
        values = np.array(answer["values"])
        assert values.min() >= 0
        assert values.max() <= 1
        assert rgb_of(values) == pytest.approx(rgb, abs=1e-9)
        assert answer["rgb"] == pytest.approx(rgb, abs=1e-9)
        assert answer["error_dE00"] <= 0.1
        x = np.polyval(answer["coefficients"], GRID)
        assert values == pytest.approx(0.5 + x / (2 * np.sqrt(1 + x * x)), abs=1e-9)


def test_smits_has_the_published_bins(nacre):
    colours = np.random.default_rng(4).random((20, 3))
    answers = nacre.evaluate("spectrum", [record(c, method="smits") for c in colours])
    for rgb, answer in zip(colours, answers, strict=True):
        # A bin is 34 nm wide from 380 nm; colour-science keeps the ten numbers alone.
        centres = [answer["values"][37 + 34 * i] for i in range(10)]
        assert centres == pytest.approx(RGB_to_sd_Smits1999(rgb).values, abs=1e-12)
        assert rgb_of(np.array(answer["values"])) == pytest.approx(answer["rgb"], abs=1e-9)
        assert "coefficients" not in answer


def test_a_light_has_the_shape_of_d65_and_any_strength(nacre):
    white, red = nacre.evaluate(
        "spectrum", [record((3, 3, 3), kind="emission"), record((50, 2, 1), kind="emission")]
    )
    shape = np.array(white["values"]) / D65
    assert shape == pytest.approx(shape[0], rel=1e-12)
    assert white["XYZ"][1] == pytest.approx(3, abs=1e-12)
    # D65 as its table has it is not exactly (0.3127, 0.3290), and a light is not adapted.
    assert red["rgb"] == pytest.approx([50, 2, 1], rel=1e-3, abs=5e-3)


def test_metamers_part_under_another_light(nacre):
    d65, a = nacre.evaluate(
        "spectrum", [record((0.2, 0.5, 0.4)), record((0.2, 0.5, 0.4), illuminant="A")]
    )
    assert d65["values"] == a["values"]
    assert np.abs(np.subtract(d65["rgb"], a["rgb"])).max() > 0.005


@pytest.mark.parametrize("space", ["lin_rec2020_scene", "lin_ap1_scene"])
def test_wider_spaces(nacre, space):
    answer = json.loads(
        nacre.ok("eval", "spectrum", "--space", space, stdin=json.dumps(record((0.1, 0.5, 0.1))))
    )
    assert answer["rgb"] == pytest.approx([0.1, 0.5, 0.1], abs=1e-9)
    assert answer["error_dE00"] < 1e-6
    message = nacre.fails("eval", "spectrum", "--space", space, stdin=json.dumps(record((0, 1, 0))))
    assert "rgb: must be the colour of a smooth reflectance, of which the nearest found" in message
    assert "in lin_rec709_scene), which is" in message


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"rgb": [0.1, 0.2]}, "rgb: must be 3 numbers (got 2)"),
        ({"rgb": [1.1, 1.1, 1.1]}, "nearest found is ΔE00"),
        ({"rgb": [-0.1, 0.5, 0.5], "method": "smits"}, "must be in [0, 1]"),
        ({"rgb": [0.1, 0.2, 0.3], "method": "meng"}, "method: must be one of jakob-hanika, smits"),
        (
            {"rgb": [0.1, 0.2, 0.3], "wavelength_nm": [200]},
            "wavelength_nm[0]: must be in [360, 830]",
        ),
        ({"rgb": [0.1, 0.2, 0.3], "values": [1]}, "values: is not known here"),
        (
            {"rgb": [0.1, 0.2, 0.3], "kind": "emission", "illuminant": "A"},
            "illuminant: belongs to kind reflectance",
        ),
    ],
)
def test_bad_records(nacre, given, message):
    assert message in nacre.fails("eval", "spectrum", stdin=json.dumps(given))
