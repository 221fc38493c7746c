# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre library`: what is built in, and what is wrong with a user's own files."""

from __future__ import annotations

import json
import tomllib

import jsonschema
import pytest

from support.osl import SHADER_MATERIALS

GLASS_YAML = """\
REFERENCES: "SCHOTT, N-BK7"
COMMENTS: "test"
DATA:
  - type: formula 2
    wavelength_range: 0.3 2.5
    coefficients: 0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653
"""


def test_every_medium_can_be_shown_with_its_citation(nacre):
    keys = json.loads(nacre.ok("library", "list", "--json"))
    assert len(keys) >= 198
    for entry in keys[::11]:  # all of them: tests/python, in one process
        shown = json.loads(nacre.ok("library", "show", entry["key"], "--at", "550", "--json"))
        assert shown["at"][0]["n"] > 0
        assert shown["at"][0]["k"] >= 0
        if entry["range_nm"]:
            assert shown["references"]
            assert entry["range_nm"][0] <= 550 <= entry["range_nm"][1]


def test_list_is_searched_without_regard_to_case(nacre):
    lines = nacre.ok("library", "list", "JOHNSON").splitlines()
    assert lines
    assert all("Johnson" in line for line in lines)
    assert nacre.ok("library", "list", "no such medium") == ""


def test_list_by_formula_and_tag(nacre):
    def keys(*arguments):
        return {
            entry["key"] for entry in json.loads(nacre.ok("library", "list", *arguments, "--json"))
        }

    assert "ethanol/Chang" in keys("C2H6O")
    metals = keys("--tag", "metal")
    assert {"Au/Johnson", "brass/Querry-Cu70Zn30"} <= metals
    assert not metals & keys("--tag", "oxide")
    assert keys("--tag", "alloy", "gold") < metals
    assert keys("--tag", "no such tag") == set()
    assert "tags: metal, alloy" in nacre.ok("library", "show", "brass/Querry-Cu70Zn30")


def test_spectra_are_listed_and_shown(nacre):
    entries = json.loads(nacre.ok("library", "list", "--kind", "spectra", "--json"))
    assert len(entries) >= 165
    assert {entry["library"] for entry in entries} == {"nacre"}
    for entry in entries[::17]:
        shown = json.loads(nacre.ok("library", "show", entry["key"], "--json"))
        assert shown["references"]
        assert shown["licence"]
        assert len(shown["wavelength_nm"]) == len(shown["values"]) >= 2
    text = nacre.ok("library", "show", "lamp/hps", "--at", "590")
    assert "kind: emission" in text
    assert "590 nm: " in text


def test_spectra_by_name_and_tag(nacre):
    def keys(*arguments):
        text = nacre.ok("library", "list", "--kind", "spectra", *arguments, "--json")
        return {entry["key"] for entry in json.loads(text)}

    assert len(keys("--tag", "colorchecker")) == 24
    assert len(keys("--tag", "study")) == 8
    assert "lamp/phos-1" in keys("--tag", "led")
    assert {"lamp/hps", "lamp/lps"} < keys("SODIUM")
    assert keys("Johnson") == {"study/gold"}


def test_unknown_key_names_near_ones_of_both_kinds(nacre):
    assert "lamp/hps" in nacre.fails("library", "show", "lamp/hpss")
    errors = nacre.fails("library", "show", "lamp/hps", "--kind", "medium")
    assert "medium: must be a key of the library" in errors


def test_a_broken_file_of_ones_own_does_not_hide_the_others(nacre, own_library):
    folder = own_library / "spectra"
    folder.mkdir(parents=True)
    (folder / "bad.csv").write_text("nonsense")
    (folder / "good.csv").write_text("# KIND: emission\n400,1\n700,1\n")
    result = nacre("library", "list", "--kind", "spectra", "--json")
    assert result.returncode == 1
    assert f"{folder / 'bad.csv'}:1: " in result.stderr
    entries = {entry["key"]: entry["library"] for entry in json.loads(result.stdout)}
    assert len(entries) >= 166
    assert entries["good"] == "user"


def test_water_at_the_sodium_line(nacre):
    """Daimon & Masumura 2007: n = 1.3334 at 589 nm and 20 °C."""
    text = nacre.ok("library", "show", "water/Daimon-20C", "--at", "589.3")
    assert "n = 1.333" in text
    assert "Daimon" in text


def test_other_kinds(nacre, templates):
    assert "D65" in nacre.ok("library", "list", "--kind", "illuminants").splitlines()
    assert "lin_rec709_scene" in nacre.ok("library", "list", "--kind", "spaces").splitlines()
    built_in = nacre.ok("library", "list", "--kind", "templates").splitlines()
    sources = {path.stem for path in templates.glob("*.toml")}
    assert built_in == sorted(sources | set(SHADER_MATERIALS))


def test_unknown_medium_names_near_matches(nacre):
    errors = nacre.fails("library", "show", "Fe/Jonson")
    assert "Fe/Jonson" in errors
    assert "Fe/Johnson" in errors


def test_wavelength_outside_the_data_names_the_range(nacre):
    (entry,) = json.loads(nacre.ok("library", "list", "Fe/Johnson", "--json"))
    first, last = entry["range_nm"]
    for nm in (first - 1, last + 1, 0, -5):
        errors = nacre.fails("library", "show", "Fe/Johnson", "--at", str(nm))
        assert f"{first:.0f}" in errors.replace(f"{first:.1f}", f"{first:.0f}")
        assert "Fe/Johnson" in errors


def test_all_templates_and_constants_of_the_project_are_valid(nacre, templates):
    constants = (nacre.program.parents[1] / "share/nacre/data/optical_constants").rglob("*.yml")
    nacre.ok("library", "check", *templates.glob("*.toml"), *constants)


def test_templates_fit_the_schema(nacre, templates):
    schema = json.loads(nacre.ok("library", "schema"))
    validator = jsonschema.Draft202012Validator(schema)
    for path in templates.glob("*.toml"):
        validator.validate(tomllib.loads(path.read_text()))


def test_good_yaml(nacre, tmp_path):
    path = tmp_path / "glass.yml"
    path.write_text(GLASS_YAML)
    assert nacre.ok("library", "check", path) == ""
    assert json.loads(nacre.ok("library", "check", path, "--json")) == {"checked": [str(path)]}


BAD_YAML = {
    "truncated": (GLASS_YAML[: GLASS_YAML.index(" 103.5")], "coefficients"),
    "broken": ("DATA: [", ""),
    "empty": ("", "DATA"),
    "no-data": ("REFERENCES: x\n", "DATA"),
    "unknown-type": (GLASS_YAML.replace("formula 2", "formula 12"), "formula 12"),
    "not-a-number": (GLASS_YAML.replace("1.03961212", "one"), "one"),
    "range": (GLASS_YAML.replace("0.3 2.5", "2.5 0.3"), "wavelength_range"),
    "table": (
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5\n        0.5 1.6 0\n",
        "",
    ),
    "table-gain": (
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n        0.5 1.6 -1\n",
        "-1",
    ),
    "table-nan": (
        "DATA:\n  - type: tabulated n\n    data: |\n        0.4 nan\n        0.5 1.6\n",
        "",
    ),
}


@pytest.mark.parametrize("name", BAD_YAML)
def test_bad_yaml_names_file_and_what_is_wrong(nacre, tmp_path, name):
    text, word = BAD_YAML[name]
    path = tmp_path / "glass.yml"
    path.write_text(text)
    errors = nacre.fails("library", "check", path)
    assert f"nacre library check: {path}" in errors
    assert word in errors


def test_yaml_that_was_put_right_says_so(nacre, tmp_path):
    path = tmp_path / "glass.yml"
    path.write_text(
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.5 1.5 0\n        0.4 1.6 0\n"
    )
    checked = nacre("library", "check", path)
    assert checked.returncode == 0
    assert "sorted by wavelength (1 row, the first in line 5)" in checked.stderr


def template(body="", material='id = "x"\nname = "X"\ncategory = "T"\nsource = "s"'):
    return f"schema = 1\n[material]\n{material}\n{body}"


FILM = """\
[ambient]
medium = "air"
[[layer]]
n = {n}
k = {k}
thickness_nm = {thickness}
[substrate]
medium = "air"
"""


def film(n="1.33", k="0.0", thickness="400"):
    return template(FILM.format(n=n, k=k, thickness=thickness))


BAD_TEMPLATES = {
    "truncated": (film()[:100], ""),
    "syntax": ("schema = = 1", ":1:"),
    "empty": ("", "schema"),
    "negative-thickness": (film(thickness="-5"), "thickness_nm"),
    "nan-thickness": (film(thickness="nan"), "thickness_nm"),
    "infinite-thickness": (film(thickness="inf"), "thickness_nm"),
    "zero-index": (film(n="0.0"), ":10: layer[0].n: "),
    "nan-index": (film(n="nan"), ":10: layer[0].n: "),
    "gain": (film(k="-0.1"), ":11: layer[0].k: "),
    "unknown-key": (film() + 'colour = "red"\n', "colour"),
    "unknown-medium": (film().replace('"air"\n[[', '"aether"\n[['), "aether"),
    "wrong-type": (film(n='"1.33"'), ":10: layer[0].n: "),
    "65-layers": (
        template(
            FILM.format(n=1.3, k=0, thickness=1).replace(
                "[substrate]", "[[layer]]\nn = 1.4\nthickness_nm = 1\n" * 64 + "[substrate]"
            )
        ),
        "64",
    ),
}


@pytest.mark.parametrize("name", BAD_TEMPLATES)
def test_bad_template_names_file_line_and_field(nacre, tmp_path, name):
    text, word = BAD_TEMPLATES[name]
    path = tmp_path / "film.toml"
    path.write_text(text)
    errors = nacre.fails("library", "check", path)
    assert f"nacre library check: {path}" in errors
    assert word in errors


def test_all_errors_of_all_files_at_once(nacre, tmp_path):
    toml, yaml = tmp_path / "film.toml", tmp_path / "glass.yml"
    toml.write_text(film(n="-1", k="-2", thickness="-3"))
    yaml.write_text("")
    errors = nacre.fails(
        "library", "check", toml, yaml, tmp_path / "missing.toml", tmp_path / "x.txt"
    )
    assert len(errors.splitlines()) == 6


@pytest.mark.parametrize("name", ["missing.yml", "missing.toml", "missing.json"])
def test_missing_file(nacre, tmp_path, name):
    errors = nacre.fails("library", "check", tmp_path / name)
    assert f"{tmp_path / name}: " in errors
