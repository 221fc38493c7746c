# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre compile`: folders that appear whole and hold the same bytes every time."""

from __future__ import annotations

import hashlib
import json
import os
import stat
from pathlib import Path

import numpy as np
import pytest

from support.images import json_attribute, read_all, spec_of
from support.osl import SHADER_MATERIALS
from support.paths import TEMPLATES, materials_folder

MATERIALS = materials_folder()
FILM = """\
schema = 1
[material]
id = "{id}"
name = "Test Film"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
n = 1.33
thickness_nm = {thickness}
[substrate]
n = 1.5
"""
VARIES = "{ default = 200, min = 0, max = 400, varies = true }"


@pytest.fixture
def film(tmp_path) -> Path:
    path = tmp_path / "film.toml"
    path.write_text(FILM.format(id="test_film", thickness=VARIES))
    return path


def contents(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def test_technique_is_recorded_and_held_to_its_domain(nacre, film, tmp_path):
    text = film.read_text()
    for technique in ("airy", "multilayer"):
        film.write_text(f'{text}[stack]\ntechnique = "{technique}"\n')
        nacre.ok("compile", film, "--tolerance", 1, "-o", tmp_path)
        manifest = json.loads((tmp_path / "test_film" / "test_film.json").read_text())
        assert manifest["technique"] == technique
    film.write_text(f'{text}[stack]\ntechnique = "free_film"\n')
    assert nacre.fails("compile", film, "-o", tmp_path / "none").endswith(
        f'{film}:13: substrate.n: must equal that of the ambient with technique "free_film" '
        '(at 360 nm); choose "multilayer", which takes any stack\n'
    )
    assert not (tmp_path / "none" / "test_film").exists()
    film.write_text(f'{text}[stack]\ntechnique = "magic"\n')
    assert f"{film}:15: stack.technique: must be one of multilayer, path_difference" in (
        nacre.fails("compile", film, "-o", tmp_path / "none")
    )


def manifests() -> dict[str, dict]:
    """Of the library as it was built."""
    return {
        file.parent.name: json.loads(file.read_text("utf-8")) for file in MATERIALS.glob("*/*.json")
    }


def one_of_each_make() -> list[str]:
    """Materials that differ in sockets or tables, the smallest of each."""
    chosen: dict[tuple, tuple[int, str]] = {}
    for name, manifest in manifests().items():
        names = [
            tuple(sorted(part["name"] for part in manifest[of])) for of in ("sockets", "tables")
        ]
        size = sum(file.stat().st_size for file in (MATERIALS / name).iterdir())
        make = (manifest["kind"], *names)
        chosen[make] = min(chosen.get(make, (size, name)), (size, name))
    return sorted(name for _, name in chosen.values())


def test_the_library_is_whole(templates):
    sources = {source.stem for source in templates.glob("*.toml")}
    assert set(manifests()) == sources | set(SHADER_MATERIALS)


def test_tables_of_the_library_keep_to_the_tolerance():
    errors = {
        (name, table["name"], "slices" in table): table["error"]
        for name, manifest in manifests().items()
        for table in manifest["tables"]
        if table["error"]["unit"] == "dE00"
    }
    assert len(errors) > 200
    for (name, table, sliced), error in errors.items():
        assert error["mean"] <= 0.5 if sliced else error["max"] <= 0.1, (name, table)


def test_templates_compile_twice_to_the_same_bytes(nacre, templates, tmp_path, monkeypatch):
    """The build made the first of the two, from elsewhere by other paths: none may enter a file."""
    monkeypatch.delenv("NACRE_PYTHON", raising=False)  # as in the build
    names = one_of_each_make()
    sources = (SHADER_MATERIALS.get(name, templates / f"{name}.toml") for name in names)
    relative = [os.path.relpath(source, tmp_path) for source in sources]
    nacre.ok("compile", *relative, "-o", "materials", cwd=tmp_path)
    for name in names:
        assert contents(MATERIALS / name) == contents(tmp_path / "materials" / name), name


def test_manifest_and_tables_agree(nacre, film, tmp_path):
    nacre.ok("compile", film, "-o", tmp_path / "out")
    folder = tmp_path / "out" / "test_film"
    manifest = json.loads((folder / "test_film.json").read_text())
    assert manifest["id"] == "test_film"
    assert (folder / "test_film.osl").read_text().count("shader") >= 1
    assert stat.S_IMODE(folder.stat().st_mode) == 0o755
    assert [table["name"] for table in manifest["tables"]] == [
        "R",
        "R_rough",
        "R_further",
        "R_schlick",
    ]
    for table in manifest["tables"]:
        pixels, attributes = read_all(folder / table["file"])
        assert pixels.shape == (table["height"], table["width"], 3)
        slices = [table["slices"]] if "slices" in table else []
        axes = json_attribute(attributes, "axes")
        assert axes[: len(table["axes"])] == table["axes"]
        assert [axis["name"] for axis in axes[2:]] == [axis["name"] for axis in slices]
        assert json_attribute(attributes, "error") == table["error"]
        assert attributes["nacre:space"] == manifest["space"]


def test_compiled_table_is_the_baked_table(nacre, film, tmp_path):
    nacre.ok("compile", film, "--tolerance", "1", "-o", tmp_path / "out")
    nacre.ok("bake", "stack", film, "--tolerance", "1", "-o", tmp_path / "R.exr")
    compiled = tmp_path / "out" / "test_film" / "test_film_R.exr"
    texels, attributes = read_all(compiled)
    exact, baked = read_all(tmp_path / "R.exr")
    assert texels.shape == exact.shape
    rounding = 2.0**-14 * np.maximum(2.0 ** np.floor(np.log2(np.abs(exact))), 2.0**-5)
    assert (np.abs(texels - exact) <= rounding).all()
    assert attributes["compression"] == "pxr24"
    assert baked["compression"] == "zip"
    for name in ("axes", "illuminant", "observer", "quantity", "space", "stack"):
        assert attributes[f"nacre:{name}"] == baked[f"nacre:{name}"]


def test_tables_lose_nothing_to_their_compression():
    """PXR24 keeps 15 bits of a float's mantissa, and texels have fewer; half floats are kept whole."""
    smooth, attributes = read_all(MATERIALS / "soap_film" / "soap_film_R.exr")
    assert attributes["compression"] == "pxr24"
    steps = 2.0 ** (np.maximum(np.floor(np.log2(np.maximum(np.abs(smooth), 1e-9))), -5) - 13)
    assert (smooth / steps == np.rint(smooth / steps)).all()
    rough = spec_of(MATERIALS / "soap_film" / "soap_film_R_rough.exr")
    assert str(rough.format) == "half"
    assert rough.getattribute("compression") == "pxr24"


def test_tables_of_the_library_are_light():
    """Of 25 MB for the extension, and what a scene that packs one has to carry."""
    sizes = {
        name: sum(file.stat().st_size for file in (MATERIALS / name).glob("*.exr"))
        for name in manifests()
    }
    assert sum(sizes.values()) <= 21.4e6
    assert sizes["soap_film"] <= 2.1e6
    assert max(sizes.values()) <= 2.6e6, max(sizes, key=sizes.__getitem__)


def test_options_reach_the_manifest(nacre, film, tmp_path):
    options = ("--space", "lin_ap1_scene", "--illuminant", "A", "--observer", "cie1964")
    nacre.ok("compile", film, *options, "--tolerance", "1", "-o", tmp_path)
    manifest = json.loads((tmp_path / "test_film" / "test_film.json").read_text())
    assert manifest["space"] == "lin_ap1_scene"
    assert manifest["illuminant"] == "A"
    assert manifest["observer"] == "cie1964"


LIGHTS = {
    "compile": ("{film}", "--tolerance", "1", "-o", "{out}"),
    "bake stack": ("{film}", "--size", "3x3", "-o", "{out}/R.exr"),
    "bake ramp": ("{film}", "-o", "{out}/ramp.cube"),
    "bake material": ("Au/Johnson", "-o", "{out}/gold.exr"),
    "export csv": ("{film}", "-o", "{out}/ramp.csv"),
    "export table": ("{film}", "--size", "3x3", "-o", "{out}/table.exr"),
    "export materialx": ("{film}", "--tolerance", "1", "-o", "{out}/film.mtlx"),
    "export gltf": ("{film}", "-o", "{out}/film.gltf"),
    "export mitsuba": ("{film}", "-o", "{out}/film.xml"),
}


@pytest.mark.parametrize("command", LIGHTS)
def test_what_cannot_be_adapted_is_taken_as_it_is_where_asked(nacre, film, tmp_path, command):
    """Sodium has no blue to be made white of; each message names an option that the command has."""
    out = tmp_path / "out"
    out.mkdir()
    words = [word.format(film=film, out=out) for word in LIGHTS[command]]
    call = (*command.split(), *words, "--illuminant", "lamp/lps")
    errors = nacre.fails(*call)
    assert "must have a white that can be adapted" in errors
    assert "--cat none takes it as it is" in errors
    assert not list(out.iterdir())
    nacre.ok(*call, "--cat", "none")
    assert list(out.iterdir())


def test_the_manifest_says_how_colours_are_adapted(nacre, film, tmp_path):
    for how in ("bradford", "cat16", "none"):
        options = ("--tolerance", "1", "--illuminant", "A", "--cat", how)
        nacre.ok("compile", film, *options, "-o", tmp_path)
        manifest = json.loads((tmp_path / "test_film" / "test_film.json").read_text())
        assert manifest["adaptation"] == how
        _, attributes = read_all(tmp_path / "test_film" / "test_film_R.exr")
        assert attributes["nacre:adaptation"] == how


@pytest.mark.parametrize("material", ["n_bk7", "cd"])
def test_white_light_alone_is_split(nacre, tmp_path, material):
    template = TEMPLATES / f"{material}.toml"
    errors = nacre.fails("compile", template, "--cat", "none", "-o", tmp_path / "out")
    assert f"{template}: must be a film where colours are not adapted (--cat none)" in errors
    assert not (tmp_path / "out").exists()


def test_a_folder_is_replaced_whole(nacre, film, tmp_path):
    target = tmp_path / "out" / "test_film"
    nacre.ok("compile", film, "--tolerance", "1", "-o", tmp_path / "out")
    (target / "stale.exr").write_text("left over")
    nacre.ok("compile", film, "--tolerance", "1", "-o", tmp_path / "out")
    assert not (target / "stale.exr").exists()
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["test_film"]


def test_a_folder_of_the_users_own_is_not_replaced(nacre, film, tmp_path):
    own = tmp_path / "out" / "test_film"
    own.mkdir(parents=True)
    (own / "thesis.txt").write_text("years of work")
    assert "is not a compiled material" in nacre.fails("compile", film, "-o", tmp_path / "out")
    assert (own / "thesis.txt").read_text() == "years of work"


def test_one_bad_template_stops_them_all(nacre, film, tmp_path):
    bad = tmp_path / "bad.toml"
    bad.write_text(FILM.format(id="bad", thickness="-5"))
    worse = tmp_path / "worse.toml"
    worse.write_text(FILM.format(id="Worse!", thickness="400").replace("n = 1.33", "n = -1"))
    errors = nacre.fails("compile", film, bad, worse, "-o", tmp_path / "out")
    assert f"nacre compile: {bad}:11: layer[0].thickness_nm: " in errors
    assert "(got -5)" in errors
    assert f"{worse}:3: material.id" in errors
    assert f"{worse}:10: layer[0].n" in errors
    assert not (tmp_path / "out").exists()


def test_two_templates_of_one_id(nacre, film, tmp_path):
    other = tmp_path / "other.toml"
    other.write_text(film.read_text())
    errors = nacre.fails("compile", film, other, "-o", tmp_path / "out")
    assert (
        f'{other}: material.id: must differ from the other templates\' (got "test_film")' in errors
    )
    assert not (tmp_path / "out").exists()


def test_unknown_medium_names_template_and_line(nacre, film, tmp_path):
    film.write_text(film.read_text().replace("n = 1.33", 'medium = "H2O/Nobody"'))
    errors = nacre.fails("compile", film, "-o", tmp_path / "out")
    assert f"{film}:10: " in errors
    assert "H2O/Nobody" in errors


def test_summary_as_json(nacre, film, tmp_path):
    (summary,) = json.loads(nacre.ok("compile", film, "--json", "-o", tmp_path))
    assert summary["id"] == "test_film"
    assert summary["folder"] == str(tmp_path / "test_film")
    assert summary["tables"][0]["error"]["max"] <= 0.1


OSLC = """\
#!/bin/sh
# Stands for oslc: `oslc -o RESULT SOURCE`.
{body}
"""


def fake_oslc(tmp_path, body):
    program = tmp_path / "bin" / "oslc"
    program.parent.mkdir()
    program.write_text(OSLC.format(body=body))
    program.chmod(0o755)
    return {"PATH": f"{program.parent}:{os.environ['PATH']}"}


def test_oslc_on_the_path_is_used_by_bare_names(nacre, film, tmp_path):
    environment = fake_oslc(tmp_path, 'echo "compiled from $3" > "$2"')
    nacre.ok("compile", film, "--tolerance", "1", "-o", tmp_path / "out", env=environment)
    oso = tmp_path / "out" / "test_film" / "test_film.oso"
    assert oso.read_text() == "compiled from test_film.osl\n"


def test_a_refusing_oslc_stops_the_compilation(nacre, film, tmp_path):
    environment = fake_oslc(tmp_path, 'echo "error: no such closure" >&2; exit 1')
    errors = nacre.fails("compile", film, "-o", tmp_path / "out", env=environment)
    assert "test_film.osl" in errors
    assert "error: no such closure" in errors
    assert list((tmp_path / "out").iterdir()) == []


def test_cycles_compiles_where_nacre_python_has_bpy(nacre, film, tmp_path):
    python = os.environ.get("NACRE_BPY45")
    if not python:
        pytest.skip("NACRE_BPY45 does not name a Python with bpy 4.5")
    for name in ("first", "second"):
        nacre.ok(
            "compile", film, "--tolerance", "1", "-o", tmp_path / name, env={"NACRE_PYTHON": python}
        )
    oso = (tmp_path / "first" / "test_film" / "test_film.oso").read_text()
    assert oso.startswith("OpenShadingLanguage")
    assert str(tmp_path) not in oso
    assert contents(tmp_path / "first") == contents(tmp_path / "second")
