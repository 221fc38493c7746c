# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre export`: contract, values, and tables for other programs. Those read them in test_consumers."""

from __future__ import annotations

import json
import tomllib

import numpy as np
import pytest

from support.colours import delta_e
from support.exact import exact_colours
from support.gltf import export_gltf, read_gltf
from support.images import json_attribute, read_all, spec_of

FORMATS = {
    "gltf": ("x.glb", "x.gltf"),
    "materialx": ("x.mtlx",),
    "mitsuba": ("x.xml",),
    "table": ("x.exr",),
    "cube": ("x.cube",),
    "csv": ("x.csv",),
}
EVERY_FORMAT = [(name, outputs[0]) for name, outputs in FORMATS.items()]


@pytest.fixture
def film(film_json, tmp_path):
    """A clear film on glass that is not lit through: 0 … 400 nm, 200 by default."""
    record = json.loads(film_json.read_text())
    record["substrate"] = {"n": 2.5, "k": 1.0}
    path = tmp_path / "coated.json"
    path.write_text(json.dumps(record))
    return path


def write_glass(folder):
    path = folder / "glass.toml"
    path.write_text(
        'schema = 1\n[material]\nid = "crown"\nname = "Crown"\ncategory = "Glass/Test"\n'
        'source = "test"\n[glass]\nabbe = { n_d = 1.5168, v_d = 64.17 }\n'
    )
    return path


# ---- Contract ---------------------------------------------------------------------------------------


def test_help_lists_the_formats(nacre):
    text = nacre.ok("export", "--help")
    for name in FORMATS:
        assert f"  {name} " in text
        assert "-o " in nacre.ok("export", name, "--help")


@pytest.mark.parametrize(("name", "output"), EVERY_FORMAT)
def test_every_problem_at_once_and_nothing_written(nacre, film, tmp_path, name, output):
    folder = tmp_path / "out"
    folder.mkdir()
    bad = tmp_path / "bad.toml"
    bad.write_text("schema = 1\n")
    error = nacre.fails("export", name, bad, "--material", "nosuch", "-o", folder / output)
    assert f"nacre export {name}: {bad}" in error
    assert "--material: must be a material of the library" in error
    assert "got nosuch" in error
    assert not list(folder.iterdir())


@pytest.mark.parametrize(("name", "output"), EVERY_FORMAT)
def test_gratings_are_refused_with_words(nacre, tmp_path, name, output):
    folder = tmp_path / "out"
    folder.mkdir()
    error = nacre.fails("export", name, "--material", "cd", "-o", folder / output)
    assert "cd.toml: grating: has no counterpart in" in error
    assert not list(folder.iterdir())


@pytest.mark.parametrize(("name", "output"), EVERY_FORMAT)
def test_wrong_outputs(nacre, film, tmp_path, name, output):
    assert "must end in" in nacre.fails("export", name, film, "-o", tmp_path / "x.doc")
    missing = tmp_path / "missing" / output
    assert "missing" in nacre.fails("export", name, film, "-o", missing)
    assert "must be given" in nacre.fails("export", name, "-o", tmp_path / output)


@pytest.mark.parametrize("name", ["gltf", "materialx", "mitsuba"])
def test_values_are_checked_together(nacre, film, tmp_path, name):
    output = tmp_path / FORMATS[name][0]
    wrong = ("thickness_nm=500", "thickness_nm=thin", "coverage=1", "roughness", "roughness=2")
    options = [word for text in wrong for word in ("--set", text)]
    error = nacre.fails("export", name, film, *options, "-o", output)
    assert "--set thickness_nm=500: must be in [0, 400] nm for stack" in error
    assert "--set thickness_nm=thin: must be a number" in error
    assert (
        "--set coverage=1: stack has no value coverage; there are: thickness_nm, roughness" in error
    )
    assert "--set roughness: must be NAME=VALUE" in error
    assert "--set roughness=2: must be in [0, 1] for stack" in error
    assert not output.exists()


@pytest.mark.parametrize("name", ["table", "cube", "csv"])
def test_one_material_a_file(nacre, film, tmp_path, name):
    output = tmp_path / FORMATS[name][0]
    error = nacre.fails("export", name, film, "--material", "soap_film", "-o", output)
    assert "must be the only material" in error


def test_ids_must_differ(nacre, film, tmp_path):
    again = tmp_path / "again.json"
    again.write_bytes(film.read_bytes())
    error = nacre.fails("export", "gltf", film, again, "-o", tmp_path / "x.glb")
    assert f'{again}: material.id: must differ from the other materials\' (got "stack")' in error


@pytest.mark.parametrize(("name", "output"), EVERY_FORMAT)
def test_equal_input_gives_equal_bytes(nacre, film, tmp_path, name, output):
    bytes_of = []
    for run in ("a", "b"):
        folder = tmp_path / run
        folder.mkdir()
        nacre.ok("export", name, film, "-o", folder / output)
        bytes_of.append({file.name: file.read_bytes() for file in folder.iterdir()})
    assert bytes_of[0] == bytes_of[1]
    assert output in bytes_of[0]


def test_json_and_words_say_the_same(nacre, film, tmp_path):
    arguments = ("export", "gltf", film, "-o", tmp_path / "x.gltf")
    (record,) = json.loads(nacre.ok("--json", *arguments))
    error = record["error"]["reflectance"]
    words = nacre.ok(*arguments)
    assert words == f"stack: ΔE00 mean {error['mean']:.2f}, max {error['max']:.2f} in reflection\n"
    assert nacre.ok("--quiet", *arguments) == ""


# ---- glTF -------------------------------------------------------------------------------------------


def khr_iridescence(film_ior, film_nm, base_f0, factor, cosine):
    """The implementation notes of KHR_materials_iridescence, read again in Python."""
    base_f0 = np.asarray(base_f0)

    def schlick(f0, cosine):
        return f0 + (1 - f0) * (1 - cosine) ** 5

    cos_2 = np.sqrt(1 - (1 - cosine**2) / film_ior**2)
    top = schlick(((film_ior - 1) / (film_ior + 1)) ** 2, cosine)
    root = np.sqrt(base_f0 + 1e-4)
    base = (1 + root) / (1 - root)
    bottom = schlick(((base - film_ior) / (base + film_ior)) ** 2, cos_2)
    phase = np.pi + np.where(base < film_ior, np.pi, 0)
    both = np.clip(top * bottom, 1e-5, 0.9999)
    returned = (1 - top) ** 2 * bottom / (1 - both)
    result, term = top + returned, returned - (1 - top)
    val = np.array([5.4856e-13, 4.4201e-13, 5.2481e-13])
    pos = np.array([1.6810e06, 1.7953e06, 2.2084e06])
    var = np.array([4.3278e09, 9.3046e09, 6.6121e09])
    to_rgb = np.array(
        [
            [3.2404542, -1.5371385, -0.4985314],
            [-0.9692660, 1.8760108, 0.0415560],
            [0.0556434, -0.2040259, 1.0572252],
        ]
    )
    for m in (1, 2):
        term = term * np.sqrt(both)
        k = 2 * np.pi * m * 2 * film_ior * film_nm * cos_2 * 1e-9
        xyz = val * np.sqrt(2 * np.pi * var) * np.cos(pos * k + m * phase) * np.exp(-(k**2) * var)
        xyz[0] += (
            9.7470e-14
            * np.sqrt(2 * np.pi * 4.5282e09)
            * np.cos(2.2399e06 * k + m * phase[0])
            * np.exp(-4.5282e09 * k**2)
        )
        result = result + term * 2 * (to_rgb @ (xyz / 1.0685e-7))
    return (1 - factor) * schlick(base_f0, cosine) + factor * np.maximum(result, 0)


def test_stated_error_is_that_of_the_extension(nacre, film, tmp_path):
    """Read back from the file, evaluated anew, against exact colours."""
    (material,) = export_gltf(nacre, tmp_path, film, "--set", "thickness_nm=330")
    khr = material["extensions"]["KHR_materials_iridescence"]
    surface = material["pbrMetallicRoughness"]
    assert surface["metallicFactor"] == 1
    stack = [[1, 0], [1.33, 0], [2.5, 1.0]]
    degrees = np.arange(86)
    model = [
        khr_iridescence(
            khr["iridescenceIor"],
            khr["iridescenceThicknessMaximum"],
            surface["baseColorFactor"][:3],
            khr["iridescenceFactor"],
            np.cos(np.radians(angle)),
        )
        for angle in degrees
    ]
    errors = delta_e(model, exact_colours(nacre, stack, [330], degrees.tolist()))
    ring = np.sin(np.radians(degrees + 0.5)) ** 2
    shares = np.diff(ring, prepend=0)
    stated = material["extras"]["nacre"]["error"]["reflectance"]
    assert stated["mean"] == pytest.approx(np.average(errors, weights=shares), abs=2e-3)
    assert stated["max"] == pytest.approx(errors.max(), abs=2e-3)


def test_fit_beats_the_layers_own_numbers(nacre, film, tmp_path):
    (material,) = export_gltf(nacre, tmp_path, film)
    stack = [[1, 0], [1.33, 0], [2.5, 1.0]]
    f0 = abs((2.5 + 1j - 1) / (2.5 + 1j + 1)) ** 2
    angles = [0, 30, 45, 60]
    own = [khr_iridescence(1.33, 200, [f0] * 3, 1, np.cos(np.radians(angle))) for angle in angles]
    errors = delta_e(own, exact_colours(nacre, stack, [200], angles))
    assert material["extras"]["nacre"]["error"]["reflectance"]["mean"] < errors.mean()


@pytest.mark.parametrize("output", FORMATS["gltf"])
def test_document_is_whole(nacre, film, tmp_path, output):
    nacre.ok("export", "gltf", film, "--material", "n_bk7", "--range", "-o", tmp_path / output)
    document, buffer = read_gltf(tmp_path / output)
    assert document["asset"]["version"] == "2.0"
    assert document["buffers"][0]["byteLength"] == len(buffer)
    for view in document["bufferViews"]:
        assert view["byteOffset"] % 4 == 0
        assert view["byteOffset"] + view["byteLength"] <= len(buffer)
    position, uv, index = document["accessors"]

    def values(accessor, kind, width):
        view = document["bufferViews"][accessor["bufferView"]]
        part = buffer[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
        return np.frombuffer(part, kind).reshape(accessor["count"], width)

    points = values(position, "<f4", 3)
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1, atol=1e-6)
    np.testing.assert_allclose(points.min(axis=0), position["min"], atol=1e-6)
    assert values(uv, "<f4", 2).min() == 0
    corners = points[values(index, "<u2", 1).reshape(-1, 3)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", normals, corners.mean(axis=1)) > 0).all()  # all face outwards
    used = {name for material in document["materials"] for name in material["extensions"]}
    assert set(document["extensionsUsed"]) == used
    assert [node["name"] for node in document["nodes"]] == ["stack", "n_bk7"]


def test_range_maps_the_thickness(nacre, film, tmp_path):
    nacre.ok("export", "gltf", film, "--range", "-o", tmp_path / "x.glb")
    document, buffer = read_gltf(tmp_path / "x.glb")
    (material,) = document["materials"]
    khr = material["extensions"]["KHR_materials_iridescence"]
    assert khr["iridescenceThicknessTexture"] == {"index": 0}
    assert khr["iridescenceThicknessMinimum"] < khr["iridescenceThicknessMaximum"]
    assert material["extras"]["nacre"]["thickness_nm"] == [0, 400]
    view = document["bufferViews"][document["images"][0]["bufferView"]]
    png = tmp_path / "ramp.png"
    png.write_bytes(buffer[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])
    pixels, _ = read_all(png)
    np.testing.assert_allclose(pixels[:, 0, 1], np.linspace(0, 1, 256), atol=1e-6)


def test_glass_has_its_dispersion(nacre, tmp_path):
    (material,) = export_gltf(nacre, tmp_path, write_glass(tmp_path))
    extensions = material["extensions"]
    assert extensions["KHR_materials_ior"]["ior"] == pytest.approx(1.5168, abs=2e-6)
    assert extensions["KHR_materials_dispersion"]["dispersion"] == pytest.approx(
        20 / 64.17, abs=1e-4
    )
    assert extensions["KHR_materials_transmission"] == {"transmissionFactor": 1}
    assert "KHR_materials_volume" in extensions
    assert "KHR_materials_iridescence" not in extensions


def test_what_passes_gets_transmission(nacre, templates, tmp_path):
    soap, topaz, petrol, steel = export_gltf(
        nacre,
        tmp_path,
        *(
            word
            for name in ("soap_film", "mystic_topaz", "petrol_on_asphalt", "tempered_steel")
            for word in ("--material", name)
        ),
    )
    for material in (soap, topaz):
        assert material["extensions"]["KHR_materials_transmission"] == {"transmissionFactor": 1}
        assert material["pbrMetallicRoughness"]["metallicFactor"] == 0
        assert "transmittance" in material["extras"]["nacre"]["error"]
    assert "KHR_materials_volume" not in soap["extensions"]
    assert topaz["extensions"]["KHR_materials_ior"]["ior"] == pytest.approx(1.62, abs=1e-3)
    assert steel["pbrMetallicRoughness"]["metallicFactor"] == 1
    assert steel["pbrMetallicRoughness"]["roughnessFactor"] == 0.15
    assert "KHR_materials_transmission" not in steel["extensions"]
    assert soap["extras"]["nacre"]["left_out"] == ["coverage"]
    base = tomllib.loads((templates / "petrol_on_asphalt.toml").read_text())["surface"]
    assert petrol["pbrMetallicRoughness"]["baseColorFactor"] == [*base["diffuse_base"], 1]


# ---- Tables and ramps -------------------------------------------------------------------------------


def test_table_is_that_of_bake_stack(nacre, film, tmp_path):
    options = ("--size", "24x12", "--illuminant", "D50", "--space", "lin_ap1_scene")
    nacre.ok("bake", "stack", film, *options, "-o", tmp_path / "a.exr")
    nacre.ok("export", "table", film, *options, "--csv", "-o", tmp_path / "b.exr")
    assert (tmp_path / "a.exr").read_bytes() == (tmp_path / "b.exr").read_bytes()
    record = json.loads((tmp_path / "b.json").read_text())
    assert record["file"] == "b.exr"
    assert record["illuminant"] == "D50"
    assert record["space"] == "lin_ap1_scene"
    pixels, attributes = read_all(tmp_path / "b.exr")
    assert record["error"] == json_attribute(attributes, "error")
    assert record["stack"] == json_attribute(attributes, "stack")
    axes = {axis["name"]: axis for axis in record["axes"]}
    assert axes["cos_theta"]["texels"] == 24
    assert (axes["thickness_nm"]["min"], axes["thickness_nm"]["max"]) == (0, 400)
    rows = np.loadtxt(tmp_path / "b.csv", delimiter=",", skiprows=2)
    assert (tmp_path / "b.csv").read_text().splitlines()[1] == "cos_theta,thickness_nm,R,G,B"
    np.testing.assert_allclose(rows[:, 2:].reshape(12, 24, 3), pixels, rtol=1e-6)
    assert rows[-1, :2].tolist() == [1, 400]


def test_table_for_engines(nacre, tmp_path):
    nacre.ok("export", "table", "--material", "soap_film", "--size", "16x8", "--depth", "half",
             "--alpha", "--quantity", "transmittance", "-o", tmp_path / "t.exr")  # fmt: skip
    pixels, _ = read_all(tmp_path / "t.exr")
    assert pixels.shape == (8, 16, 4)
    assert (pixels[..., 3] == 1).all()
    assert spec_of(tmp_path / "t.exr").format == "half"
    record = json.loads((tmp_path / "t.json").read_text())
    assert record["channels"] == ["R", "G", "B", "A"]
    assert record["depth"] == "half"
    assert record["quantity"] == "transmittance"
    (water,) = (entry for entry in record["citations"] if entry["medium"].startswith("water"))
    assert "Daimon" in water["references"]


def test_table_refuses_a_glass(nacre, tmp_path):
    error = nacre.fails("export", "table", "--material", "sf11", "-o", tmp_path / "t.exr")
    assert "glass: has no table; export it as gltf, materialx or mitsuba" in error


@pytest.mark.parametrize("extension", ["cube", "csv"])
def test_ramps_are_those_of_bake_ramp(nacre, film, tmp_path, extension):
    options = ("--angle", "30", "--size", "9", "--observer", "cie1964")
    nacre.ok("bake", "ramp", film, *options, "-o", tmp_path / f"a.{extension}")
    nacre.ok("export", extension, film, *options, "-o", tmp_path / f"b.{extension}")
    assert (tmp_path / f"a.{extension}").read_bytes() == (tmp_path / f"b.{extension}").read_bytes()
