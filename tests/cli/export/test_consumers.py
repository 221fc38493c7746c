# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What `nacre export` writes, read by the programs that it is for.

MaterialX and Mitsuba each run in a process of their own: they carry libraries that clash.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from support.colours import delta_e
from support.exact import exact_colours
from support.gltf import export_gltf
from support.images import json_attribute, read_all

CONSUMERS = Path(__file__).parent / "consumers"


def consume(script, *arguments):
    result = subprocess.run(
        [sys.executable, CONSUMERS / script, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def answer(text):
    return json.loads(text.partition("JSON")[2])


# ---- glTF in Blender --------------------------------------------------------------------------------


def test_blender_imports_gltf(nacre, tmp_path, blender):
    path = tmp_path / "looks.glb"
    names = ("soap_film", "tempered_steel", "sf11")
    nacre.ok("export", "gltf", *(w for n in names for w in ("--material", n)), "-o", path)
    found = blender.call("gltf.read", file=str(path))
    written = {
        m["name"]: m
        for m in export_gltf(nacre, tmp_path, *(w for n in names for w in ("--material", n)))
    }
    assert set(found["materials"]) == set(names) == set(found["meshes"])
    for name, material in found["materials"].items():
        surface = written[name]["pbrMetallicRoughness"]
        assert material["base_color"] == pytest.approx(surface["baseColorFactor"], abs=1e-5)
        assert material["metallic"] == surface["metallicFactor"]
        assert material["roughness"] == pytest.approx(surface["roughnessFactor"], abs=1e-6)
        assert material["extras"] == written[name]["extras"]["nacre"]
        assert found["meshes"][name]["size"] == pytest.approx([2, 2, 2], abs=0.02)
    assert found["materials"]["sf11"]["ior"] == pytest.approx(1.7847, abs=1e-3)
    assert found["materials"]["sf11"]["transmission"] == 1


# ---- MaterialX --------------------------------------------------------------------------------------

MATERIALX = ("soap_film", "tempered_steel", "jewel_beetle", "mystic_topaz", "petrol_on_asphalt",
             "anodised_titanium", "n_bk7")  # fmt: skip


@pytest.fixture(scope="module")
def looks(nacre, tmp_path_factory):
    """A document with materials of every kind, and what was said about it."""
    path = tmp_path_factory.mktemp("materialx") / "looks.mtlx"
    names = (word for name in MATERIALX for word in ("--material", name))
    summary = nacre.ok("--json", "export", "materialx", *names, "--tolerance", "1", "-o", path)
    return path, json.loads(summary)


def test_materialx_validates_and_becomes_shaders(looks):
    found = answer(consume("read_materialx.py", looks[0]))
    assert found["valid"], found["message"]
    forms = [form["material"] for record in looks[1] for form in record["forms"]]
    assert sorted(found["materials"]) == sorted(forms)
    for name, shaders in found["materials"].items():
        for target, source in shaders.items():
            assert source, (name, target)
        if not name.endswith("_thin_film") and name != "n_bk7":
            assert f"{name}_R.exr" in shaders["osl"]
            assert "generalized_schlick_bsdf" in shaders["osl"]
    assert "thinfilm_thickness" in found["materials"]["anodised_titanium_thin_film"]["osl"]
    assert {"soap_film_thin_film", "petrol_on_asphalt_thin_film"} <= set(forms)
    assert "tempered_steel_thin_film" not in forms  # its oxide absorbs
    assert "jewel_beetle_thin_film" not in forms


def test_materialx_reads_the_texel_that_belongs_to_an_angle(looks):
    """The graph, worked out here, finds the centre of each texel of the table."""
    root = ElementTree.parse(looks[0]).getroot()
    graph = root.find("nodegraph[@name='NG_soap_film']")
    nodes = {node.get("name"): node for node in graph if node.tag != "input"}
    steps = {
        "multiply": lambda a, b: a * b,
        "add": lambda a, b: a + b,
        "subtract": lambda a, b: a - b,
        "divide": lambda a, b: a / b,
        "dotproduct": lambda a, b: a @ b,
        "combine2": lambda a, b: (a, b),
        "absval": abs,
        "clamp": lambda a: min(max(a, 0.0), 1.0),
    }

    def evaluate(name, thickness, normal, view):
        node = nodes[name]
        if node.tag in ("normal", "viewdirection"):
            return normal if node.tag == "normal" else view
        inputs = []
        for item in node.findall("input"):
            if item.get("interfacename"):
                assert item.get("interfacename") == "thickness_nm"
                inputs.append(thickness)
            elif item.get("nodename"):
                inputs.append(evaluate(item.get("nodename"), thickness, normal, view))
            else:
                inputs.append(float(item.get("value")))
        return steps[node.tag](*inputs)

    pixels, attributes = read_all(looks[0].parent / "soap_film_R.exr")
    height, width, _ = pixels.shape
    cosine, thickness = json_attribute(attributes, "axes")
    up = np.array([0.0, 0.0, 1.0])
    for column in (0, 1, width // 2, width - 1):
        for row in (0, 1, height // 3, height - 1):
            across = cosine["min"] + (cosine["max"] - cosine["min"]) * column / (width - 1)
            down = thickness["min"] + (thickness["max"] - thickness["min"]) * row / (height - 1)
            view = np.array([np.sqrt(1 - across**2), 0, -across])  # behind the surface
            u, v = evaluate("texel", down, up, view)
            assert u * width == pytest.approx(column + 0.5, abs=1e-6)
            assert (1 - v) * height == pytest.approx(row + 0.5, abs=1e-6)
    image = nodes["reflectance"]
    values = {item.get("name"): item for item in image.findall("input")}
    assert values["file"].get("value") == "soap_film_R.exr"
    assert values["file"].get("colorspace") == "lin_rec709"
    assert values["uaddressmode"].get("value") == values["vaddressmode"].get("value") == "clamp"


def test_materialx_states_its_errors(looks):
    text = looks[0].read_text(encoding="utf-8")
    for record in looks[1]:
        for form in record["forms"]:
            name, error = form["material"], form["error"]
            doc = re.search(rf'<surfacematerial name="{name}" type="material" doc="([^"]*)"', text)[
                1
            ]
            stated = [float(n) for n in re.search(r"mean ([\d.]+), max ([\d.]+)", doc).groups()]
            assert stated == pytest.approx([error["mean"], error["max"]], rel=0.05, abs=0.006)
            if form["form"] == "table":
                assert error["max"] <= 1  # the tolerance
            assert 0 <= error["mean"] <= error["max"]


# ---- Mitsuba ----------------------------------------------------------------------------------------

SIZE = 24


def render(tmp_path, variant, path, material, samples):
    out = tmp_path / f"{variant}.npy"
    consume("render_mitsuba.py", variant, path, material, SIZE, samples, out)
    return np.load(out)


def places_inside():
    """Row and column of pixels well inside the disc, and angles over each in a grid of 8 x 8."""
    steps = (np.arange(8) + 0.5) / 8
    row = SIZE // 2
    for radius in (0.1, 0.35, 0.55, 0.75, 0.85):
        column = int((1 + radius) / 2 * SIZE)
        x, y = np.meshgrid((column + steps) / SIZE * 2 - 1, (row + steps) / SIZE * 2 - 1)
        yield row, column, np.degrees(np.arcsin(np.hypot(x, y))).ravel().tolist()


@pytest.mark.parametrize("variant", ["scalar_rgb", "scalar_spectral"])
def test_mitsuba_shows_the_film(nacre, tmp_path, variant):
    """An absorbing base: all that a pixel shows is the film's reflection of white light."""
    source = tmp_path / "film.json"
    film = {
        "ambient": {"n": 1.0},
        "layer": [{"n": 1.6, "thickness_nm": 420}],
        "substrate": {"n": 2.5, "k": 1.5},
    }
    source.write_text(json.dumps(film))
    nacre.ok("export", "mitsuba", source, "-o", tmp_path / "film.xml")
    samples = 256 if variant == "scalar_rgb" else 600
    picture = render(tmp_path, variant, tmp_path / "film.xml", "stack", samples)
    stack = [[1, 0], [1.6, 0], [2.5, 1.5]]
    errors = [
        delta_e(picture[row, column], exact_colours(nacre, stack, [420], angles).mean(axis=0))
        for row, column, angles in places_inside()
    ]
    # Spectral variants draw their wavelengths: what is left there is noise.
    assert np.mean(errors) < (0.3 if variant == "scalar_rgb" else 1.0), errors


def middle(picture):
    return picture[SIZE // 4 : -SIZE // 4, SIZE // 4 : -SIZE // 4].mean(axis=(0, 1))


def test_mitsuba_bubble_cannot_be_seen_in_a_white_world(nacre, tmp_path):
    """What is clear and thin reflects and passes all."""
    nacre.ok("export", "mitsuba", "--material", "soap_film", "-o", tmp_path / "x.xml")
    picture = render(tmp_path, "scalar_rgb", tmp_path / "x.xml", "soap_film", 128)
    assert middle(picture) == pytest.approx(np.ones(3), abs=0.01)


def test_mitsuba_stone_makes_no_light(nacre, tmp_path):
    """Eight bounces leave a little inside."""
    nacre.ok("export", "mitsuba", "--material", "mystic_topaz", "-o", tmp_path / "x.xml")
    picture = render(tmp_path, "scalar_rgb", tmp_path / "x.xml", "mystic_topaz", 256)
    assert (middle(picture) < 1.01).all()
    assert (middle(picture) > 0.9).all()


@pytest.mark.parametrize("roughness", [0, 0.3])
def test_mitsuba_white_base_under_a_clear_film(nacre, tmp_path, roughness):
    """Nothing is lost between base and film: all comes back, but for what facets send down."""
    source = tmp_path / "glaze.json"
    film = {
        "ambient": {"n": 1.0},
        "layer": [{"n": 1.9, "thickness_nm": 300}],
        "substrate": {"n": 1.5},
        "surface": {"diffuse_base": [1, 1, 1]},
    }
    source.write_text(json.dumps(film))
    nacre.ok(
        "export", "mitsuba", source, "--set", f"roughness={roughness}", "-o", tmp_path / "x.xml"
    )
    picture = render(tmp_path, "scalar_rgb", tmp_path / "x.xml", "stack", 100)
    assert middle(picture) == pytest.approx(np.ones(3), abs=0.015)


def test_mitsuba_knows_metals_and_glasses(nacre, tmp_path):
    source = tmp_path / "gold.json"
    source.write_text(
        json.dumps({"ambient": {"n": 1}, "layer": [], "substrate": {"medium": "Au/Johnson"}})
    )
    nacre.ok("export", "mitsuba", source, "--material", "n_bk7", "-o", tmp_path / "x.xml")
    assert not (tmp_path / "nacre_film.py").exists()
    text = (tmp_path / "x.xml").read_text()
    assert '<bsdf type="conductor" id="stack">' in text
    assert '<bsdf type="dielectric" id="n_bk7">' in text
    eta = np.loadtxt(tmp_path / "stack_eta.spd")
    medium = json.loads(nacre.ok("library", "show", "Au/Johnson", "--json"))
    assert medium["key"] == "Au/Johnson"
    assert eta[:, 0].tolist() == list(range(360, 831))


ROUGH_MIRROR = """<scene version="3.0.0"><bsdf type="roughconductor" id="stack">
<string name="material" value="none"/><string name="distribution" value="ggx"/>
<float name="alpha" value="0.16"/></bsdf></scene>"""


def test_mitsuba_rough_mirror_is_that_of_mitsuba(nacre, tmp_path):
    """A film of no thickness on a metal without loss, sample by sample."""
    source = tmp_path / "mirror.json"
    layer = [{"n": 1.2, "thickness_nm": 0}]
    stack = {"ambient": {"n": 1.0}, "layer": layer, "substrate": {"n": 1e-3, "k": 50}}
    source.write_text(json.dumps(stack))
    nacre.ok("export", "mitsuba", source, "--set", "roughness=0.4", "-o", tmp_path / "x.xml")
    ours = render(tmp_path, "scalar_rgb", tmp_path / "x.xml", "stack", 16)
    (tmp_path / "theirs.xml").write_text(ROUGH_MIRROR)
    theirs = render(tmp_path, "scalar_rgb", tmp_path / "theirs.xml", "stack", 16)
    np.testing.assert_allclose(ours, theirs, atol=1e-4)
