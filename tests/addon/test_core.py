# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the extension knows without Blender."""

from __future__ import annotations

import json
import os
import shutil

import numpy as np
import pytest
from nacre_extension.core.form import FormError, Renderer, choose_form
from nacre_extension.core.library import Library
from nacre_extension.core.manifest import ManifestError, load_folder
from nacre_extension.core.oso import (
    OsoError,
    bytecode_hash,
    convert_colours,
    parse_parameters,
    strip_provenance,
)
from nacre_extension.core.space import REC709, SpaceError, conversion, converted, parse
from nacre_extension.core.space import text as space_text
from nacre_extension.core.values import AssignmentError, parse_assignments
from nacre_extension.core.whole_file import is_whole
from nacre_extension.films import colour_names
from nacre_extension.films.messages import spoken
from nacre_extension.materials.problems import AssignedMaterial, SceneState, find_problems
from nacre_extension.thickness.sources import ThicknessError, read_varied, socket_values

from support.paths import FIXTURES

OSO = """OpenShadingLanguage 1.00
# Compiled by oslc 1.14.4.0dev
# options: -o /tmp/x/s.oso -I/somewhere
shader s
param\tcolor\treflectance\t1 0.5 0\t\t%read{1,1}
param\tfloat\troughness\t0.25\t\t%meta{string,label,"Roughness"} %meta{float,min,0}  %read{1,1}
param\tstring\ttable\t"a b"\t\t%read{1,1}
param\tnormal\tsurface_normal\t0 0 0\t\t%read{1,1} %initexpr
oparam\tclosure color\tBSDF\t\t\t%read{2147483647,-1} %write{1,1}
code ___main___
"""


def test_manifest_is_read(film, grating):
    assert (film.id, film.kind, film.forms) == ("test_film", "film", ("osl", "nodes"))
    thickness = film.socket("thickness_nm")
    assert (thickness.default, thickness.minimum, thickness.maximum) == (400.0, 0.0, 1200.0)
    assert [table.name for table in film.tables] == ["R", "T"]
    assert film.negative_gamut
    assert not film.wavelength_per_path
    assert grating.forms == ("osl",)
    assert grating.wavelength_per_path


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda m: m.update(schema=2), "schema: must be 1 (got 2)"),
        (lambda m: m.update(kind=3), "kind: must be text (got 3)"),
        (lambda m: m.pop("name"), "name: must be text (got None)"),
        (lambda m: m.update(sockets={}), "sockets: must be a list of objects"),
        (lambda m: m["sockets"][0].update(type="matrix"), "sockets[0].type: must be one of"),
        (lambda m: m["sockets"][0].update(default=2000), "default: must be in [0.0, 1200.0]"),
        (lambda m: m["sockets"][0].update(max="x"), "sockets[0].max: must be a number (got 'x')"),
        (lambda m: m["sockets"][1].update(name="thickness_nm"), "must be a unique identifier"),
        (lambda m: m["tables"][0].update(file="../R.exr"), "tables[0].file: '../R.exr' is missing"),
        (lambda m: m["tables"][1].update(width=0), "must be whole numbers above 0"),
        (lambda m: m.update(to_xyz_d65=[1, 2]), "to_xyz_d65: must be a matrix of 3 x 3 numbers"),
        (lambda m: m.update(space="lin_ap1_scene"), "to_xyz_d65: missing"),
        (lambda m: m.update(held_ends={}), "held_ends: must be a list of objects with a note"),
        (lambda m: m.update(held_ends=[{"medium": "X/Y"}]), "held_ends: must be a list of objects"),
        (lambda m: m.update(graphs={"osl": None}), "must have a graph for one of osl, nodes"),
        (lambda m: m["graphs"]["osl"]["links"].append(["x.0", "u.0"]), "no node 'x'"),
        (lambda m: m["graphs"]["osl"]["links"].append(["input.k", "u.0"]), "must name a socket"),
        (
            lambda m: m["graphs"]["nodes"]["nodes"][-4].update(table="Q"),
            "must be one of the tables",
        ),
    ],
)
def test_wrong_manifest_names_the_field(edited, change, message):
    with pytest.raises(ManifestError) as error:
        edited(change)
    assert message in str(error.value)


def test_notes_are_those_of_held_media(edited, film):
    assert film.notes == ()
    note = "X/Y: n and k are held beyond 400 … 700 nm, 0.04 % of the luminous weight (D65, cie1931)"
    made = edited(lambda m: m.update(held_ends=[{"medium": "X/Y", "note": note}]))
    assert made.notes == (note,)


def test_all_faults_are_named_at_once(edited):
    def change(data):
        data["sockets"][0]["default"] = -1
        data["tables"][0]["height"] = "tall"

    with pytest.raises(ManifestError) as error:
        edited(change)
    assert len(str(error.value).splitlines()) >= 2


def test_missing_table_file_is_named(tmp_path):
    folder = tmp_path / "test_film"
    shutil.copytree(FIXTURES / "test_film", folder)
    (folder / "test_film_T.exr").unlink()
    with pytest.raises(ManifestError, match=r"tables\[1\].file: 'test_film_T.exr' is missing"):
        load_folder(folder)


def test_broken_json_names_the_line(tmp_path):
    (tmp_path / "x.json").write_text('{\n"schema": 1,\n!', "utf-8")
    with pytest.raises(ManifestError, match=r"x\.json:3: not JSON"):
        load_folder(tmp_path)


def test_library_lists_what_it_can_read(tmp_path):
    shutil.copytree(FIXTURES / "test_grating", tmp_path / "test_grating")
    (tmp_path / "broken").mkdir()
    library = Library(tmp_path)
    assert list(library.entries()) == ["test_grating"]
    with pytest.raises(ManifestError, match="unknown material 'soap'; there are: test_grating"):
        library.load("soap")


SPOKEN = {
    "My: 3 Soap:21: layer[0].medium: must be a key of the library (got 'coper')":
        "Layer 1: 'coper' is not in the library. Try a name (copper), an index (1.5) or a formula "
        "(cauchy 1.45 0.0035).",
    "S:18: ambient.medium: must be a key of the library, perhaps Cu/Johnson or Au/Johnson (got 'Cu/Jonson')":
        "Above: 'Cu/Jonson' is not in the library. Try Cu/Johnson or Au/Johnson, a name (copper), "
        "an index (1.5) or a formula (cauchy 1.45 0.0035).",
    "S:25: substrate.n: must be > 0 (got -1)": "Below, index: must be > 0 (got -1)",
    "layer[11].thickness_nm.default: must be ≥ 0 (got -40)": "Layer 12, thickness: must be ≥ 0 (got -40)",
    "layer[1].medium: must be named, such as water/Daimon-20C, or given as 1.33":
        "Layer 2: must be named, such as water/Daimon-20C, or given as 1.33",
    "S:3: layer[2].coherent: must be true or false": "Layer 3, coherent: must be true or false",
    "S: a stack has at most 64 layers": "S: a stack has at most 64 layers",
    "unobtainium": "unobtainium",
}  # fmt: skip


def test_problems_are_told_in_the_words_of_the_panel():
    for problem, expected in SPOKEN.items():
        assert spoken(problem) == [expected]
    assert spoken("\n".join(SPOKEN) + "\n\n") == list(SPOKEN.values())
    assert spoken("") == []


def test_library_sees_a_manifest_of_another_content_and_the_same_time(tmp_path, monkeypatch):
    folder = shutil.copytree(FIXTURES / "test_film", tmp_path / "test_film")
    monkeypatch.setenv("NACRE_MATERIALS", str(tmp_path))
    data = json.loads((folder / "test_film.json").read_text())
    before = (folder / "test_film.json").stat()
    for name in ("Other", "Third", "Again"):  # as long as each other
        unpacked = folder / "test_film.json.new"
        unpacked.write_text(json.dumps({**data, "name": name}))
        os.utime(unpacked, ns=(before.st_atime_ns, before.st_mtime_ns))
        unpacked.rename(folder / "test_film.json")
        assert Library.default().entries()["test_film"].name == name


def test_parameters_of_a_compiled_shader():
    parameters = {p.name: p for p in parse_parameters(OSO)}
    assert list(parameters) == ["reflectance", "roughness", "table", "surface_normal", "BSDF"]
    assert parameters["reflectance"].default == (1.0, 0.5, 0.0)
    assert parameters["roughness"].default == (0.25,)
    assert parameters["roughness"].label == "Roughness"
    assert parameters["table"].default == "a b"
    assert parameters["surface_normal"].default is None  # N, known only while shading
    assert parameters["BSDF"].is_output
    assert parameters["BSDF"].type == "closure color"


# ITU-R BT.2020-2 primaries and SMPTE ST 2065-4 with its white adapted to D65, by colour-science.
REC2020 = ((0.63695805, 0.14461690, 0.16888098), (0.26270021, 0.67799807, 0.05930172),
           (0.0, 0.02807269, 1.06098506))  # fmt: skip


def test_colours_of_one_space_in_another():
    matrix = conversion(REC709, REC2020)
    # ITU-R BT.2087-0, annex 2.
    expected = [[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]]
    assert np.abs(np.array(matrix) - expected).max() < 1e-4
    assert converted(matrix, (1.0, 1.0, 1.0)) == pytest.approx((1.0, 1.0, 1.0), abs=1e-6)
    assert conversion(parse(space_text(REC709)), REC709) is None
    # Blender's own matrices have five digits.
    assert conversion(tuple(tuple(round(x, 5) for x in row) for row in REC709), REC709) is None
    assert converted(None, (0.1, 0.2, 0.3)) == (0.1, 0.2, 0.3)


@pytest.mark.parametrize(
    "values",
    [None, "", "1 0 0", [1.0] * 8, [1.0] * 9, ["x"] * 9, [float("nan")] * 9, [[1, 0, 0]] * 3],
)
def test_what_is_no_space_is_refused(values):
    with pytest.raises(SpaceError):
        parse(values)


def test_colours_of_a_compiled_shader_are_converted():
    arrays = OSO.replace("oparam", "param\tcolor[2]\tweights\t1 0 0 0 1 0\t\t%read{1,1}\noparam", 1)
    swap = ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    made = convert_colours(arrays, swap)
    parameters = {p.name: p for p in parse_parameters(made)}
    assert parameters["reflectance"].default == (0.5, 1.0, 0.0)
    assert parameters["weights"].default == (0.0, 1.0, 0.0, 1.0, 0.0, 0.0)
    # Nothing else is touched, and twice is back.
    assert convert_colours(made, swap) == arrays
    assert convert_colours(arrays, None) == arrays


def test_what_is_multiplied_by_colours_gives_the_same_in_every_space():
    line = "param\tcolor[2]\ttint_basis\t0.9 0.1 0 0 0.25 0.75\t\t%read{1,1}\noparam"
    matrix = conversion(REC709, REC2020)
    made = convert_colours(OSO.replace("oparam", line, 1), matrix)
    basis = {p.name: p for p in parse_parameters(made)}["tint_basis"].default
    tint = (0.9, 0.5, 0.3)
    for cell, expected in (
        (basis[:3], 0.9 * 0.9 + 0.1 * 0.5),
        (basis[3:], 0.25 * 0.5 + 0.75 * 0.3),
    ):
        assert np.dot(converted(matrix, tint), cell) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("written", "read"),
    [
        (r"\"", '"'),
        (r"a \"b\" \\", 'a "b" \\'),
        (r"50% %initexpr %meta{string,label,\"x\"}", '50% %initexpr %meta{string,label,"x"}'),
        (r"a\nb\tc\\n", "a\nb\tc\\n"),
        ("薄膜, {x}", "薄膜, {x}"),
        ("", ""),
    ],
)
def test_strings_of_a_shader_are_read_back(written, read):
    text = (
        f'OpenShadingLanguage 1.00\nshader s\nparam\tstring\ttable\t"{written}"\t\t%read{{1,1}}\n'
        f'param\tfloat\tx\t0.25\t\t%meta{{string,help,"{written}"}} %meta{{string,label,"{written}"}} '
        "%meta{float,min,0}  %read{1,1}\ncode ___main___\n"
    )
    table, x = parse_parameters(text)
    assert (table.default, table.label) == (read, "table")
    assert (x.default, x.label) == ((0.25,), read)


def test_text_that_is_no_shader_is_refused():
    with pytest.raises(OsoError, match="must start with"):
        parse_parameters("shader s")


def test_provenance_does_not_change_the_program():
    stripped = strip_provenance(OSO)
    assert "/tmp" not in stripped
    assert "oslc" not in stripped
    assert parse_parameters(stripped) == parse_parameters(OSO)
    assert bytecode_hash("abc") == "900150983cd24fb0d6963f7d28e17f72"  # RFC 1321, A.5


@pytest.mark.parametrize(
    "folder", ['/tmp/a"b', "/tmp/a\nshader b", "/tmp/%filename{a}", "/tmp/a\tb"]
)
def test_provenance_goes_whatever_the_folder_is_called(folder):
    """The compiler writes names as they are: here a line that ends, or a quote, would end what it is in."""
    program = OSO + '\tmul\t\tc x x \t%filename{"FOLDER/s.osl"} %line{1} %argrw{"wrr"}\n'
    written = program.replace(
        "code ___main___\n", "code ___main___\n# FOLDER/s.osl:1\n# c = x * x;\n"
    )
    written = written.replace("/tmp/x", "FOLDER").replace("FOLDER", folder)
    stripped = strip_provenance(written, folder)
    assert stripped == strip_provenance(program.replace("FOLDER", "/tmp/x"), "/tmp/x")
    assert stripped.endswith('code ___main___\n\tmul\t\tc x x \t %line{1} %argrw{"wrr"}\n')


@pytest.mark.parametrize(
    ("renderer", "form"),
    [
        (Renderer(has_osl=True), "osl"),
        (Renderer(has_osl=False), "nodes"),
        (Renderer(has_osl=True, engine="BLENDER_EEVEE"), "nodes"),
        (Renderer(has_osl=True, device="GPU", backend="OPTIX"), "osl"),
        (Renderer(has_osl=True, device="GPU", backend="HIP"), "nodes"),
    ],
)
def test_automatic_form(film, renderer, form):
    assert choose_form(film, "auto", renderer) == form


def test_grating_keeps_osl_and_says_when_there_is_none(grating):
    assert choose_form(grating, "auto", Renderer(has_osl=True, engine="BLENDER_EEVEE")) == "osl"
    with pytest.raises(FormError, match="OSL needed: Test Grating"):
        choose_form(grating, "auto", Renderer(has_osl=False))
    with pytest.raises(FormError, match="has no form as nodes"):
        choose_form(grating, "nodes", Renderer(has_osl=True))


def test_values_are_parsed_by_the_socket_type(grating):
    values = parse_assignments(grating, ["pitch_nm=740", "tint=1,0.5,0", "bands=4"])
    assert values == {"pitch_nm": 740.0, "tint": (1.0, 0.5, 0.0, 1.0), "bands": 4}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("pitch_nm", "must be name=value"),
        ("depth=3", "has no value 'depth'; there are: pitch_nm, tint, bands"),
        ("normal=1", "has no value 'normal'"),
        ("pitch_nm=99", r"pitch_nm: must be in \[300, 3200\] nm \(got 99\)"),
        ("pitch_nm=nan", "must be finite"),
        ("pitch_nm=wide", "must be a number"),
        ("bands=2.5", "must be a whole number"),
        ("tint=1,2", "must be R,G,B"),
        ("tint=1,-1,0", "must be R,G,B, each ≥ 0"),
    ],
)
def test_wrong_values_are_refused(grating, text, message):
    with pytest.raises(AssignmentError, match=message):
        parse_assignments(grating, [text])


SOUND = SceneState("CYCLES", True, True, False, True, True)


@pytest.mark.parametrize(
    ("change", "operators"),
    [
        ({}, []),
        ({"engine": "BLENDER_EEVEE"}, ["nacre.use_cycles"]),
        ({"osl_on": False}, ["nacre.use_osl"]),
        ({"gpu_without_osl": True}, ["nacre.use_cpu"]),
        ({"motion_blur": False}, ["nacre.use_wavelengths"]),
        ({"flat_shutter": False}, ["nacre.use_wavelengths"]),
        ({"missing_tables": ("R",)}, ["nacre.rebuild_material"]),
        ({"has_osl": False, "osl_on": False}, [None]),
    ],
)
def test_problems_come_with_their_mends(change, operators):
    state = SceneState(**{**SOUND.__dict__, **change})
    problems = find_problems(AssignedMaterial("osl", wavelength_per_path=True), state)
    assert [problem.operator for problem in problems] == operators


def test_what_must_not_be_changed_is_said_first():
    state = SceneState("CYCLES", True, True, False, True, True, missing_tables=("R",))
    found = find_problems(AssignedMaterial("nodes", False, refusal="from the future"), state)
    assert (found[0].text, found[0].operator) == ("from the future", None)


def test_nodes_need_neither_osl_nor_wavelengths():
    state = SceneState("BLENDER_EEVEE", False, False, False, False, False)
    assert find_problems(AssignedMaterial("nodes", wavelength_per_path=False), state) == []


SPAN = (0.0, 1200.0)


def test_values_of_a_source_are_read():
    drop = read_varied("drop:base_nm=100,height_nm=3e2,centre=0.25:0.75,radius=0.4")
    assert socket_values(drop, "thickness_nm", SPAN) == {
        "Base": 100.0, "Height": 300.0, "Centre": (0.25, 0.75, 0.0), "Radius": 0.4,
    }  # fmt: skip
    assert socket_values(read_varied("drop"), "thickness_nm", SPAN) == {}
    scaled = read_varied("drainage:bottom_scale=1.5,time=4,black_film=0.1")
    assert socket_values(scaled, "thickness_scale", (0.5, 2.0)) == {
        "Bottom": 1.5, "Time": 4.0, "Black Film": 0.1,
    }  # fmt: skip
    assert socket_values(read_varied("swirl:time_s=-2"), "thickness_nm", SPAN) == {"Time": -2.0}


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        (
            "rain",
            [
                "no source 'rain'; there are: noise, gradient, height, edge, temperature, drop, drainage"
            ],
        ),
        (
            "map:value=1",
            [
                "no source 'map'; there are: noise, gradient, height, edge, temperature, drop, drainage"
            ],
        ),
        (
            "drop:",
            ["drop: must be NAME=VALUE (got ''); there are: base_nm, height_nm, centre, radius"],
        ),
        ("drop:base=1", ["drop: no value 'base'; there are: base_nm, height_nm, centre, radius"]),
        ("swirl:thickness_nm=1", ["swirl: no value 'thickness_nm'; there are: amount, scale"]),
        (
            "drop:base_nm=-1,height_nm=1201,radius=0,centre=1",
            [
                "drop: base_nm: must be in [0, 1200] (got -1)",
                "drop: height_nm: must be in [0, 1200] (got 1201)",
                "drop: radius: must be in [0.0001, 1e+06] (got 0)",
                "drop: centre: must be X:Y or X:Y:Z (got 1)",
            ],
        ),
        ("drop:radius=nan", ["drop: radius: must be a number (got nan)"]),
        ("drop:radius=1:2", ["drop: radius: must be a number (got 1:2)"]),
        (
            "drop:base_nm=1000,height_nm=300",
            ["base_nm + height_nm: must be ≤ 1200, which the tables cover (got 1000 + 300)"],
        ),
        ("drop:base_nm=1000", ["base_nm + height_nm: must be ≤ 1200"]),
    ],
)
def test_wrong_values_of_a_source_are_refused(text, messages):
    with pytest.raises(ThicknessError) as refused:
        socket_values(read_varied(text), "thickness_nm", SPAN)
    for message in messages:
        assert message in str(refused.value)


def test_cut_off_picture_is_not_whole(tmp_path):
    whole = FIXTURES / "test_film" / "test_film_R.exr"
    assert is_whole(whole)
    data = whole.read_bytes()
    cut = tmp_path / "cut.exr"
    for length in (0, 4, 40, len(data) // 2, len(data) - 1):
        cut.write_bytes(data[:length])
        assert not is_whole(cut)


@pytest.mark.parametrize(
    ("linear", "wanted"),
    [
        # The computed colours of magnetite on iron that have these names in the workshop.
        ((0.4595, 0.4269, 0.3608), "silver"),
        ((0.3508, 0.2881, 0.1576), "straw"),
        ((0.2111, 0.1173, 0.0072), "brown"),
        ((0.0949, 0.015, 0.0463), "purple"),
        ((-0.0056, 0.0127, 0.2326), "blue"),
        ((0.0584, 0.2223, 0.4788), "light blue"),
        ((0.0, 0.0, 0.0), "black"),
        ((0.8, 0.8, 0.8), "silver"),
        ((0.1, 0.1, 0.1), "grey"),
        ((0.9, 0.6, 0.05), "gold"),
        ((0.02, 0.4, 0.05), "green"),
    ],
)
def test_names_of_colours(linear, wanted):
    assert colour_names.name(linear) == wanted


def test_colours_along_a_range_name_each_once_in_its_middle():
    grey, red, blue = (0.2, 0.2, 0.2), (0.5, 0.02, 0.02), (0.02, 0.05, 0.6)
    colours = [grey] * 30 + [red] * 10 + [blue] * 20
    values = [float(index) for index in range(60)]
    assert colour_names.along(values, colours) == "red at 35, blue at 50"
    assert colour_names.along(values, [grey] * 60) == "grey at 30"
    # A clear film is named as an eye sees it that has grown used to it.
    dim = [[0.05 * channel for channel in colour] for colour in colours]
    assert colour_names.along(values, dim) == "salmon at 35, blue at 50"
