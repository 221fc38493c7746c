# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre library define`: spectra made by hand, as sums of simple shapes."""

from __future__ import annotations

import json
import math

import pytest


def define(nacre, *arguments):
    """The spectrum that a definition makes, as wavelength and value."""
    text = nacre.ok("library", "define", "-o", "-", *arguments)
    rows = [line for line in text.splitlines() if not line.startswith("#")]
    assert rows[0] == "wavelength_nm,value"
    return {float(nm): float(value) for nm, value in (row.split(",") for row in rows[1:])}


def test_an_entry_of_the_library(nacre, own_library):
    arguments = ("library", "define", "paint/teal", "--kind", "reflectance", "--constant", "0.05")
    words = ("--name", "Teal", "--citation", "me", "--licence", "CC0 1.0", "--tags", "paint,blue")
    nacre.ok(*arguments, "--gaussian", "490:80:0.4", *words, "--tags", "mine")
    shown = json.loads(nacre.ok("library", "show", "paint/teal", "--at", "490", "--json"))
    assert shown["name"] == "Teal"
    assert shown["kind"] == "reflectance"
    assert (shown["references"], shown["licence"]) == ("me", "CC0 1.0")
    assert shown["tags"] == ["paint", "blue", "mine"]
    assert shown["comments"] == "constant 0.05 + gaussian 490:80:0.4"
    assert shown["range_nm"] == [300, 850]
    assert shown["at"][0]["value"] == pytest.approx(0.45)
    (colour,) = nacre.evaluate("spectrum", [{"spectrum": "paint/teal"}])
    assert colour["rgb"][2] > colour["rgb"][0]
    assert "paint/teal: is there already" in nacre.fails(*arguments)
    out = nacre.ok(*arguments, "--replace", "--json")
    assert json.loads(out) == {
        "key": "paint/teal",
        "file": str(own_library / "spectra/paint/teal.csv"),
    }
    shown = json.loads(nacre.ok("library", "show", "paint/teal", "--json"))
    assert set(shown["values"]) == {0.05}


def test_every_shape_and_their_sum(nacre):
    short = ("--kind", "emission", "--range", "400:700", "--step", "5")
    box = define(nacre, *short, "--box", "450:650:2")
    assert box == {nm: 2.0 if 450 <= nm <= 650 else 0.0 for nm in range(400, 705, 5)}
    soft = define(nacre, *short, "--box", "450:650:2:40")
    assert (soft[430], soft[450], soft[470]) == (0, pytest.approx(1), 2)
    bell = define(nacre, *short, "--gaussian", "550:40:3")
    assert bell[600] == pytest.approx(3 * math.exp(-4 * math.log(2) * (50 / 40) ** 2))
    line = define(nacre, *short, "--points", "400:0.1,500:0.7,600:0.3")
    assert (line[450], line[550], line[700]) == (pytest.approx(0.4), pytest.approx(0.5), 0.3)
    curve = define(
        nacre, *short, "--points", "400:0.1,500:0.7,600:0.3", "--interpolation", "smooth"
    )
    assert max(curve.values()) == curve[500] == 0.7
    assert curve[450] == pytest.approx(0.5375)  # Fritsch and Carlson, by hand
    lamp = define(nacre, *short, "--from", "cie/A:0.5")
    shown = json.loads(nacre.ok("library", "show", "cie/A", "--at", "555", "--json"))
    assert lamp[555] == pytest.approx(0.5 * shown["at"][0]["value"])

    every = ("--box", "450:650:2", "--box", "450:650:2:40", "--gaussian", "550:40:3")
    total = define(
        nacre, *short, *every, "--points", "400:0.1,500:0.7,600:0.3", "--from", "cie/A:0.5"
    )
    for nm, value in total.items():
        assert value == pytest.approx(box[nm] + soft[nm] + bell[nm] + line[nm] + lamp[nm])


def test_negative_shapes_take_away(nacre):
    dip = ("--constant", "1", "--constant", "-0.125", "--gaussian", "550:40:-0.5")
    values = define(nacre, "--kind", "reflectance", *dip)
    assert values[550] == 0.375
    assert values[300] == 0.875


def test_a_copy_of_a_spectrum_has_its_colour(nacre):
    keys = ("colorchecker/red", "cqs/VS1", "study/gold")
    for key in keys:
        nacre.ok("library", "define", f"copy/{key}", "--kind", "reflectance", "--from", key)
    records = [{"spectrum": key} for key in keys] + [{"spectrum": f"copy/{key}"} for key in keys]
    colours = [colour["XYZ"] for colour in nacre.evaluate("spectrum", records)]
    for original, copy in zip(colours[:3], colours[3:], strict=True):
        assert copy == pytest.approx(original, abs=1e-12)


def test_a_file_in_place_of_the_library(nacre, tmp_path, own_library):
    path = tmp_path / "flat.csv"
    nacre.ok("library", "define", "--kind", "reflectance", "--constant", "0.5", "-o", path)
    nacre.ok("library", "check", path)
    assert not own_library.exists()
    nacre.ok("library", "import", path, "--as", "flat")
    shown = json.loads(nacre.ok("library", "show", "flat", "--json"))
    assert (shown["kind"], shown["comments"]) == ("reflectance", "constant 0.5")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "must have --constant, --box, --gaussian, --points or --from"),
        (("--constant", "a"), "--constant a: must be a number"),
        (("--constant", ""), "--constant : must be a number"),
        (("--constant", "1e999"), "--constant 1e999: must be a number"),
        (("--constant", "inf"), "--constant inf: the value must be finite (got inf)"),
        (("--constant", "-0.5"), "--kind: the sum does not suit: a reflectance must be in [0, 2]"),
        (("--constant", "3"), "(got 3 … 3)"),
        (("--box", "1:2"), "--box 1:2: must be FIRST:LAST:VALUE or FIRST:LAST:VALUE:EDGE"),
        (("--box", "1:2:3:4:5"), "--box 1:2:3:4:5: must be FIRST:LAST:VALUE or"),
        (("--box", "600:500:1"), "the last wavelength must be > the first (got 500 after 600)"),
        (("--box", "500:600:1:200"), "the edge must be in [0, 100], the width of the box"),
        (("--gaussian", "500:10"), "--gaussian 500:10: must be CENTRE:FWHM:PEAK"),
        (("--gaussian", "500:-4:1"), "the width must be finite and > 0 (got -4)"),
        (("--gaussian", "500:4:nan"), "the peak must be finite (got nan)"),
        (("--points", "400:1"), "must hold at least two samples (got 1)"),
        (("--points", "400:1,300:1"), "must be finite, > 0 and ascending (got 300)"),
        (("--points", "400:1,500"), "--points 400:1,500: must be NM:VALUE,NM:VALUE,…"),
        (("--from", "lamp/hsp"), "--from lamp/hsp: spectrum must be a key of the library, perhaps"),
        (("--from", "lamp/hps:x"), "--from lamp/hps:x: must be KEY or KEY:FACTOR"),
        (("--from", "lamp/hps:1:2"), "--from lamp/hps:1:2: must be KEY or KEY:FACTOR"),
        (("--from", "lamp/hps:inf"), "the factor must be finite (got inf)"),
        (("--constant", "1", "--range", "400"), "--range: must be FIRST:LAST, two numbers"),
        (("--constant", "1", "--range", "0:400"), "--range: must be two wavelengths, > 0"),
        (("--constant", "1", "--range", "900:990"), "--range: must overlap 360 … 830 nm"),
        (("--constant", "1", "--step", "0"), "--step: must be finite and > 0 (got 0)"),
        (("--constant", "1", "--step", "7"), "--step: must go into the range a whole number"),
        (("--constant", "1", "--step", "1e-5"), "--step: must give at most 100000 samples"),
        (("--constant", "1", "--interpolation", "cubic"), "--interpolation"),
    ],
)
def test_what_is_refused(nacre, own_library, arguments, message):
    command = ("library", "define", "x", "--kind", "reflectance")
    assert message in nacre.fails(*command, *arguments)
    assert not own_library.exists()


def test_where_it_may_go(nacre, tmp_path, own_library):
    flat = ("library", "define", "--kind", "emission", "--constant", "1")
    assert "KEY: must be given, or else --output FILE.csv" in nacre.fails(*flat)
    assert "and not both" in nacre.fails(*flat, "x", "-o", tmp_path / "x.csv")
    assert "x.txt: must end in .csv" in nacre.fails(*flat, "-o", tmp_path / "x.txt")
    assert "cie/D65: comes with Nacre" in nacre.fails(*flat, "cie/D65")
    assert "../x: must be up to four names" in nacre.fails(*flat, "../x")
    assert "--kind" in nacre.fails("library", "define", "x", "--constant", "1")
    assert not own_library.exists()
    assert list(tmp_path.iterdir()) == []


def test_all_problems_at_once(nacre):
    errors = nacre.fails(
        *("library", "define", "x", "--kind", "emission"),
        *("--constant", "a", "--box", "1:2", "--gaussian", "500:0:1", "--range", "1"),
    ).splitlines()
    assert len(errors) == 4
    assert all(line.startswith("nacre library define: --") for line in errors)
