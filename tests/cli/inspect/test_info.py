# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre info` of spectral pictures."""

from __future__ import annotations

import json

import numpy as np
import OpenImageIO as oiio
import pytest

BANDS = {
    "version": 1,
    "observer": "cie1964",
    "edges_nm": [360, 500, 588.5, 589.5, 830],
    "wavelength_nm": [450.25, 550.0, 589.0, 640.0],
    "xyz": [[0.1, 0.2, 0.3]] * 4,
    "is_line": [False, False, True, False],
}


def picture(path, bands, lights=None):
    spec = oiio.ImageSpec(4, 2, 4, oiio.FLOAT)
    spec.channelnames = [f"S0.{nm},000nm" for nm in (450, 550, 589, 640)]
    spec.attribute("nacre:bands", bands)
    if lights is not None:
        spec.attribute("nacre:lights", lights)
    buffer = oiio.ImageBuf(spec)
    buffer.set_pixels(oiio.ROI(), np.zeros((2, 4, 4), np.float32))
    assert buffer.write(str(path)), buffer.geterror()
    return path


def test_a_spectral_picture_in_a_line(nacre, tmp_path):
    said = nacre.ok("info", picture(tmp_path / "a.exr", json.dumps(BANDS)))
    line = "spectral picture: 4 bands, 450.2 … 640 nm, seen by cie1964, lines at 589 nm"
    assert line in said.splitlines()
    assert "edges_nm" not in said
    assert "not a table" not in said


def test_lights_of_layers_without_their_powers(nacre, tmp_path):
    lights = [
        {"layer": "", "light": "D65", "power": [1]},
        {"layer": "Key", "light": "A", "power": [2]},
    ]
    file = picture(tmp_path / "a.exr", json.dumps(BANDS), json.dumps(lights))
    assert "lit by D65, Key A" in nacre.ok("info", file).splitlines()
    odd = picture(tmp_path / "b.exr", json.dumps(BANDS), '[{"layer": 3}]')
    assert 'lights: [{"layer":3}]' in nacre.ok("info", odd)


def test_json_has_all_of_it(nacre, tmp_path):
    said = nacre.ok("info", "--json", picture(tmp_path / "a.exr", json.dumps(BANDS)))
    assert json.loads(said)["bands"] == BANDS


@pytest.mark.parametrize(
    "bands",
    [
        "{}", "[]", "{", "text", '{"wavelength_nm": [], "is_line": []}',
        '{"wavelength_nm": ["a"], "is_line": [true]}', '{"wavelength_nm": [500], "is_line": 3}',
        '{"wavelength_nm": [500, 600], "is_line": [true]}',
    ],
)  # fmt: skip
def test_what_is_written_otherwise_is_shown_as_it_is(nacre, tmp_path, bands):
    said = nacre.ok("info", picture(tmp_path / "a.exr", bands))
    assert "spectral picture" not in said
    assert "bands: " in said
