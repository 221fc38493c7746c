# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Reading spectra from files, and the user's own library."""

from __future__ import annotations

import os

import numpy as np
import pytest

import nacre

CGATS = """CGATS.17
NUMBER_OF_FIELDS 4
BEGIN_DATA_FORMAT
SAMPLE_ID SPECTRAL_NM400 SPECTRAL_NM500 SPECTRAL_NM600
END_DATA_FORMAT
NUMBER_OF_SETS 2
BEGIN_DATA
A1 0.1 0.2 0.3
A2 0.4 0.5 0.6
END_DATA
"""
YAML = """DATA:
  - type: formula 5
    wavelength_range: 0.4 0.7
    coefficients: 1.5 0.004 -2
"""


@pytest.fixture
def own(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path / "data" / "nacre"


def lamp(**changes) -> nacre.library.Spectrum:
    fields = {
        "key": "python/lamp",
        "name": "Lamp",
        "kind": "emission",
        "references": "measured by hand",
        "licence": "CC0 1.0",
        "comments": "two samples",
        "wavelength_nm": np.array([400.0, 700.0]),
        "values": np.array([0.1, 1 / 3]),
        "tags": ("lamp", "own"),
    }
    return nacre.library.Spectrum(**{**fields, **changes})


def test_files_of_several_formats(tmp_path):
    (tmp_path / "chart.cgats").write_text(CGATS)
    first, second = nacre.library.read(tmp_path / "chart.cgats")
    assert (first.name, second.name, first.key, first.tags) == ("A1", "A2", "", ())
    assert second.wavelength_nm.tolist() == [400, 500, 600]
    assert second.values.tolist() == [0.4, 0.5, 0.6]

    (tmp_path / "lämp.spd").write_text("400 1\n500.5 2.5\n")
    (spectrum,) = nacre.library.read(str(tmp_path / "lämp.spd"))
    assert (spectrum.kind, spectrum.values.tolist()) == ("", [1.0, 2.5])


def test_files_that_are_wrong_say_where(tmp_path):
    (tmp_path / "lamp.spd").write_text("400 1\n300 2\n")
    with pytest.raises(nacre.NacreError, match=r"lamp\.spd:2: "):
        nacre.library.read(tmp_path / "lamp.spd")
    (tmp_path / "noise.csv").write_bytes(bytes(range(256)) * 4)
    with pytest.raises(nacre.NacreError, match=r"noise\.csv"):
        nacre.library.read(tmp_path / "noise.csv")
    with pytest.raises(FileNotFoundError):
        nacre.library.read(tmp_path / "nowhere.csv")


def test_per_cent_is_stated(tmp_path):
    file = tmp_path / "black.cgats"
    file.write_text(CGATS.replace("0.1 0.2 0.3", "1.2 0.9 1.7"))
    with pytest.raises(nacre.NacreError, match=r"A1: must be ratios or per cent.*scale="):
        nacre.library.read(file)
    assert nacre.library.read(file, scale=0.01)[0].values == pytest.approx([0.012, 0.009, 0.017])
    assert nacre.library.read(file, scale=1)[0].values.tolist() == [1.2, 0.9, 1.7]
    assert nacre.library.read(file, kind="emission")[0].kind == "emission"
    for wrong in (0, -1, float("nan"), float("inf")):
        with pytest.raises(nacre.NacreError, match="scale: must be finite and > 0"):
            nacre.library.read(file, scale=wrong)
    with pytest.raises(nacre.NacreError, match="kind: must be emission or reflectance"):
        nacre.library.read(file, kind="colour")


def test_a_spectrum_comes_back_as_it_was(own):
    given = lamp()
    nacre.library.add(given)
    assert (own / "spectra" / "python" / "lamp.csv").is_file()
    back = nacre.library.spectrum("python/lamp")
    assert back[:6] == given[:6]
    assert back.tags == given.tags
    np.testing.assert_array_equal(back.wavelength_nm, given.wavelength_nm)
    np.testing.assert_array_equal(back.values, given.values)
    assert nacre.illuminant("python/lamp")[700 - 360] == 1 / 3


def test_what_was_read_becomes_an_entry(tmp_path, own):
    (tmp_path / "chart.cgats").write_text(CGATS)
    patches = [
        patch._replace(key=f"chart/{patch.name}", kind="reflectance")
        for patch in nacre.library.read(tmp_path / "chart.cgats")
    ]
    nacre.library.add(patches)
    assert nacre.library.keys("spectra", search="chart/A") == ["chart/A1", "chart/A2"]


def test_all_are_kept_or_none(own):
    for wrong, message in (
        ({"key": "../lamp"}, "must be up to four names"),
        ({"key": "lamp/hps"}, "comes with Nacre"),
        ({"kind": ""}, "kind: must be emission or reflectance"),
        ({"kind": "reflectance", "values": np.array([0.1, 33.0])}, "values: .*item 1"),
        ({"wavelength_nm": np.array([700.0, 400.0])}, "wavelength"),
        ({"values": np.zeros(3)}, r"values: must have shape \(2,\)"),
        ({"name": 5}, "name: must be text"),
    ):
        with pytest.raises(nacre.NacreError, match=message):
            nacre.library.add([lamp(key="python/good"), lamp(**wrong)])
        assert not list(own.rglob("*.csv"))


def test_replacing_must_be_asked_for(own):
    nacre.library.add(lamp(key="python/twice"))
    file = own / "spectra" / "python" / "twice.csv"
    with pytest.raises(nacre.NacreError, match="is there already"):
        nacre.library.add(lamp(key="python/twice", name="Other"))
    assert "Other" not in file.read_text()
    nacre.library.add(lamp(key="python/twice", name="Other"), replace=True)
    assert "Other" in file.read_text()


def test_a_file_of_the_same_size_and_time_is_another_one(own):
    nacre.library.add(lamp(key="python/again", values=np.array([1.0, 2.0])))
    file = own / "spectra" / "python" / "again.csv"
    before = file.stat()
    for value in range(2, 10):
        file.write_text(file.read_text().replace(f"400,{value - 1}", f"400,{value}"))
        os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
        assert file.stat().st_size == before.st_size
        assert nacre.library.spectrum("python/again").values[0] == value


def test_media_from_arrays_and_files(tmp_path, own):
    nm = np.array([400.0, 550.0, 700.0])
    n = np.array([1.5 + 0.1j, 1.45 + 1e-7j, 1.4])
    film = nacre.library.add_medium("python/film", (nm, n), references="measured by hand")
    assert (film.references, film.range_nm) == ("measured by hand", (400.0, 700.0))
    np.testing.assert_allclose(film.index(nm), n, rtol=0, atol=1e-15)

    (tmp_path / "glass.yml").write_text(YAML)
    glass = nacre.library.add_medium("python/glass", tmp_path / "glass.yml", references="me")
    assert glass.index(500.0) == pytest.approx(1.5 + 0.004 / 0.25)
    assert glass.references == "me"

    (tmp_path / "loop.yml").write_text(
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.7 1.4 0\n        0.4 1.5 -1e-17\n"
    )
    loop = nacre.library.add_medium("python/loop", tmp_path / "loop.yml")
    assert [change.split(" (")[0] for change in loop.changes] == [
        "DATA[0].data: sorted by wavelength",
        "DATA[0].data: k < 0 taken as 0",
    ]
    assert loop.index(400.0) == 1.5
    assert film.changes == ()

    with pytest.raises(nacre.NacreError, match="is there already"):
        nacre.library.add_medium("python/film", (nm, n))
    with pytest.raises(nacre.NacreError, match="source: must be two arrays"):
        nacre.library.add_medium("python/other", (nm, n[:2]))
    with pytest.raises(nacre.NacreError, match="samples:2: n: must be > 0"):
        nacre.library.add_medium("python/other", (nm, -n))
    assert nacre.library.keys(search="python/other") == []
