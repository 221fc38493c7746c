# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.textures`: texels by the documented rules, and back."""

from __future__ import annotations

import numpy as np
import pytest

import nacre
from nacre import textures

RANDOM = np.random.default_rng(324)
SPECTRA = RANDOM.random((5, 512))


@pytest.mark.parametrize("layout", ["packed", "single"])
@pytest.mark.parametrize("columns", [1, 2, 3, 7])
def test_spectra(layout, columns):
    texels = textures.pack_spectra(SPECTRA, layout, columns)
    rows = -(-5 // columns)
    assert texels.dtype == np.float32
    blocks = texels.reshape(rows, columns, 512).reshape(-1, 512)
    assert np.array_equal(blocks[:5], SPECTRA.astype(np.float32))
    assert not blocks[5:].any()
    assert texels.shape[2] == (4 if layout == "packed" else 1)
    back = textures.unpack_spectra(texels, layout, columns, 5)
    assert np.max(np.abs(back - SPECTRA)) <= 2**-25
    assert len(textures.unpack_spectra(texels, layout, columns)) == rows * columns


def test_samples_are_those_of_the_library():
    patch = nacre.library.spectrum("colorchecker/foliage")
    samples = textures.samples(patch.wavelength_nm, patch.values)
    on_it = np.isin(textures.WAVELENGTH_NM, patch.wavelength_nm)
    assert samples[on_it] == pytest.approx(patch.values, abs=1e-15)
    assert samples[0] == patch.values[0]
    linear = textures.samples(patch.wavelength_nm, patch.values, "emission")
    wanted = np.interp(textures.WAVELENGTH_NM, patch.wavelength_nm, patch.values)
    assert np.max(np.abs(linear - wanted)) < 1e-15
    assert np.max(np.abs(samples - linear)) > 1e-4


def test_samples_of_many_spectra_at_once():
    values = RANDOM.random((2, 3, 31))
    together = textures.samples(np.arange(400, 701, 10), values)
    assert together.shape == (2, 3, 512)
    for index in np.ndindex(2, 3):
        alone = textures.samples(np.arange(400, 701, 10), values[index])
        np.testing.assert_array_equal(together[index], alone)
    assert textures.samples([400, 500], np.empty((0, 2))).shape == (0, 512)


@pytest.mark.parametrize("normalise", [True, False])
def test_materials(normalise):
    n, k, rgb = 1 + 2 * SPECTRA, 5 * SPECTRA[::-1], RANDOM.random((5, 3))
    texels = textures.pack_materials(SPECTRA, n, k, rgb, normalise=normalise)
    assert texels.shape == (5, 516, 4)
    lowest, highest = texels[:, 513, 0, None], texels[:, 513, 1, None]
    assert np.max(np.abs(lowest + texels[:, :512, 1] * (highest - lowest) - n)) < 5e-7
    assert np.array_equal(texels[:, 512, :3], rgb.astype(np.float32))
    assert np.all(texels[:, :513, 3] == 1)
    if normalise:
        assert texels[:, :512].min() == 0
        assert texels[:, :512].max() == 1
    back = textures.unpack_materials(texels)
    for got, wanted in zip(back, (SPECTRA, n, k, rgb), strict=True):
        assert np.max(np.abs(got - wanted)) < 5e-7


def test_lights():
    rgb = RANDOM.random((5, 3))
    texels = textures.pack_lights(SPECTRA, rgb)
    assert texels.shape == (2, 516, 4)
    assert np.array_equal(texels[0, :512], SPECTRA[:4].T.astype(np.float32))
    assert np.array_equal(texels[0, 512:, :3], rgb[:4].astype(np.float32))
    back = textures.unpack_lights(texels, 5)
    assert np.max(np.abs(back.power - SPECTRA)) <= 2**-25
    assert not textures.unpack_lights(texels).power[5:].any()


def test_ftxt_keeps_every_bit(tmp_path):
    texels = RANDOM.standard_normal((3, 4, 4)).astype(np.float32)
    path = tmp_path / "t.ftxt"
    path.write_text(textures.ftxt(texels, {"made by": "hand: ü"}), encoding="utf-8")
    read = textures.read_ftxt(path)
    assert np.array_equal(read.texels, texels)
    assert read.comments == {"made by": "hand: ü"}
    grey = textures.ftxt(np.full((1, 1, 1), 0.5))
    assert grey == "1;1\n0.5;0.5;0.5;1\n"


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: textures.pack_spectra(SPECTRA[0]), r"values: must have shape \(count, 512\)"),
        (lambda: textures.pack_spectra(SPECTRA, "tight"), "layout: must be 'packed' or 'single'"),
        (lambda: textures.pack_spectra(SPECTRA, columns=0), "columns: must be in"),
        (lambda: textures.pack_spectra(SPECTRA, columns=513), r"columns: must be in \[1, 512\]"),
        (lambda: textures.unpack_spectra(np.zeros((1, 128, 3))), "128 texels wide and 1 high"),
        (lambda: textures.unpack_spectra(np.zeros((128, 4))), "height, width, channels"),
        (lambda: textures.unpack_spectra(np.zeros((0, 128, 4))), "count: must be in"),
        (lambda: textures.unpack_materials(np.zeros((1, 515, 4))), "516 texels wide"),
        (lambda: textures.unpack_lights(np.zeros((1, 516, 4)), 5), "2 high"),
        (lambda: textures.pack_lights(SPECTRA, [[1, 1, 1]]), "colours: must have shape"),
        (
            lambda: textures.pack_materials(SPECTRA, SPECTRA[:1], SPECTRA, np.ones((5, 3))),
            "n: must",
        ),
        (lambda: textures.pack_spectra(SPECTRA, columns=2.5), "columns: must be 1 numbers"),
        (
            lambda: textures.pack_spectra(np.where(SPECTRA == SPECTRA[3, 7], np.nan, SPECTRA)),
            r"values\[3, 7\]: must be finite and within ±3.4e38, where float ends \(got nan\)",
        ),
        (lambda: textures.pack_lights(1e39 + SPECTRA, np.ones((5, 3))), r"power\[0, 0\]"),
        (lambda: textures.pack_lights(SPECTRA, np.full((5, 3), -np.inf)), r"colours\[0, 0\]"),
        (
            lambda: textures.pack_materials(SPECTRA, SPECTRA, SPECTRA * np.nan, np.ones((5, 3))),
            "k.0, 0",
        ),
        (
            lambda: textures.samples([400, 500], [[1, 1], [1, np.nan]]),
            r"values\[1\]: must be finite",
        ),
        (lambda: textures.samples([400, 500], np.ones((2, 3))), "values: must have shape"),
        (lambda: textures.samples([900, 1000], [1, 1]), "must overlap 324"),
        (lambda: textures.samples([400, 500], [1]), "values: must have shape"),
        (lambda: textures.samples([400, 500], [1, 1], "colour"), "kind: must be"),
        (lambda: textures.ftxt(np.full((1, 1, 1), np.nan)), "texel: must be finite"),
        (lambda: textures.ftxt(np.zeros((1, 1, 1)), {"a": "b\nc"}), "one line each"),
        (lambda: textures.ftxt(np.zeros((1, 1, 5))), "channels: must be in"),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(nacre.NacreError, match=message):
        call()


def test_a_bad_file_names_file_and_line(tmp_path):
    path = tmp_path / "t.ftxt"
    path.write_text("1;1\n1;2;3\n", encoding="utf-8")
    with pytest.raises(nacre.NacreError, match=r"t\.ftxt:2: texel: must be r;g;b;a"):
        textures.read_ftxt(path)
    with pytest.raises(OSError, match="none"):
        textures.read_ftxt(tmp_path / "none.ftxt")
