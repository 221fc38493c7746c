# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectral pictures as other programs read them: OpenImageIO, colour-science, Mitsuba."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
import OpenImageIO as oiio
import pytest
from nacre_extension.core.exr import read_channels
from nacre_extension.core.exr_write import ExrWriter
from nacre_extension.core.space import REC709
from nacre_extension.core.spectral_image import BandTable, channel, write
from nacre_extension.core.whole_file import is_whole

import nacre

RANDOM = np.random.default_rng(27)

READ_WITH_MITSUBA = """
import json, sys
import mitsuba, numpy
bitmap = mitsuba.Bitmap(sys.argv[1])
names = [bitmap.struct_()[i].name for i in range(bitmap.channel_count())]
values = numpy.array(bitmap)
found = [i for i, name in enumerate(names) if name.startswith("S0.")]
print(json.dumps([[names[i] for i in found], values[:, 0, found].tolist()]))
"""


def pixels_of(path):
    buffer = oiio.ImageBuf(str(path))
    return buffer.spec(), buffer.get_pixels(oiio.FLOAT)


@pytest.mark.parametrize("height", [1, 15, 16, 17, 40])
@pytest.mark.parametrize("at_a_time", [1, 16, 23])
def test_any_channels_come_back_as_they_went_in(tmp_path, height, at_a_time):
    names = ["R", "S0.450,000nm", "B", "G", "x" * 60]
    values = RANDOM.random((height, 13, 5), dtype=np.float32)
    values[height // 2 :] = 0.25  # what compresses, and what does not
    attributes = {"words": "grüße", "two": [1.0, 2.0], "three": [1.0, 2.0, 3.0]}
    with ExrWriter(tmp_path / "a.exr", 13, height, names, attributes) as writer:
        for row in range(0, height, at_a_time):
            writer.append(values[row : row + at_a_time])
    spec, pixels = pixels_of(tmp_path / "a.exr")
    assert sorted(spec.channelnames) == sorted(names)
    for index, name in enumerate(spec.channelnames):
        np.testing.assert_array_equal(pixels[..., index], values[..., names.index(name)])
    assert spec.getattribute("words") == "grüße"
    assert spec.getattribute("three") == (1.0, 2.0, 3.0)
    assert is_whole(tmp_path / "a.exr")
    # The extension reads what it writes.
    own = read_channels(tmp_path / "a.exr")
    for name in ("R", "B", "G", "x" * 60):
        np.testing.assert_array_equal(own[name], values[..., names.index(name)].ravel())


def write_half(path, failure=None):
    with ExrWriter(path, 4, 4, ["Y"], {}) as writer:
        writer.append(np.zeros((2, 4, 1), np.float32))
        if failure:
            raise failure


def test_a_picture_that_is_not_finished_does_not_appear(tmp_path):
    path = tmp_path / "a.exr"
    path.write_text("what was there")
    with pytest.raises(KeyboardInterrupt):
        write_half(path, KeyboardInterrupt())
    with pytest.raises(ValueError, match="2 rows of 4"):
        write_half(path)
    assert path.read_text() == "what was there"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0, 4, ["Y"], {}), "0 x 4"),
        ((4, 4, [], {}), "4 x 4"),
        ((4, 4, ["Y", "Y"], {}), "'Y', 'Y'"),
        ((4, 4, ["Y" * 256], {}), "1 to 255 bytes"),
        ((4, 4, ["Y"], {"": "empty"}), "1 to 255 bytes"),
    ],
)
def test_what_no_file_can_have(tmp_path, arguments, message):
    with pytest.raises(ValueError, match=message):
        ExrWriter(tmp_path / "a.exr", *arguments)


def test_a_folder_that_is_not_there(tmp_path):
    with (
        pytest.raises(OSError, match=r"none/a\.exr"),
        ExrWriter(tmp_path / "none" / "a.exr", 4, 4, ["Y"], {}),
    ):
        pass


@pytest.fixture
def picture(tmp_path):
    """A grey ramp under D65 and sodium lines, in 12 bands; and its radiances."""
    lights = ["D65", nacre.Lines([589.0, 589.6], [2.0, 1.0])]
    bands = nacre.bands(12, lights)
    light = bands.in_bands("D65")
    light /= bands.xyz(light)[1]
    radiance = (np.linspace(0.1, 1.0, 20)[:, None, None] * light).repeat(7, axis=1)
    radiance = radiance.astype(np.float32)
    table = BandTable("cie1931", bands.edges_nm, bands.wavelength_nm, bands.XYZ, bands.is_line)
    path = tmp_path / "ramp.exr"
    write(path, table, REC709, radiance)
    return path, bands, radiance


def test_channels_are_named_by_their_wavelengths():
    assert channel(450.0) == "S0.450,000nm"
    assert channel(589.2943) == "S0.589,294nm"


def test_colour_is_what_the_bands_are_to_the_eye(picture):
    path, bands, radiance = picture
    spec, pixels = pixels_of(path)
    rgb = pixels[..., [spec.channelnames.index(name) for name in "RGB"]]
    grey = radiance @ bands.XYZ[:, 1]
    # D65 has no tint in a space whose white it is, but for the four digits of that white's xy.
    np.testing.assert_allclose(rgb, grey[..., None].repeat(3, axis=-1), rtol=3e-4)
    assert spec.getattribute("chromaticities")[:2] == pytest.approx((0.64, 0.33), abs=1e-5)
    stored = json.loads(spec.getattribute("nacre:bands"))
    np.testing.assert_allclose(stored["xyz"], bands.XYZ)
    assert stored["is_line"].count(True) == 1


def test_a_colour_that_is_given_is_kept(tmp_path):
    bands = nacre.bands(6)
    table = BandTable("cie1931", bands.edges_nm, bands.wavelength_nm, bands.XYZ, bands.is_line)
    given, alpha = RANDOM.random((2, 3, 3), dtype=np.float32), RANDOM.random((2, 3))
    radiance = np.ones((2, 3, 6), np.float32)
    write(tmp_path / "a.exr", table, REC709, radiance, rgb=given, alpha=alpha)
    spec, pixels = pixels_of(tmp_path / "a.exr")
    rgb = pixels[..., [spec.channelnames.index(name) for name in "RGB"]]
    np.testing.assert_array_equal(rgb, given)
    np.testing.assert_array_equal(pixels[..., spec.channelnames.index("A")], np.float32(alpha))


def test_colour_science_reads_it(picture):
    import colour

    path, bands, radiance = picture
    components = colour.read_spectral_image_Fichet2021(str(path))
    wavelengths, values = components["S0"]
    np.testing.assert_allclose(wavelengths, bands.wavelength_nm, atol=5.1e-4)
    np.testing.assert_array_equal(values, radiance)


def test_mitsuba_reads_it(picture):
    path, bands, radiance = picture
    said = subprocess.run(
        [sys.executable, "-c", READ_WITH_MITSUBA, str(path)],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    names, values = json.loads(said)
    assert names == [channel(nm) for nm in bands.wavelength_nm]
    np.testing.assert_array_equal(np.float32(values), radiance[:, 0])
