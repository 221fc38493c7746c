# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre develop`: colours of spectral pictures, against colour-science and sums over 0.1 nm."""

from __future__ import annotations

import json

import colour
import numpy as np
import OpenImageIO as oiio
import pytest

import nacre as library
from support.images import read_image
from support.spectral import delta_e, light_at, observer_at, reflectance_at
from support.spectral_picture import SIZE, power_of, table_of, write

CHART = [key for key in library.library.keys("spectra") if key.startswith("colorchecker/")][:12]


def reflectances(bands):
    rows = [reflectance_at(key, bands.wavelength_nm) for key in CHART]
    return np.array([*rows, np.ones(len(bands))])


def one_light(path, light="D65", made_for=("D65",), count=48):
    bands = library.bands(count, list(made_for))
    power = power_of(bands, light)
    lights = [{"layer": "", "light": light, "power": list(power)}]
    return write(path, bands, {"": reflectances(bands) * power}, lights), bands


def patches(file):
    return read_image(file)[0, ::SIZE]


def xyz_of(rgb):
    """By the matrix that follows from the primaries: sRGB's own has four digits."""
    space = colour.RGB_COLOURSPACES["sRGB"].copy()
    space.use_derived_transformation_matrices(True)
    return rgb @ space.matrix_RGB_to_XYZ.T


def exact(light, cmfs=observer_at):
    """XYZ of the patches where white has Y = 1, and of white."""
    nm, power = light_at(light)
    seen = cmfs(nm) * power[:, None]
    white = seen.sum(axis=0)
    rows = [*(reflectance_at(key, nm) for key in CHART), np.ones(nm.size)]
    return np.array(rows) @ seen / white[1], white / white[1]


def test_as_it_was_rendered(nacre, tmp_path):
    file, _ = one_light(tmp_path / "a.exr")
    nacre.ok("develop", file, "-o", tmp_path / "b.exr")
    expected, white = exact("D65")
    errors = delta_e(xyz_of(patches(tmp_path / "b.exr")), expected, white)
    assert errors.mean() < 0.05
    assert errors.max() < 0.15


@pytest.mark.parametrize("light", ["A", "F11", "LED-B3", "lamp/hps"])
def test_another_lamp_is_as_if_it_had_been_there(nacre, tmp_path, light):
    """Asked for: as a new render would be, within 0.05."""
    file, bands = one_light(tmp_path / "a.exr", made_for=("D65", light))
    nacre.ok("develop", file, "--light", light, "-o", tmp_path / "b.exr")
    found = xyz_of(patches(tmp_path / "b.exr"))
    rendered = (reflectances(bands) * power_of(bands, light)) @ bands.XYZ
    expected, white = exact(light)
    assert delta_e(found, rendered, white).max() < 0.01
    errors = delta_e(found, expected, white)
    assert errors.mean() < 0.1
    assert errors.max() < 0.3


def test_light_groups_are_lamps_of_their_own(nacre, tmp_path):
    bands = library.bands(48, ["D65", "A", "F11"])
    surfaces = reflectances(bands)
    key, fill = 0.7 * power_of(bands, "D65"), 0.2 * power_of(bands, "A")
    glow = 0.1 * power_of(bands, "E")  # in no group
    layers = {"": surfaces * (key + fill + glow), "Key": surfaces * key, "Fill": surfaces * fill}
    lights = [
        {"layer": name, "light": light, "power": list(power_of(bands, light))}
        for name, light in (("Key", "D65"), ("Fill", "A"))
    ]
    file = write(tmp_path / "a.exr", bands, layers, lights)
    nacre.ok(
        "develop", file, "--light", "Key=F11", "--light", "Fill=D65", "--strength", "Fill=3",
        "-o", tmp_path / "b.exr",
    )  # fmt: skip
    power = 0.7 * power_of(bands, "F11") + 0.6 * power_of(bands, "D65") + glow
    expected = (surfaces * power) @ bands.XYZ
    np.testing.assert_allclose(xyz_of(patches(tmp_path / "b.exr")), expected, atol=2e-5)
    said = nacre.fails("develop", file, "--light", "F11", "-o", tmp_path / "c.exr")
    assert "several lights; say which group, GROUP=LIGHT; there are: Fill, Key" in said
    said = nacre.fails("develop", file, "--light", "Rim=F11", "-o", tmp_path / "c.exr")
    assert "no light group 'Rim'" in said
    assert not (tmp_path / "c.exr").exists()


def test_another_observer(nacre, tmp_path):
    file, _ = one_light(tmp_path / "a.exr")
    said = nacre.ok("develop", file, "--observer", "cie1964", "-o", tmp_path / "b.exr")
    assert said == ""

    def wide(nm):
        cmfs = colour.MSDS_CMFS["CIE 1964 10 Degree Standard Observer"].copy()
        cmfs = cmfs.align(colour.SpectralShape(360, 830, 1))
        return np.stack([np.interp(nm, cmfs.wavelengths, cmfs.values[:, c]) for c in range(3)], -1)

    expected, white = exact("D65", wide)
    found = patches(tmp_path / "b.exr")
    np.testing.assert_allclose(found[-1] / found[-1][1], 1.0, atol=2e-3)  # D65 stays white
    to_own_white = white / xyz_of(found[-1])
    errors = delta_e(xyz_of(found) * to_own_white, expected * (1.0 / white[1]), white)
    assert errors.mean() < 0.2  # of Bradford's matrix and none


def test_what_is_white_is_adapted_to(nacre, tmp_path):
    file, _ = one_light(tmp_path / "a.exr", "A", ("A",))
    nacre.ok("develop", file, "-o", tmp_path / "warm.exr")
    warm = patches(tmp_path / "warm.exr")[-1]
    assert warm[0] > 1.5 * warm[2]
    nacre.ok("develop", file, "--white", "A", "--exposure", "1", "-o", tmp_path / "b.exr")
    np.testing.assert_allclose(patches(tmp_path / "b.exr")[-1], 2.0, rtol=1e-4)
    place = f"{SIZE * len(CHART)},0,2,2"
    nacre.ok("develop", file, "--white-at", place, "-o", tmp_path / "c.exr")
    np.testing.assert_allclose(
        2.0 * patches(tmp_path / "c.exr"), patches(tmp_path / "b.exr"), rtol=1e-4
    )


@pytest.mark.parametrize(
    ("key", "name"),
    [("nikon-d5100", "Nikon 5100 (NPL)"), ("sigma-sd1-merrill", "Sigma SDMerill (NPL)")],
)
def test_cameras(nacre, tmp_path, key, name):
    sensed = colour.MSDS_CAMERA_SENSITIVITIES[name]
    nm, power = light_at("D65")
    seen = np.stack(
        [np.interp(nm, sensed.wavelengths, sensed.values[:, c], 0, 0) for c in range(3)], -1
    )
    rows = np.array([reflectance_at(patch, nm) for patch in CHART])
    raw = rows @ (seen * power[:, None]) / (seen * power[:, None]).sum(axis=0)
    file, _ = one_light(tmp_path / "a.exr")
    nacre.ok("develop", file, "--camera", key, "--raw", "-o", tmp_path / "raw.exr")
    np.testing.assert_allclose(patches(tmp_path / "raw.exr")[:-1], raw, atol=2e-3)
    nacre.ok("develop", file, "--camera", key, "-o", tmp_path / "b.exr")
    found = patches(tmp_path / "b.exr")
    np.testing.assert_allclose(found[-1], 1.0, atol=1e-4)
    expected, white = exact("D65")
    errors = delta_e(xyz_of(found), expected, white)
    assert 0.1 < errors.mean() < 4.0  # no camera is an eye
    csv = tmp_path / "mine.csv"
    lines = [
        ",".join(map(str, (wavelength, *values)))
        for wavelength, values in zip(sensed.wavelengths, sensed.values, strict=True)
    ]
    csv.write_text("wavelength_nm,red,green,blue\n" + "\n".join(lines) + "\n")
    nacre.ok("develop", file, "--camera", csv, "-o", tmp_path / "c.exr")
    np.testing.assert_allclose(patches(tmp_path / "c.exr"), found, atol=1e-5)


def test_places_and_metamers(nacre, tmp_path):
    """Two greys that are alike under D65 alone: a flat one and one with a metameric black on it."""
    bands = library.bands(48, ["D65", "F11", "A"])
    power = power_of(bands, "D65")
    seen = bands.XYZ * power[:, None]
    bump = np.cos(np.linspace(0.0, 14.0, len(bands)))
    black = bump - seen @ np.linalg.solve(seen.T @ seen, seen.T @ bump)
    surfaces = 0.5 + np.array([0.0 * black, 0.3 * black / np.abs(black).max()])
    lights = [{"layer": "", "light": "D65", "power": list(power)}]
    file = write(tmp_path / "a.exr", bands, {"": surfaces * power}, lights)
    places = ("--region", "0,0,2,2", "--region", "2,1")
    said = json.loads(
        nacre.ok("develop", file, *places, "--under", "D65", "--under", "F11", "--json",
                 "--spectra", tmp_path / "s.csv", "--plot", tmp_path / "s.svg")
    )  # fmt: skip
    first, second = said["regions"]
    assert (first["region"], second["region"]) == ([0, 0, 2, 2], [2, 1, 1, 1])
    np.testing.assert_allclose(first["XYZ"], (0.5 * power) @ bands.XYZ, rtol=1e-5)
    np.testing.assert_allclose(first["XYZ"], second["XYZ"], rtol=1e-4)
    alike, apart = said["under"]
    assert alike["dE00"] < 0.01
    white = bands.xyz(power_of(bands, "F11"))
    under_f11 = (surfaces * power_of(bands, "F11")) @ bands.XYZ
    assert apart["dE00"] == pytest.approx(delta_e(*under_f11, white), rel=0.01)
    assert apart["index"] == pytest.approx(apart["dE00"], rel=0.01)
    assert apart["dE00"] > 1.0
    table = np.loadtxt(tmp_path / "s.csv", delimiter=",", skiprows=1, comments="#")
    np.testing.assert_allclose(table[:, 0], bands.wavelength_nm, atol=1e-3)
    np.testing.assert_allclose(table[:, 1:], (surfaces * power).T, rtol=1e-5, atol=1e-6)
    assert (tmp_path / "s.svg").read_text().startswith("<?xml")
    shown = nacre.ok("develop", file, *places, "--under", "F11")
    assert "under F11: ΔE00" in shown
    more = ("--region", "1,1", "--region", "3,1")
    nacre.ok("develop", file, *places, *more, "--plot", tmp_path / "many.svg")
    curves = [
        (tmp_path / name).read_text().count("stroke-width:2") for name in ("s.svg", "many.svg")
    ]
    assert curves == [2, 4]


def test_pictures_of_other_programs(nacre, tmp_path):
    """Bands that nobody describes meet half way."""
    bands = library.bands(48, ["D65"])
    power = power_of(bands, "D65")
    file = write(tmp_path / "a.exr", bands, {"": reflectances(bands) * power}, table=False)
    nacre.ok("develop", file, "-o", tmp_path / "b.exr")
    expected, white = exact("D65")
    assert delta_e(xyz_of(patches(tmp_path / "b.exr")), expected, white).mean() < 1.0


def test_screens_see_srgb(nacre, tmp_path):
    file, _ = one_light(tmp_path / "a.exr")
    nacre.ok("develop", file, "-o", tmp_path / "b.exr")
    nacre.ok("develop", file, "--space", "lin_ap1_scene", "-o", tmp_path / "b.png")
    linear = np.clip(patches(tmp_path / "b.exr"), 0, 1)
    curve = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    shown = oiio.ImageBuf(str(tmp_path / "b.png")).get_pixels(oiio.FLOAT)[0, ::SIZE]
    np.testing.assert_allclose(shown, curve, atol=1.01 / 255)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--light", "A"), "of several lights"),
        (("--observer", "me"), "must be cie1931 or cie1964 (got 'me')"),
        (("--camera", "brownie"), "must be one of nikon-d5100, sigma-sd1-merrill"),
        (("--raw",), "--raw: is of a --camera"),
        (("--camera", "nikon-d5100", "--observer", "cie1964"), "leave --observer out"),
        (("--white", "moon"), "moon"),
        (("--white", "D65", "--white-at", "1,1"), "one too many"),
        (("--strength", "Key"), "must be GROUP=FACTOR"),
        (("--region", "99,0"), "must be within"),
        (("--region", "1"), "must be X,Y or X,Y,W,H"),
        (("--under", "A"), "compares two places"),
        (("--spectra", "s.csv"), "are of a --region"),
        (("--exposure", "nan"), "must be a number of stops"),
    ],
)
def test_wrong_wishes_are_told(nacre, tmp_path, options, message):
    bands = library.bands(24, ["D65"])
    file = write(tmp_path / "a.exr", bands, {"": reflectances(bands)})
    said = nacre.fails("develop", file, "-o", tmp_path / "b.exr", *options, cwd=tmp_path)
    assert message in said
    assert not (tmp_path / "b.exr").exists()


def test_files_that_are_none_are_told(nacre, tmp_path):
    bands = library.bands(24, ["D65"])
    whole, table = {"": reflectances(bands)}, table_of(bands)

    def said(**changes):
        file = write(tmp_path / "a.exr", bands, **{"layers": whole, "table": table, **changes})
        return nacre.fails("develop", file, "-o", tmp_path / "b.exr")

    wavelengths = table["wavelength_nm"]
    assert "made by a newer Nacre" in said(table={**table, "version": 2})
    moved = [*wavelengths[:10], wavelengths[10] + 0.01, *wavelengths[11:]]
    assert f"has no channel of {moved[10]:.3f} nm" in said(table={**table, "wavelength_nm": moved})
    assert "nacre:bands: cannot be read" in said(table={"version": 1})
    assert "must be 1 … 300" in said(table={**table, "edges_nm": [360, 830]})
    few = [{"layer": "", "light": "D65", "power": [1.0]}]
    assert "D65 must have 24 powers (got 1)" in said(lights=few)
    ghost = [{"layer": "Key", "light": "D65", "power": [1.0] * 24}]
    assert "of which there are no channels" in said(lights=ghost)
    plain = oiio.ImageBuf(oiio.ImageSpec(4, 4, 3, oiio.FLOAT))
    plain.write(str(tmp_path / "plain.exr"))
    missing = nacre.fails("develop", tmp_path / "plain.exr", "-o", tmp_path / "b.exr")
    assert "has no spectra: channels must be called as S0.550,000nm is" in missing
    sodium = one_light(tmp_path / "c.exr", "line:589.3", ("D65", "line:589.3"))[0]
    dark = nacre.fails("develop", sodium, "--light", "D65", "-o", tmp_path / "b.exr")
    assert "render under a light that has all wavelengths" in dark
    assert not (tmp_path / "b.exr").exists()
