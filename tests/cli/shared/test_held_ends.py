# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Media whose data end within 360 … 830 nm: held with a note by default, refused by --strict-range."""

from __future__ import annotations

import json

import pytest

from support.gltf import read_gltf
from support.images import json_attribute, read_all

ENDS = "BaTiO3/Wemple-o"  # 400 … 700 nm
SHORT = "TiO2/Devore-o"  # 430 … 1530 nm
NOTE = (
    f"{ENDS}: n and k are held beyond 400 … 700 nm, 0.0402 % of the luminous weight (D65, cie1931)"
)
HELD = {"medium": ENDS, "range_nm": [400, 700], "percent": pytest.approx(0.0402, abs=5e-5)}
REFUSED = "must be within the data, 400 … 700 nm (got 360); without --strict-range"
IN_COLOURS = "in colours"
NEEDED = "must be within the data, 430 … 1530 nm (got 400); what is needed is 400 … 700 nm"


def film(folder, layer=ENDS, substrate="n = 2.5\nk = 1.0\n"):
    path = folder / "coated.toml"
    path.write_text(
        'schema = 1\n[material]\nid = "coated"\nname = "Coated"\ncategory = "Tests"\n'
        f'source = "made up"\n[ambient]\nmedium = "air"\n[[layer]]\nmedium = "{layer}"\n'
        "thickness_nm = { default = 200, min = 0, max = 400, varies = true }\n"
        f"[substrate]\n{substrate}"
    )
    return path


def noted(nacre, *arguments):
    """Standard output of a run that succeeds and has said once what is held."""
    result = nacre(*arguments)
    assert result.returncode == 0, result.stderr
    assert result.stderr.count(NOTE) == 1, result.stderr
    return result.stdout


@pytest.fixture
def out(tmp_path):
    folder = tmp_path / "out"
    folder.mkdir()
    return folder


def test_a_compiled_material_says_what_is_held(nacre, tmp_path, out):
    path = film(tmp_path)
    noted(nacre, "compile", path, "--tolerance", 2, "-o", out)
    manifest = json.loads((out / "coated" / "coated.json").read_text("utf-8"))
    assert manifest["held_ends"] == [{**HELD, "note": NOTE}]
    _, attributes = read_all(out / "coated" / "coated_R.exr")
    assert json_attribute(attributes, "held_ends") == manifest["held_ends"]
    assert NOTE in nacre.ok("info", out / "coated" / "coated_R.exr")
    result = nacre("--quiet", "compile", path, "--tolerance", 2, "-o", out)
    assert (result.returncode, result.stderr) == (0, "")


def test_the_bare_substrate_holds_nothing(nacre, tmp_path, out):
    text = film(tmp_path).read_text() + (
        '[[parameter]]\nname = "coverage"\nlabel = "Coverage"\ndefault = 1.0\n'
    )
    (tmp_path / "coated.toml").write_text(text)
    nacre.ok("compile", tmp_path / "coated.toml", "--tolerance", 2, "-o", out)
    _, attributes = read_all(out / "coated" / "coated_R_bare.exr")
    assert "nacre:held_ends" not in attributes


COMMANDS = {
    "compile": ("compile", "FILM", "--tolerance", 2, "-o", "m"),
    "bake stack": ("bake", "stack", "FILM", "--size", "4x4", "-o", "t.exr"),
    "bake ramp": ("bake", "ramp", "FILM", "--size", 4, "-o", "t.cube"),
    "bake material": ("bake", "material", "MEDIUM", "-o", "t.exr"),
    "export materialx": ("export", "materialx", "FILM", "--tolerance", 2, "-o", "t.mtlx"),
    "export gltf": ("export", "gltf", "FILM", "-o", "t.gltf"),
    "export mitsuba": ("export", "mitsuba", "FILM", "--tolerance", 2, "-o", "t.xml"),
    "export table": ("export", "table", "FILM", "--size", "4x4", "-o", "t.exr"),
    "export cube": ("export", "cube", "FILM", "--size", 4, "-o", "t.cube"),
    "export csv": ("export", "csv", "FILM", "--size", 4, "-o", "t.csv"),
    "library check": ("library", "check", "FILM"),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_holds_says_so_or_refuses(nacre, tmp_path, out, command):
    def run(*more, medium=ENDS):
        words = {"FILM": film(tmp_path, medium), "MEDIUM": medium}
        return nacre(*(words.get(word, word) for word in COMMANDS[command]), *more, cwd=out)

    for more, medium, message in (("--strict-range", ENDS, REFUSED), (None, SHORT, NEEDED)):
        refused = run(*([more] if more else []), medium=medium)
        assert refused.returncode == 1
        assert message in refused.stderr
        named = f"{medium}: " if command == "bake material" else "coated.toml:10: layer[0].medium: "
        assert named in refused.stderr
        assert not list(out.iterdir())
    held = run()
    assert held.returncode == 0, held.stderr
    assert held.stderr.count(NOTE) == 1, held.stderr
    whole = run("--strict-range", medium="SiO2/Malitson")
    assert whole.returncode == 0, whole.stderr
    assert "held" not in whole.stderr


def test_files_carry_the_note(nacre, tmp_path, out):
    path = film(tmp_path)
    for name in ("t.cube", "t.csv"):
        noted(nacre, "bake", "ramp", path, "--size", 4, "-o", out / name)
        assert f"# {NOTE}\n" in (out / name).read_text("utf-8")
    noted(nacre, "bake", "material", ENDS, "-o", out / "m.csv")
    assert (out / "m.csv").read_text("utf-8").startswith(f"# COMMENTS: {NOTE}\nwavelength_nm,")
    for name in ("m.exr", "m.png", "m.ftxt"):
        noted(nacre, "bake", "material", ENDS, "-o", out / name)
        described = json.loads(nacre.ok("info", out / name, "--json"))
        assert described["held_ends"] == [{**HELD, "note": NOTE}]
    noted(nacre, "export", "materialx", path, "--tolerance", 2, "-o", out / "t.mtlx")
    assert NOTE in (out / "t.mtlx").read_text("utf-8")
    noted(nacre, "export", "gltf", path, "-o", out / "t.gltf")
    document, _ = read_gltf(out / "t.gltf")
    (material,) = document["materials"]
    assert material["extras"]["nacre"]["held_ends"] == [{**HELD, "note": NOTE}]
    noted(nacre, "export", "table", path, "--size", "4x4", "-o", out / "t.exr")
    assert json.loads((out / "t.json").read_text("utf-8"))["held_ends"][0]["note"] == NOTE
    noted(nacre, "export", "mitsuba", path, "--tolerance", 2, "-o", out / "t.xml")
    _, attributes = read_all(out / "coated_spectrum.exr")
    assert json_attribute(attributes, "material")["held_ends"][0]["note"] == NOTE


def test_a_metal_for_mitsuba_carries_the_note(nacre, tmp_path, out):
    path = tmp_path / "metal.json"
    path.write_text(json.dumps({"ambient": {"n": 1}, "substrate": {"medium": "AuAl2/Chen"}}))
    nacre.ok("export", "mitsuba", path, "-o", out / "t.xml")
    for part in ("eta", "k"):
        text = (out / f"stack_{part}.spd").read_text("utf-8")
        assert text.startswith("# AuAl2/Chen: n and k are held beyond 220 … 790 nm, ")


def test_records_say_what_is_held(nacre):
    record = {"n": [1, ENDS, ENDS, 1.5], "d_nm": [100, 50], "angle_deg": 0}
    result = nacre("eval", "colour", stdin=json.dumps([record, record, {**record, "n": [1, 1.5]}]))
    assert result.returncode == 1  # the last has too many thicknesses
    assert result.stderr.count(NOTE) == 1
    first, second, _ = json.loads(result.stdout)
    assert first == second
    assert first["held_ends"] == [{**HELD, "note": NOTE}]
    (under_a,) = nacre.evaluate("colour", [{**record, "illuminant": "A", "observer": "cie1964"}])
    assert under_a["held_ends"][0]["percent"] > first["held_ends"][0]["percent"]
    assert under_a["held_ends"][0]["note"].endswith("% of the luminous weight (A, cie1964)")
    assert "held_ends" not in nacre.evaluate(
        "colour", {**record, "n": [1, "Ag/Johnson"], "d_nm": []}
    )
    refused = nacre.fails("eval", "colour", "--strict-range", stdin=json.dumps(record))
    assert f"n[1]: {REFUSED}" in refused
    assert f"n[2]: {REFUSED}" in refused
    short = nacre.fails("eval", "colour", stdin=json.dumps({**record, "n": [1, SHORT], "d_nm": []}))
    assert f"n[1]: {NEEDED}" in short


def test_the_library_says_what_is_held_in_colours(nacre):
    assert f"\n{IN_COLOURS}: {NOTE}\n" in nacre.ok("library", "show", ENDS)
    shown = json.loads(nacre.ok("library", "show", ENDS, "--json"))
    assert shown["held_ends"] == {**HELD, "note": NOTE}
    assert f"\n{IN_COLOURS}: refused: {NEEDED}" in nacre.ok("library", "show", SHORT)
    for key in ("Ag/Johnson", "air", SHORT):
        assert json.loads(nacre.ok("library", "show", key, "--json"))["held_ends"] is None
    assert IN_COLOURS not in nacre.ok("library", "show", "Ag/Johnson")
    # One wavelength outside stays an error.
    error = nacre.fails("library", "show", ENDS, "--at", 380)
    assert f"{ENDS}: wavelength_nm: must be within the data, 400 … 700 nm (got 380)" in error
