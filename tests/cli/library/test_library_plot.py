# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre library show --plot`: pictures of spectra and of optical constants."""

from __future__ import annotations

import json
from xml.etree import ElementTree

import numpy as np
import OpenImageIO as oiio
import pytest

SVG = "{http://www.w3.org/2000/svg}"
SIZE = (1800, 1080)
SWATCH = (1428, 176, 1752, 376)  # left, top, right, bottom, in pixels
AREA = (152, 176, 1264, 840)


def plot(nacre, key, path):
    nacre.ok("library", "show", key, "--plot", path)
    return path


def pixels(path):
    """Rows from above, red, green, blue of 0 to 255."""
    image = oiio.ImageBuf(str(path))
    assert (image.spec().width, image.spec().height) == SIZE
    return np.rint(image.get_pixels(oiio.FLOAT)[..., :3] * 255).astype(int)


def inside(image, box):
    left, top, right, bottom = box
    return image[top + 4 : bottom - 4, left + 4 : right - 4]


def srgb_bytes(rgb):
    value = np.clip(rgb, 0, 1)
    encoded = np.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)
    return 255 * encoded


def assert_swatch(path, rgb):
    swatch = inside(pixels(path), SWATCH).reshape(-1, 3)
    assert (swatch == swatch[0]).all()
    assert np.abs(swatch[0] - srgb_bytes(np.array(rgb))).max() <= 1


@pytest.mark.parametrize("key", ["colorchecker/dark-skin", "colorchecker/cyan", "cqs/VS1"])
def test_swatch_of_a_reflectance(nacre, tmp_path, key):
    (colour,) = nacre.evaluate("spectrum", [{"spectrum": key}])
    assert_swatch(plot(nacre, key, tmp_path / "a.png"), colour["rgb"])


@pytest.mark.parametrize("key", ["lamp/hps", "cie/A", "study/comb"])
def test_swatch_of_an_emission_is_its_chromaticity(nacre, tmp_path, key):
    (colour,) = nacre.evaluate("spectrum", [{"illuminant": key}], "--gamut", "scale")
    assert_swatch(plot(nacre, key, tmp_path / "a.png"), colour["rgb"])


def test_swatch_of_a_metal_is_its_reflectance(nacre, tmp_path):
    wavelengths = list(range(360, 831))
    options = [option for nm in wavelengths for option in ("--at", nm)]
    shown = json.loads(nacre.ok("library", "show", "Au/Johnson", "--json", *options))
    index = np.array([complex(at["n"], at["k"]) for at in shown["at"]])
    reflectance = np.abs((index - 1) / (index + 1)) ** 2
    record = {"wavelength_nm": wavelengths, "values": reflectance.tolist(), "kind": "reflectance"}
    (colour,) = nacre.evaluate("spectrum", [record])
    assert_swatch(plot(nacre, "Au/Johnson", tmp_path / "a.png"), colour["rgb"])


def test_swatch_of_a_metal_whose_ends_are_held(nacre, tmp_path):
    """AuAl2 is known up to 790 nm; what is not known from 400 to 700 nm has no colour."""
    record = {"n": [1, "AuAl2/Chen"], "d_nm": [], "angle_deg": 0}
    colour = nacre.evaluate("colour", record, "--sampling", "full")["reflectance"]["rgb"]
    assert_swatch(plot(nacre, "AuAl2/Chen", tmp_path / "a.png"), colour)
    table = tmp_path / "short.csv"
    table.write_text("wavelength_nm,n,k\n401,1,3\n900,1,3\n", encoding="utf-8")
    nacre.ok("library", "import", table, "--kind", "medium", "--as", "short")
    assert_swatch(plot(nacre, "short", tmp_path / "b.png"), (1, 1, 1))


def test_the_curve_stands_where_the_numbers_are(nacre, tmp_path):
    nacre.ok(
        *("library", "define", "steps", "--kind", "reflectance", "--range", "400:700"),
        *("--points", "400:0.25,549:0.25,551:0.75,700:0.75"),
    )
    area = pixels(plot(nacre, "steps", tmp_path / "a.png"))
    left, top, right, bottom = AREA
    for nm, value in ((430, 0.25), (470, 0.25), (630, 0.75), (670, 0.75)):
        x = round(left + (nm - 400) / 300 * (right - left))
        dark = np.flatnonzero(area[top + 4 : bottom - 4, x].max(axis=1) < 80) + top + 4
        # The axis goes from 0 to 0.8.
        expected = bottom - value / 0.8 * (bottom - top)
        assert dark.size <= 6
        assert abs(dark.mean() + 0.5 - expected) <= 1.5


def test_under_the_curve_are_the_colours_of_the_spectrum(nacre, tmp_path):
    image = pixels(plot(nacre, "study/constant", tmp_path / "a.png"))
    left, _, right, bottom = AREA
    shown = json.loads(nacre.ok("library", "show", "study/constant", "--json"))["range_nm"]
    row = image[bottom - 40]
    colour = {
        nm: row[round(left + (nm - shown[0]) / (shown[1] - shown[0]) * (right - left))]
        for nm in (465, 530, 640, 810)
    }
    assert colour[465].argmax() == 2
    assert colour[530].argmax() == 1
    assert colour[640].argmax() == 0
    assert colour[810].min() == 255


@pytest.mark.parametrize("key", ["colorchecker/dark-skin", "Au/Johnson", "SiO2/Malitson"])
def test_svg_is_a_document_with_a_title_and_a_curve(nacre, tmp_path, key):
    path = plot(nacre, key, tmp_path / "a.svg")
    root = ElementTree.parse(path).getroot()
    assert root.tag == SVG + "svg"
    assert (root.get("width"), root.get("height")) == ("900px", "540px")
    name = json.loads(nacre.ok("library", "show", key, "--json"))["name"]
    assert root.find(SVG + "title").text == name
    longest = max(len(curve.get("d").split("L")) for curve in root.iter(SVG + "path"))
    assert longest >= 300


def test_same_bytes_each_time(nacre, tmp_path):
    for extension in ("svg", "png"):
        first = plot(nacre, "lamp/hps", tmp_path / f"a.{extension}").read_bytes()
        assert plot(nacre, "lamp/hps", tmp_path / f"b.{extension}").read_bytes() == first


def test_a_medium_has_two_axes_where_it_absorbs(nacre, tmp_path):
    def side(key):
        """The strip to the right of the plot, where the numbers of k stand."""
        return pixels(plot(nacre, key, tmp_path / "a.png"))[AREA[1] : AREA[3], AREA[2] + 8 : 1400]

    assert side("SiO2/Malitson").min() == 255
    assert side("N-BK7/SCHOTT").min() < 100
    assert side("Au/Johnson").min() < 100


def test_long_texts_and_marks_stay_on_the_page(nacre, tmp_path):
    name = "<&> " + "sehr langer Name äöü " * 30
    words = ("--name", name, "--citation", "citation " * 200, "--tags", "<tag>")
    nacre.ok("library", "define", "x", "--kind", "emission", "--constant", "1", *words)
    root = ElementTree.parse(plot(nacre, "x", tmp_path / "a.svg")).getroot()
    assert root.find(SVG + "title").text == name.strip()
    image = pixels(plot(nacre, "x", tmp_path / "a.png"))
    for edge in (image[:, :20], image[:, -20:], image[:20], image[-20:]):
        assert edge.min() == 255


def test_every_entry_can_be_drawn(nacre, tmp_path):
    keys = [
        entry["key"]
        for kind in ("media", "spectra")
        for entry in json.loads(nacre.ok("library", "list", "--kind", kind, "--json"))
    ]
    for key in keys[::12]:
        assert plot(nacre, key, tmp_path / "a.svg").stat().st_size > 10_000


@pytest.mark.parametrize(
    "rows",
    [
        "400,1\n700,1.0000000000000002\n",
        "400,0\n700,5e-324\n",
        "400,0\n500,1e300\n700,1e-300\n",
        "500,1\n500.0001,2\n",
        "100000000000000000,1\n100000000000000064,2\n",
        "2000,1\n9000,2\n",
    ],
)
def test_numbers_of_any_size_are_drawn(nacre, tmp_path, rows):
    path = tmp_path / "x.csv"
    path.write_text(rows)
    nacre.ok("library", "import", path, "--kind", "emission", "--as", "x")
    root = ElementTree.parse(plot(nacre, "x", tmp_path / "a.svg")).getroot()
    assert "nan" not in ElementTree.tostring(root, encoding="unicode")


@pytest.mark.parametrize("name", ["a.pdf", "a", "a.SVG.txt"])
def test_other_files_are_refused(nacre, tmp_path, name):
    path = tmp_path / name
    errors = nacre.fails("library", "show", "air", "--plot", path)
    assert f"{path}: --plot: must end in .svg or .png" in errors
    assert not path.exists()


def test_what_is_not_there_is_not_drawn(nacre, tmp_path):
    nacre.fails("library", "show", "Xx/Nobody", "--plot", tmp_path / "a.svg")
    assert list(tmp_path.iterdir()) == []
    nacre.fails("library", "show", "air", "--plot", tmp_path / "none" / "a.svg")
