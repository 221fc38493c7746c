# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre library import`: files of others become entries of one's own library."""

from __future__ import annotations

import json

import pytest

from support.paths import OPTICAL_CONSTANTS

SPD = "# lamp\n400 0.5\n500 1\n600 0.25\n"
SPDX = """\
<IESTM2714 version="1.0"><Header><Manufacturer>Maker</Manufacturer></Header>
<SpectralDistribution><SpectralQuantity>flux</SpectralQuantity>
<SpectralData wavelength="400">1</SpectralData><SpectralData wavelength="700">2</SpectralData>
</SpectralDistribution></IESTM2714>
"""
CGATS = """\
CGATS.17
BEGIN_DATA_FORMAT
SAMPLE_NAME SPECTRAL_NM400 SPECTRAL_NM700
END_DATA_FORMAT
BEGIN_DATA
"red patch" 0.25 0.5
"red patch" 0.125 0.5
blue 0.75 0.5
END_DATA
"""
YAML = "DATA:\n  - type: tabulated n\n    data: |\n        0.3 1.5\n        0.9 1.4\n"


def write(folder, name, text):
    path = folder / name
    path.write_text(text)
    return path


def spectrum(nacre, key):
    return json.loads(nacre.ok("library", "show", key, "--json"))


def test_a_lamp_of_each_format(nacre, tmp_path):
    for name, text in (("a.spd", SPD), ("b.csv", "400,1\n700,2\n"), ("c.spdx", SPDX)):
        nacre.ok("library", "import", write(tmp_path, name, text), "--kind", "emission")
    assert spectrum(nacre, "user/a")["values"] == [0.5, 1, 0.25]
    assert spectrum(nacre, "user/b")["wavelength_nm"] == [400, 700]
    assert spectrum(nacre, "user/c")["references"] == "Maker"
    listed = json.loads(nacre.ok("library", "list", "user/", "--kind", "spectra", "--json"))
    assert [entry["key"] for entry in listed] == ["user/a", "user/b", "user/c"]
    assert {entry["library"] for entry in listed} == {"user"}
    (colour,) = nacre.evaluate("spectrum", [{"illuminant": "user/a"}])
    assert colour["XYZ"][1] == pytest.approx(1)


def test_the_patches_of_a_chart_by_their_names(nacre, tmp_path):
    out = nacre.ok("library", "import", write(tmp_path, "c.txt", CGATS), "--as", "chart", "--json")
    assert [entry["key"] for entry in json.loads(out)] == [
        "chart/red-patch",
        "chart/red-patch-2",
        "chart/blue",
    ]
    assert spectrum(nacre, "chart/blue")["kind"] == "reflectance"
    assert spectrum(nacre, "chart/blue")["values"] == [0.75, 0.5]


def test_optical_constants(nacre, tmp_path, own_library):
    nacre.ok("library", "import", write(tmp_path, "g.yml", YAML), "--as", "glass/mine")
    table = write(tmp_path, "oil.csv", "wavelength_nm,n,k\n300,1.5,0\n900,1.4,0.5\n")
    nacre.ok("library", "import", table, "--kind", "medium", "--citation", 'A. "B" 2020')
    shown = json.loads(nacre.ok("library", "show", "user/oil", "--at", "600", "--json"))
    assert shown["references"] == 'A. "B" 2020'
    assert shown["at"] == [pytest.approx({"wavelength_nm": 600, "n": 1.45, "k": 0.25})]
    assert "n = 1.5" in nacre.ok("library", "show", "glass/mine", "--at", "300")
    nacre.ok("library", "check", *own_library.rglob("*.yml"))
    film = {
        "ambient": {"medium": "air"},
        "layer": [{"medium": "glass/mine", "thickness_nm": 100}],
        "substrate": {"medium": "user/oil"},
    }
    nacre.ok("library", "check", write(tmp_path, "film.json", json.dumps(film)))


def test_constants_as_refractiveindex_info_has_them(nacre, tmp_path):
    """Magnetite by Querry comes with Nacre, rows sorted; here they stand as in the database."""
    text = (OPTICAL_CONSTANTS / "Fe3O4" / "Querry.yml").read_text()
    ours, theirs = "        2.8902 ", "        2.8918 "
    first, second = (
        next(li for li in text.splitlines() if li.startswith(w)) for w in (ours, theirs)
    )
    swapped = text.replace(f"{first}\n{second}", f"{second}\n{first}")
    assert swapped != text
    path = write(tmp_path, "Querry.yml", swapped)
    change = "changed: DATA[0].data: sorted by wavelength (1 row, the first in line "
    for command in (("check",), ("import",)):
        done = nacre("library", *command, path)
        assert (done.returncode, f"{path}: " in done.stderr) == (0, True), done.stderr
        assert "sorted by wavelength (1 row, the first in line" in done.stderr
    assert change in nacre.ok("library", "show", "user/Querry")
    at = ("--at", "550", "--at", "2891", "--json")
    mended, shipped = (
        json.loads(nacre.ok("library", "show", key, *at)) for key in ("user/Querry", "Fe3O4/Querry")
    )
    assert mended["at"] == shipped["at"]
    assert len(mended["changes"]) == 1
    assert shipped["changes"] == []
    assert "sorted" in nacre("bake", "material", path, "-o", tmp_path / "m.csv").stderr
    assert nacre("--quiet", "library", "check", path).stderr == ""


ETA = "300 1.5\n400 0.5\n700 1.1\n"
K = "350 2\n600 4\n800 6\n"


@pytest.mark.parametrize("kind", [(), ("--kind", "medium")])
def test_a_metal_as_pbrt_has_it(nacre, tmp_path, kind):
    pair = (write(tmp_path, "Au.k.spd", K), write(tmp_path, "Au.eta.spd", ETA))
    nacre.ok("library", "import", *pair, *kind, "--citation", "me")
    shown = json.loads(nacre.ok("library", "show", "user/Au", "--at", "600", "--json"))
    assert (shown["references"], shown["range_nm"]) == ("me", [350, 700])
    assert shown["at"] == [pytest.approx({"wavelength_nm": 600, "n": 0.9, "k": 4})]
    lamp = write(tmp_path, "lamp.csv", "wavelength_nm,n,k\n300,1.5,0\n900,1.4,0.5\n")
    out = nacre.ok("library", "import", *pair, lamp, "--kind", "medium", "--as", "metal", "--json")
    assert [entry["key"] for entry in json.loads(out)] == ["metal/Au", "metal/lamp"]
    nacre.ok("library", "import", *pair, *kind, "--as", "gold")
    assert json.loads(nacre.ok("library", "show", "gold", "--json"))["range_nm"] == [350, 700]


def test_half_a_metal_is_refused(nacre, tmp_path, own_library):
    eta = write(tmp_path, "Au.eta.spd", ETA)
    k = write(tmp_path, "Au.k.spd", K)
    errors = nacre.fails("library", "import", eta)
    assert f"{eta}: must come with {k}, n and k of one medium" in errors
    errors = nacre.fails("library", "import", k, "--kind", "medium")
    assert f"{k}: must come with {eta}, n and k of one medium" in errors
    write(tmp_path, "Au.k.spd", "900 1\n950 1\n")
    assert f"{k}: wavelength: must overlap 300 … 700 nm" in nacre.fails("library", "import", eta, k)
    assert not own_library.exists()
    nacre.ok("library", "import", eta, "--kind", "emission")
    assert spectrum(nacre, "user/Au.eta")["values"] == [1.5, 0.5, 1.1]


def test_citation_licence_scale_and_replace(nacre, tmp_path):
    path = write(tmp_path, "p.csv", "400,50\n700,25\n")
    arguments = ("library", "import", path, "--kind", "reflectance", "--as", "p")
    assert "must be ratios or per cent" in nacre.fails(*arguments)
    nacre.ok(*arguments, "--scale", "0.01", "--citation", "me", "--licence", "CC0 1.0")
    shown = spectrum(nacre, "p")
    assert (shown["references"], shown["licence"]) == ("me", "CC0 1.0")
    assert shown["values"] == [0.5, 0.25]
    assert "p: is there already" in nacre.fails(*arguments, "--scale", "0.02")
    nacre.ok(*arguments, "--scale", "0.02", "--replace")
    assert spectrum(nacre, "p")["values"] == [1, 0.5]


BLACK = """\
CGATS.17
BEGIN_DATA_FORMAT
SAMPLE_NAME SPECTRAL_NM400 SPECTRAL_NM550 SPECTRAL_NM700
END_DATA_FORMAT
BEGIN_DATA
black 1.2 1.45 1.7
END_DATA
"""


def test_per_cent_is_not_taken_for_ratios(nacre, tmp_path, own_library):
    chart = write(tmp_path, "black.txt", BLACK)
    arguments = ("library", "import", chart, "--as", "black")
    errors = nacre.fails(*arguments)
    assert f"{chart}: black: must be ratios or per cent" in errors
    assert "(got 1.2 … 1.7): give a scale, 0.01 for per cent" in errors
    # Nothing reflects more than all light at every wavelength.
    assert "must be ≤ 1 somewhere" in nacre.fails(*arguments, "--scale", "1")
    assert not own_library.exists()
    nacre.ok(*arguments, "--scale", "0.01")
    assert spectrum(nacre, "black")["values"] == pytest.approx([0.012, 0.0145, 0.017])

    bake = ("bake", "spectra", chart, "-o", tmp_path / "black.csv")
    assert "black: must be ratios or per cent" in nacre.fails(*bake)
    nacre.ok(*bake, "--scale", "0.01")
    lamp = write(tmp_path, "lamp.spd", "400 1.2\n700 1.7\n")
    out = tmp_path / "x.csv"
    assert "per cent" in nacre.fails("bake", "spectra", lamp, "--kind", "reflectance", "-o", out)
    assert "per cent" in nacre.fails(
        "bake", "material", "air", "--intensity", lamp, "-o", tmp_path / "m.csv"
    )
    nacre.ok("bake", "spectra", lamp, "--kind", "emission", "-o", out)


def test_a_table_as_a_spreadsheet_saves_it(nacre, tmp_path):
    table = tmp_path / "Messung 1.txt"
    table.write_text(
        "λ (nm);Weiß R (%);Schwarz R (%);\n700;96,5;1,7;\n400;91;1,2;\n;;;\n", "utf-16"
    )
    nacre.ok("library", "import", table, "--kind", "reflectance", "--as", "sheet")
    (white, black) = json.loads(nacre.ok("library", "list", "sheet", "--kind", "spectra", "--json"))
    assert {white["name"], black["name"]} == {"Weiß R", "Schwarz R"}
    dark = next(entry["key"] for entry in (white, black) if entry["name"] == "Schwarz R")
    assert spectrum(nacre, dark)["wavelength_nm"] == [400, 700]
    assert spectrum(nacre, dark)["values"] == pytest.approx([0.012, 0.017])

    energies = write(tmp_path, "e.csv", "Energy (eV),n,k\n1.5,1.5,0\n3.5,1.4,0.5\n")
    errors = nacre.fails("library", "import", energies, "--kind", "medium")
    assert f"{energies}:1: wavelength: the first column must be numbers, or be called" in errors
    assert "(got 'Energy (eV)')" in errors
    assert len(errors.splitlines()) == 1


def files(folder):
    return [path for path in folder.rglob("*") if path.is_file()]


def test_whole_or_not_at_all(nacre, tmp_path, own_library):
    good = write(tmp_path, "good.spd", SPD)
    bad = write(tmp_path, "bad.spd", "400 x\n500\n")
    arguments = ("library", "import", "--kind", "emission")
    errors = nacre.fails(*arguments, good, bad, tmp_path / "missing.spd").splitlines()
    assert errors[0].startswith(f"nacre library import: {bad}:1: value: must be a finite number")
    assert errors[1].startswith(f"nacre library import: {bad}:2: ")
    assert f"{tmp_path / 'missing.spd'}: " in errors[-1]
    assert files(own_library) == []

    (own_library / "spectra/user/second.csv").mkdir(parents=True)
    second = write(tmp_path, "second.spd", SPD)
    nacre.fails(*arguments, good, second)
    assert files(own_library) == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "--kind: must be emission or reflectance: the file does not tell"),
        (("--kind", "colour"), "--kind"),
        (("--kind", "emission", "--as", "cie/D65"), "cie/D65: comes with Nacre"),
        (("--kind", "emission", "--as", "../../x"), "../../x: must be up to four names"),
        (("--kind", "emission", "--as", "/etc/x"), "must be up to four names"),
        (("--kind", "emission", "--scale", "-1"), "--scale"),
        (("--kind", "emission", "--scale", "nan"), "--scale"),
        (("--kind", "medium"), "must have"),
    ],
)
def test_what_is_refused(nacre, tmp_path, own_library, arguments, message):
    path = write(tmp_path, "lamp.spd", SPD)
    assert message in nacre.fails("library", "import", path, *arguments)
    assert not own_library.exists()


def test_constants_are_no_spectra_and_keep_their_citation(nacre, tmp_path):
    path = write(tmp_path, "g.yml", "REFERENCES: book\n" + YAML)
    assert "--kind: must be medium" in nacre.fails("library", "import", path, "--kind", "emission")
    errors = nacre.fails("library", "import", path, "--citation", "me")
    assert "REFERENCES: is stated" in errors


def test_no_folder_for_a_library(nacre, tmp_path):
    path = write(tmp_path, "lamp.spd", SPD)
    env = {"XDG_DATA_HOME": "", "HOME": ""}
    arguments = ("library", "import", path, "--kind", "emission")
    assert "XDG_DATA_HOME: must be an absolute path" in nacre.fails(*arguments, env=env)


def test_bytes_of_any_kind_are_refused(nacre, tmp_path, own_library):
    noise = bytes(range(256)) * 40
    for extension in ("csv", "spd", "spdx", "cgats", "yml", "txt"):
        path = tmp_path / f"noise.{extension}"
        path.write_bytes(noise)
        errors = nacre.fails(
            "library", "import", path, "--kind", "medium" if extension == "yml" else "emission"
        )
        assert f"nacre library import: {path}" in errors
        assert len(errors.splitlines()) <= 50
    assert not own_library.exists()
