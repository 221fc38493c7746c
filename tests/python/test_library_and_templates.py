# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre.library` and `nacre.compile_template`."""

from __future__ import annotations

import re
from pathlib import Path

import colour
import numpy as np
import pytest

import nacre

ROOT = Path(__file__).resolve().parents[2]
TEMPLATES = ROOT / "osl" / "templates"
CONSTANTS = ROOT / "cpp_tools" / "data" / "optical_constants"


def test_version_is_the_projects():
    project = (ROOT / "CMakeLists.txt").read_text("utf-8")
    assert nacre.__version__ == re.search(r"project\(Nacre VERSION ([0-9.]+)", project)[1]


def test_keys_are_the_files_that_come_along():
    files = sorted(f"{path.parent.name}/{path.stem}" for path in CONSTANTS.glob("*/*.yml"))
    found = nacre.library.keys()
    assert found == sorted(found)
    assert set(files) <= set(found)


@pytest.mark.parametrize("key", nacre.library.keys())
def test_every_medium_can_be_read_over_its_range(key):
    medium = nacre.library.medium(key)
    assert medium.key == key
    assert medium.name
    first, last = medium.range_nm
    assert first < last
    wavelengths = np.linspace(max(first, 1.0), min(last, 1e5), 50)
    index = medium.index(wavelengths)
    assert index.shape == (50,)
    assert index.dtype == np.complex128
    assert (index.real > 0).all()
    assert (index.imag >= 0).all()


@pytest.mark.parametrize(
    ("key", "wavelength", "n_d", "tolerance"),
    [
        ("N-BK7/SCHOTT", 587.5618, 1.51680, 5e-6),  # data sheets of SCHOTT
        ("SF11/SCHOTT", 587.5618, 1.78472, 5e-6),
        ("water/Daimon-20C", 587.5618, 1.33340, 1e-5),  # n_d of the paper
        ("diamond/Peter", 589.3, 2.417, 1e-3),
        ("SiO2/Malitson", 587.5618, 1.45846, 5e-6),
    ],
)
def test_published_indices(key, wavelength, n_d, tolerance):
    index = nacre.library.medium(key).index(wavelength)
    assert index.shape == ()
    assert index.real == pytest.approx(n_d, abs=tolerance)
    assert index.imag < 1e-6


def test_shapes_of_indices():
    glass = nacre.library.medium("N-BK7/SCHOTT")
    assert glass.index(np.full((2, 3), 550.0)).shape == (2, 3)
    assert glass.index([]).shape == (0,)
    assert glass.references
    assert glass.index(np.float32(550)) == glass.index(550)


@pytest.mark.parametrize("key", nacre.library.keys("spectra"))
def test_every_spectrum_can_be_read(key):
    spectrum = nacre.library.spectrum(key)
    assert spectrum.key == key
    assert spectrum.kind in ("emission", "reflectance")
    assert spectrum.name
    assert spectrum.references
    assert spectrum.licence
    assert spectrum.wavelength_nm.shape == spectrum.values.shape
    assert (np.diff(spectrum.wavelength_nm) > 0).all()
    assert (spectrum.values >= 0).all()


def test_the_chart_is_that_of_its_source():
    chart = colour.SDS_COLOURCHECKERS["ColorChecker N Ohta"]
    keys = [key for key in nacre.library.keys("spectra") if key.startswith("colorchecker/")]
    assert len(keys) == len(chart) == 24
    ours = {nacre.library.spectrum(key).name: nacre.library.spectrum(key) for key in keys}
    for name, theirs in chart.items():
        patch = ours["ColorChecker, " + name.split(" (")[0]]
        np.testing.assert_array_equal(patch.wavelength_nm, theirs.wavelengths)
        np.testing.assert_allclose(patch.values, theirs.values, rtol=1e-9)


def test_spectra_of_ones_own_are_found_and_read_anew(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    before = nacre.library.keys("spectra")
    folder = tmp_path / "nacre" / "spectra"
    folder.mkdir(parents=True)
    (folder / "mine.csv").write_text("# KIND: reflectance\n400,0.5\n700,1\n")
    assert sorted([*before, "mine"]) == nacre.library.keys("spectra")
    mine = nacre.library.spectrum("mine")
    assert (mine.kind, mine.values.tolist()) == ("reflectance", [0.5, 1.0])
    mine.values[0] = 7  # a copy
    assert nacre.library.spectrum("mine").values[0] == 0.5


def test_unknown_spectra_and_kinds():
    with pytest.raises(nacre.NacreError, match="perhaps lamp/hps"):
        nacre.library.spectrum("lamp/hpss")
    with pytest.raises(nacre.NacreError, match="must be media or spectra"):
        nacre.library.keys("lamps")


def test_search_by_words_and_tags():
    metals = nacre.library.keys(tag="metal")
    assert "Au/Johnson" in metals
    every = nacre.library.keys()
    assert metals == [key for key in every if "metal" in nacre.library.medium(key).tags]
    silver = nacre.library.keys(search="SILVER", tag="metal")
    assert "Ag/Johnson" in silver
    assert set(silver) < set(metals)
    assert "ethanol/Chang" in nacre.library.keys(search="c2h6o")
    assert nacre.library.keys("spectra", search="dark skin") == ["colorchecker/dark-skin"]
    assert nacre.library.keys(search="no such thing") == []
    with pytest.raises(nacre.NacreError, match="search: must be text"):
        nacre.library.keys(search=1)


def test_media_and_spectra_say_their_tags():
    assert nacre.library.medium("TiO2/Devore-o").formula == "TiO2"
    assert nacre.library.medium("brass/Querry-Cu70Zn30").tags == ("metal", "alloy")
    assert nacre.library.spectrum("study/box").tags == ("study",)
    assert nacre.library.medium("air").tags == ("gas",)


@pytest.mark.parametrize("name", sorted(path.stem for path in TEMPLATES.glob("*.toml")))
def test_shipped_templates_compile(name):
    text = (TEMPLATES / f"{name}.toml").read_text("utf-8")
    material = nacre.compile_template(text, f"{name}.toml", tolerance=2.0)
    assert material.id == name
    assert material.manifest["id"] == name
    assert re.search(rf"^shader \w*{name}", material.osl, re.MULTILINE)
    assert len(material.tables) == len(material.manifest["tables"])
    for texels in material.tables.values():
        assert texels.dtype == np.float32
        assert texels.ndim == 3
        assert np.isfinite(texels).all()


def test_compiling_twice_gives_the_same():
    text = (TEMPLATES / "soap_film.toml").read_text("utf-8").replace("max = 1500", "max = 450")
    first, second = (nacre.compile_template(text, tolerance=1.0) for _ in range(2))
    assert first.osl == second.osl
    assert first.manifest == second.manifest
    for name, texels in first.tables.items():
        np.testing.assert_array_equal(texels, second.tables[name])


def test_tolerance_and_space_reach_the_tables():
    text = (TEMPLATES / "tempered_steel.toml").read_text("utf-8")
    coarse = nacre.compile_template(text, tolerance=2.0)
    fine = nacre.compile_template(text, tolerance=0.2)
    wide = nacre.compile_template(text, tolerance=2.0, space="lin_ap1_scene")
    assert fine.tables["R"].size > coarse.tables["R"].size
    assert "lin_ap1_scene" in str(wide.manifest)


def test_every_problem_of_a_template_comes_with_its_line():
    text = (TEMPLATES / "soap_film.toml").read_text("utf-8")
    broken = text.replace("schema = 1", "schema = 1\ncolour = 3").replace("min = 20", "min = -20")
    with pytest.raises(nacre.NacreError) as caught:
        nacre.compile_template(broken, "film.toml")
    lines = str(caught.value).splitlines()
    assert len(lines) >= 2
    assert all(re.match(r"film\.toml:\d+: \S+: ", line) for line in lines)
    assert any(line.startswith("film.toml:4: colour: ") for line in lines)
    assert any("thickness_nm.min: must be ≥ 0 (got -20)" in line for line in lines)


def test_unknown_media_of_a_template_are_errors():
    text = (TEMPLATES / "soap_film.toml").read_text("utf-8")
    with pytest.raises(nacre.NacreError, match="water/Daimon-20C"):
        nacre.compile_template(text.replace("water/Daimon-20C", "water/Daimon"))


def test_an_edited_film_gets_new_texels():
    text = (TEMPLATES / "tempered_steel.toml").read_text("utf-8")
    compiled = nacre.compile_template(text, tolerance=1.0)
    sizes = {name: texels.shape[:2] for name, texels in compiled.tables.items()}
    same = nacre.preview_tables(text, sizes)
    assert set(same) == set(sizes) - {"R_further", "R_schlick"}
    for name, texels in same.items():
        assert texels.shape == compiled.tables[name].shape
        assert np.abs(texels - compiled.tables[name]).mean() < 0.01
    other = nacre.preview_tables(text.replace("Fe/Johnson", "Cu/Johnson"), sizes)
    assert np.abs(other["R"] - same["R"]).max() > 0.1
    with pytest.raises(nacre.NacreError, match="no table T; compile it anew"):
        nacre.preview_tables(text, {"T": (8, 8)})
    with pytest.raises(nacre.NacreError, match=r"sizes\['R'\]: must be above 0"):
        nacre.preview_tables(text, {"R": (0, 8)})
    with pytest.raises(nacre.NacreError, match="unobtainium"):
        nacre.preview_tables(text.replace("Fe/Johnson", "unobtainium"), sizes)


def test_spectrum_of_a_template_is_that_of_its_stack():
    text = (TEMPLATES / "tempered_steel.toml").read_text("utf-8")
    text = text.replace('medium = "air"', "n = 1.0")
    found = nacre.template_spectrum(text, 40.0, 55.0)
    wavelengths = np.arange(360.0, 831.0)
    n = [nacre.library.medium(key).index(wavelengths) for key in ("Fe3O4/Querry", "Fe/Johnson")]
    stack = np.stack([np.ones(471), *n], axis=-1)
    exact = nacre.stack(stack, [40.0], 55.0, wavelengths, pol="u")
    np.testing.assert_allclose(found.reflectance, exact.R, atol=1e-9)
    rgb = nacre.spectrum_to_colour(wavelengths, found.reflectance, "reflectance").rgb
    np.testing.assert_allclose(found.colours[0], rgb, atol=1e-9)
    with pytest.raises(nacre.NacreError, match="angle_deg"):
        nacre.template_spectrum(text, 40.0, 91.0)


def test_text_that_is_no_toml():
    with pytest.raises(nacre.NacreError, match=r"^template\.toml:1: "):
        nacre.compile_template("[[")
