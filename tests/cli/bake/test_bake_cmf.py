# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre bake cmf`: 471 texels, R = x̄, G = ȳ, B = z̄."""

from __future__ import annotations

import colour
import numpy as np
import OpenImageIO as oiio
import pytest

from support.images import json_attribute, read_all, spec_of

OBSERVERS = {
    "cie1931": "CIE 1931 2 Degree Standard Observer",
    "cie1964": "CIE 1964 10 Degree Standard Observer",
}


def cmfs(observer):
    table = colour.MSDS_CMFS[OBSERVERS[observer]].copy().align(colour.SpectralShape(360, 830, 1))
    return table.values


@pytest.mark.parametrize("observer", list(OBSERVERS))
def test_float_texels_are_the_published_values(nacre, tmp_path, observer):
    path = tmp_path / "cmf.exr"
    nacre.ok("bake", "cmf", "--observer", observer, "-o", path)
    pixels, attributes = read_all(path)
    assert pixels.shape == (1, 471, 3)
    assert np.max(np.abs(pixels[0] - cmfs(observer))) < 1e-6
    assert attributes["nacre:observer"] == observer
    assert attributes["nacre:quantity"] == "colour_matching_functions"
    assert attributes["colorInteropID"] == "data"
    assert attributes["nacre:schema"] == 1
    assert json_attribute(attributes, "axes") == [
        {"name": "wavelength", "unit": "nm", "min": 360.0, "max": 830.0, "mapping": "linear"}
    ]


def test_half(nacre, tmp_path):
    path = tmp_path / "cmf.exr"
    nacre.ok("bake", "cmf", "--depth", "half", "-o", path)
    assert spec_of(path).format == oiio.HALF
    assert np.max(np.abs(read_all(path)[0][0] - cmfs("cie1931"))) < 1e-3


@pytest.mark.parametrize("maximum", ["global", "channel"])
def test_bytes_carry_their_maximum(nacre, tmp_path, maximum):
    path = tmp_path / "cmf.png"
    nacre.ok("bake", "cmf", "--maximum", maximum, "-o", path)
    pixels, attributes = read_all(path)
    divisors = np.array(json_attribute(attributes, "maximum"))
    peaks = cmfs("cie1931").max(axis=0)
    assert divisors == pytest.approx(peaks if maximum == "channel" else [peaks.max()] * 3)
    assert spec_of(path).format == oiio.UINT8
    assert np.max(np.abs(pixels[0] * divisors - cmfs("cie1931")) / divisors) <= 0.5 / 255 + 1e-6
    assert pixels[0].max(axis=0)[2] == 1.0  # z̄ has the largest value of all


def test_the_same_bytes_every_time(nacre, tmp_path):
    for name in ("cmf.exr", "cmf.png", "cmf.tx"):
        first, second = tmp_path / f"a_{name}", tmp_path / f"b_{name}"
        nacre.ok("bake", "cmf", "-o", first)
        nacre.ok("bake", "cmf", "-o", second)
        assert first.read_bytes() == second.read_bytes()


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("cmf.jpg", (), "must end in .exr, .tx (float, half), .ftxt (float) or .png"),
        ("cmf", (), "must end in .exr, .tx"),
        ("cmf.png", ("--depth", "float"), "--depth: must be byte for .png (got float)"),
        ("cmf.exr", ("--depth", "byte"), "--depth: must be float or half for .exr (got byte)"),
        ("cmf.exr", ("--observer", "cie2015"), "--observer"),
    ],
)
def test_wrong_output(nacre, tmp_path, name, options, message):
    path = tmp_path / name
    assert message in nacre.fails("bake", "cmf", *options, "-o", path)
    assert list(tmp_path.iterdir()) == []
