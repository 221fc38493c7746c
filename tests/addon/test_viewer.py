# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Probe, passes, debug views and pictures of the viewport."""

from __future__ import annotations

import json
import math

import numpy as np
import OpenImageIO as oiio
import pytest
from nacre_extension.core.exr import ExrError, read_channels
from nacre_extension.core.light import USUAL
from nacre_extension.core.whole_file import is_whole
from nacre_extension.films.stack import read_stack, write_template
from nacre_extension.viewer import probe as probes
from nacre_extension.viewer.fields import FIELDS
from nacre_extension.viewer.probe import Reading, Sample, measure, seen_from_behind
from nacre_extension.viewer.view import frame, height_for

from support.images import read_all
from support.paths import TEMPLATES
from support.tool import nacre as run_nacre

SOAP = (TEMPLATES / "soap_film.toml").read_text("utf-8")


# ---- Files with layers ---------------------------------------------------------------------------


def write_layers(path, parts: dict[str, dict[str, np.ndarray]], compression: str) -> None:
    """A part for each entry, whose channels have the names given."""
    specs, pictures = [], []
    for name, channels in parts.items():
        height, width = next(iter(channels.values())).shape
        spec = oiio.ImageSpec(width, height, len(channels), oiio.FLOAT)
        spec.channelnames = tuple(channels)
        spec.attribute("compression", compression)
        spec.attribute("oiio:subimagename", name)
        specs.append(spec)
        pictures.append(np.stack(list(channels.values()), axis=-1).astype(np.float32))
    file = oiio.ImageOutput.create(str(path))
    opened = file.open(str(path), specs[0]) if len(specs) == 1 else file.open(str(path), specs)
    assert opened, oiio.geterror()
    for index, (spec, picture) in enumerate(zip(specs, pictures, strict=True)):
        if index:
            file.open(str(path), spec, "AppendSubimage")
        file.write_image(picture)
    file.close()


@pytest.fixture
def values():
    return np.arange(6, dtype=np.float32).reshape(2, 3) / 7


def test_layers_of_one_part_are_read(tmp_path, values):
    path = tmp_path / "é.exr"
    channels = {"ViewLayer.Combined.R": values, "ViewLayer.nacre_id.X": 2 * values}
    write_layers(path, {"": channels}, "none")
    read = read_channels(path)
    assert set(read) == {"Combined.R", "nacre_id.X"}
    np.testing.assert_array_equal(read["Combined.R"], values.ravel())
    np.testing.assert_array_equal(read["nacre_id.X"], 2 * values.ravel())


def test_layers_of_several_parts_are_read(tmp_path, values):
    """As Blender 5 writes them."""
    path = tmp_path / "parts.exr"
    parts = {
        "ViewLayer.Combined": {"ViewLayer.Combined.R": values},
        "ViewLayer.nacre_uv": {"ViewLayer.nacre_uv.R": -values, "ViewLayer.nacre_uv.G": 3 + values},
    }
    write_layers(path, parts, "none")
    read = read_channels(path)
    np.testing.assert_array_equal(read["Combined.R"], values.ravel())
    np.testing.assert_array_equal(read["nacre_uv.R"], -values.ravel())
    np.testing.assert_array_equal(read["nacre_uv.G"], 3 + values.ravel())
    data = path.read_bytes()
    assert is_whole(path)
    path.write_bytes(data[:-1])
    assert not is_whole(path)


def test_other_files_are_refused(tmp_path, values):
    path = tmp_path / "piz.exr"
    write_layers(path, {"": {"Combined.R": values}}, "piz")
    with pytest.raises(ExrError, match=r"piz\.exr: cannot be read"):
        read_channels(path)
    write_layers(path, {"": {"Combined.R": values}}, "zip")
    np.testing.assert_array_equal(read_channels(path)["Combined.R"], np.ravel(values))
    path.write_bytes(b"v/1\x01\x02")
    with pytest.raises(ExrError, match="cannot be read"):
        read_channels(path)


# ---- The camera of a viewport --------------------------------------------------------------------


def perspective(left, right, bottom, top, near, far):
    return (
        (2 * near / (right - left), 0, (right + left) / (right - left), 0),
        (0, 2 * near / (top - bottom), (top + bottom) / (top - bottom), 0),
        (0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)),
        (0, 0, -1, 0),
    )


def orthographic(left, right, bottom, top, near, far):
    return (
        (2 / (right - left), 0, 0, -(right + left) / (right - left)),
        (0, 2 / (top - bottom), 0, -(top + bottom) / (top - bottom)),
        (0, 0, -2 / (far - near), -(far + near) / (far - near)),
        (0, 0, 0, 1),
    )


def test_frame_of_a_perspective_view():
    found = frame(perspective(-0.03, 0.05, -0.02, 0.02, 0.1, 100.0), (800, 400))
    assert (found.is_perspective, found.sensor_fit, found.back) == (True, "VERTICAL", 0.0)
    assert found.extent == pytest.approx(0.4)
    assert found.sensor_mm / found.lens_mm == pytest.approx(0.4)
    assert found.shift == pytest.approx((0.1 / 0.4, 0.0))
    assert found.clip == pytest.approx((0.1, 100.0))


def test_frame_of_an_orthographic_view_stands_behind_what_it_sees():
    """The near plane of an orthographic viewport lies behind its origin."""
    found = frame(orthographic(-2, 4, -1, 2, -500.0, 500.0), (300, 300))
    assert (found.is_perspective, found.sensor_fit) == (False, "HORIZONTAL")
    assert found.extent == pytest.approx(6.0)
    assert found.shift == pytest.approx((1 / 6, 0.5 / 6))
    assert found.back == pytest.approx(500.001)
    assert found.clip == pytest.approx((0.001, 1000.001))


def test_very_wide_views_keep_to_the_least_lens():
    found = frame(perspective(-5.0, 5.0, -5.0, 5.0, 0.1, 10.0), (64, 64))
    assert found.lens_mm == 1.0
    assert found.sensor_mm == pytest.approx(100.0)


def test_height_follows_the_region():
    assert height_for(1920, (1280, 720)) == 1080


# ---- What a probe says ---------------------------------------------------------------------------


def reading(cos_theta: float, nm: float = 400.0, is_back: bool = False) -> Reading:
    return Reading((0, 0, 1), (0, 0, 1), (0.25, 0.5, 0), cos_theta, is_back, nm)


def film(template: str, unit_nm: float = 1.0, varies: bool = True) -> Sample:
    return Sample(template, USUAL, unit_nm, varies)


def test_probe_of_a_soap_film_is_the_multilayer():
    nacre = pytest.importorskip("nacre")
    angle = 37.0
    found = measure(
        (3, 4), "Soap", "film", reading(math.cos(math.radians(angle)), 432.1), film(SOAP)
    )
    nm = np.arange(360.0, 831.0)
    water = nacre.library.medium("water/Daimon-20C").index(nm)
    media = np.stack([np.ones_like(nm), water, np.ones_like(nm)], axis=-1)
    exact = nacre.stack(media, [432.1], angle_deg=angle, wavelength_nm=nm)
    np.testing.assert_allclose(found.reflected.spectrum, exact.R, atol=1e-12)
    np.testing.assert_allclose(found.transmitted.spectrum, exact.T, atol=1e-12)
    given = nacre.template_spectrum(SOAP, 432.1, angle)
    np.testing.assert_allclose(found.reflected.rgb, given.colours[0], atol=1e-9)
    np.testing.assert_allclose(found.transmitted.rgb, given.colours[1], atol=1e-9)
    # What is not reflected is let through: nothing absorbs.
    total = np.add(found.reflected.XYZ, found.transmitted.XYZ)
    assert total[1] == pytest.approx(1.0, abs=1e-9)
    data = json.loads(found.json())
    assert data["angle_deg"] == pytest.approx(angle, abs=1e-12)
    assert data["R"]["sRGB"] == found.reflected.hex
    assert len(data["R"]["spectrum"]) == 471
    assert f"Reflected sRGB: {found.reflected.hex}" in found.text()


def test_probe_of_a_scale_counts_in_the_thickness_of_all_layers():
    nacre = pytest.importorskip("nacre")
    beetle = (TEMPLATES / "jewel_beetle.toml").read_text("utf-8")
    total = sum(layer.thickness_nm for layer in read_stack(beetle).layers)
    found = measure((0, 0), "B", "film", reading(0.8, 1.1 * total), film(beetle, total))
    exact = nacre.template_spectrum(beetle, 1.1, math.degrees(math.acos(0.8)))
    np.testing.assert_allclose(found.reflected.spectrum, exact.reflectance, atol=1e-12)
    assert found.transmitted is None


COATED = """schema = 1
material = { id = "coat", name = "Coat", category = "Films", source = "a test" }
layer = [
    { n = 2.3, thickness_nm = 70 },
    { n = 1.4, thickness_nm = { default = 100, min = 0, max = 500, varies = true } },
]
ambient = { medium = "air" }
substrate = { n = 1.5 }
surface = { transmission = true }
"""


def test_glass_from_inside_is_the_film_the_other_way_round():
    nacre = pytest.importorskip("nacre")
    nm = np.arange(360.0, 831.0)
    inside = measure((0, 0), "C", "film", reading(0.9, 120.0, is_back=True), film(COATED))
    angle = math.degrees(math.acos(0.9))
    exact = nacre.stack([1.5, 1.4, 2.3, 1.0], [120.0, 70.0], angle_deg=angle, wavelength_nm=nm)
    np.testing.assert_allclose(inside.reflected.spectrum, exact.R, atol=1e-12)
    # Beyond the critical angle nothing gets out.
    beyond = measure((0, 0), "C", "film", reading(0.5, 120.0, is_back=True), film(COATED))
    np.testing.assert_allclose(beyond.reflected.spectrum, 1.0, atol=1e-12)
    assert beyond.data()["side"] == "back"


def test_turning_a_stack_twice_changes_nothing():
    stack = read_stack(COATED)
    assert seen_from_behind(seen_from_behind(stack)) == stack
    assert seen_from_behind(stack).varying == 0


def test_a_film_that_cannot_be_computed_has_its_problem():
    broken = write_template(read_stack(SOAP)).replace("water/Daimon-20C", "no/such")
    found = measure((0, 0), "S", "film", reading(0.5), film(broken))
    assert found.reflected is None
    assert "no/such" in found.problem
    assert "no/such" in found.data()["problem"]
    assert "no/such" in found.text()


def test_colours_outside_the_gamut_are_held_in_hex_alone():
    light = probes.Light((0.0,) * 471, (0, 0, 0), (-0.1, 0.5, 1.2))
    assert light.hex == "#00bcff"
    assert not light.is_in_gamut


def test_what_is_no_film_has_no_spectrum():
    found = measure((1, 2), "Disc", "grating", reading(0.5), None)
    assert found.data()["thickness_nm"] is None
    assert "R" not in found.data()
    assert "Thickness" not in dict(found.lines())
    assert dict(found.lines())["Angle"] == "60.0000°, front"


# ---- In Blender ----------------------------------------------------------------------------------


def test_camera_sees_what_the_viewport_sees(blender, tmp_path):
    (tmp_path / "out").mkdir()
    blender.script("viewer/viewport_camera", tmp_path / "out")


@pytest.mark.parametrize("form", ["osl", "nodes"])
def test_probe(blender, tmp_path, form):
    blender = blender.with_materials("soap_film", "jewel_beetle")
    blender.script("viewer/probe", tmp_path, form)


def test_views_and_passes_come_and_go(blender, tmp_path):
    blender.script("viewer/views", tmp_path)


# ---- The command line ----------------------------------------------------------------------------


def layers(path) -> dict[str, np.ndarray]:
    """By `layer.channel`, pictures of shape (height, width), row 0 on top."""
    file = oiio.ImageInput.open(str(path))
    found, part = {}, 0
    while file.seek_subimage(part, 0):
        pixels = file.read_image(oiio.FLOAT)
        for index, name in enumerate(file.spec().channelnames):
            found[".".join(name.split(".")[-2:])] = pixels[..., index]
        part += 1
    return found


SIZE = 64


def sphere() -> tuple[np.ndarray, np.ndarray]:
    """Normals of the furnace's unit sphere at the pixels' middles, and where it is seen well: a
    sample lies within 0.005 of a pixel from the middle, so at the rim cosθ is not sharp."""
    row, column = np.mgrid[0:SIZE, 0:SIZE]
    x, y = 2 * (column + 0.5) / SIZE - 1, 1 - 2 * (row + 0.5) / SIZE
    z = np.sqrt(np.maximum(1 - x * x - y * y, 0.0))
    return np.stack([x, y, z], axis=-1), x * x + y * y < 0.9


@pytest.mark.parametrize("form", ["osl", "nodes"])
def test_passes_of_the_furnace_sphere_are_analytic(blender, tmp_path, form):
    picture = tmp_path / "s.exr"
    done = blender.render(
        "--material", "test_film", "--form", form, "--stage", "furnace", "--size", f"{SIZE}x{SIZE}",
        "--samples", "1", "--set", "thickness_nm=432.5", "-o", picture,
        *(text for item in FIELDS for text in ("--aov", item.id)),
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found = layers(tmp_path / "s_passes.exr")
    normal, inside = sphere()
    np.testing.assert_allclose(found["nacre_cos_theta.X"][inside], normal[inside][:, 2], atol=1e-3)
    np.testing.assert_allclose(found["nacre_thickness.X"][inside], 432.5, rtol=1e-6)
    for axis, letter in enumerate("RGB"):
        measured = found[f"nacre_normal.{letter}"][inside]
        np.testing.assert_allclose(measured, normal[inside][:, axis], atol=1e-3)
        towards = found[f"nacre_to_camera.{letter}"][inside]
        np.testing.assert_allclose(towards, float(axis == 2), atol=1e-6)
    # Exactly consistent among each other, where the samples were.
    np.testing.assert_allclose(
        found["nacre_cos_theta.X"][inside], found["nacre_normal.B"][inside], atol=1e-6
    )
    plain = tmp_path / "plain.exr"
    blender.render(
        "--material", "test_film", "--form", form, "--stage", "furnace", "--size", f"{SIZE}x{SIZE}",
        "--samples", "1", "--set", "thickness_nm=432.5", "-o", plain,
    )  # fmt: skip
    (with_passes, _), (without, _) = read_all(picture), read_all(plain)
    np.testing.assert_array_equal(with_passes, without)
    assert np.ptp(without) > 0


def test_pixel_of_a_stage_is_the_exact_film(blender):
    nacre = pytest.importorskip("nacre")
    blender = blender.with_materials("soap_film")
    done = blender.render(
        "--material", "soap_film", "--stage", "furnace", "--size", "256x256", "--set",
        "thickness_nm=432.1", "--pixel", "200", "60", "--pixel", "128", "128", "--json",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["output"] == []
    found = report["probes"][0]
    x, y = 2 * 200.5 / 256 - 1, 1 - 2 * 60.5 / 256
    np.testing.assert_allclose(found["point"][:2], [x, y], atol=1e-4)
    z = found["point"][2]
    np.testing.assert_allclose(np.linalg.norm(found["point"]), 1.0, atol=1e-6)
    np.testing.assert_allclose(found["normal"], found["point"], atol=1e-6)
    assert math.cos(math.radians(found["angle_deg"])) == pytest.approx(z, abs=1e-6)
    assert found["thickness_nm"] == pytest.approx(432.1, rel=1e-7)
    # Of the true angle at that point of the sphere, not of the one that was reported.
    exact = nacre.template_spectrum(SOAP, 432.1, math.degrees(math.acos(z)))
    np.testing.assert_allclose(found["R"]["spectrum"], exact.reflectance, atol=1e-6)
    np.testing.assert_allclose(found["R"]["rgb"], exact.colours[0], atol=1e-6)
    np.testing.assert_allclose(found["T"]["rgb"], exact.colours[1], atol=1e-6)
    record = {
        "n": [[1, 0], nacre_index(nacre, 550), [1, 0]], "d_nm": [432.1],
        "angle_deg": math.degrees(math.acos(z)), "wavelength_nm": 550, "pol": "u",
    }  # fmt: skip
    tool = eval_stack(record)
    assert found["R"]["spectrum"][550 - 360] == pytest.approx(tool["R"], abs=1e-6)


def nacre_index(nacre, nm: float) -> list[float]:
    index = complex(np.ravel(nacre.library.medium("water/Daimon-20C").index([nm]))[0])
    return [index.real, index.imag]


def eval_stack(record: dict) -> dict:
    return json.loads(run_nacre("eval", "stack", "-", stdin=json.dumps(record)))


def test_pixel_of_a_thickness_map_is_the_picture(blender, tmp_path):
    """The plane's picture at the place that the probe reports, between black and white."""
    blender = blender.with_materials("oil_on_water")
    height, width = 32, 32
    rng = np.random.default_rng(3)
    grey = rng.random((height, width), dtype=np.float32)
    spec = oiio.ImageSpec(width, height, 3, oiio.FLOAT)
    file = oiio.ImageOutput.create("map.exr")
    path = tmp_path / "Dicke é.exr"
    assert file.open(str(path), spec)
    file.write_image(np.repeat(grey[..., None], 3, axis=-1))
    file.close()
    pixels = [("30", "34"), ("36", "30"), ("28", "30")]
    done = blender.render(
        "--material", "oil_on_water", "--stage", "plane", "--size", "64x64", "--thickness-map",
        path, "--range", "100:800", "--json",
        *(text for x, y in pixels for text in ("--pixel", x, y)),
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    for found in json.loads(done.stdout)["probes"]:
        u, v = found["uv"]
        x, y = u * width - 0.5, (1 - v) * height - 0.5
        column, row = int(x), int(y)
        s, t = x - column, y - row
        corner = grey[row : row + 2, column : column + 2]
        value = np.array([1 - t, t]) @ corner @ np.array([1 - s, s])
        assert found["thickness_nm"] == pytest.approx(100 + 700 * value, abs=0.05)
        assert found["uv"][0] == pytest.approx(0.5 + found["point"][0] / 4, abs=1e-5)


def test_a_drop_has_the_thickness_that_is_asked_for(blender):
    """base + height (1 − r²/R²) in texture coordinates, the base outside."""
    pixels = [(30, 34), (36, 30), (28, 30)]
    drop = "drop:base_nm=100,height_nm=600,radius=0.12,centre=0.475:0.46"
    done = blender.with_materials("oil_on_water").render(
        "--material", "oil_on_water", "--stage", "plane", "--size", "64x64", "--vary", drop, "--json",
        *(text for x, y in pixels for text in ("--pixel", x, y)),
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    heights = []
    for found in json.loads(done.stdout)["probes"]:
        u, v = found["uv"]
        inside = max(0.0, 1.0 - ((u - 0.475) ** 2 + (v - 0.46) ** 2) / 0.12**2)
        assert found["thickness_nm"] == pytest.approx(100.0 + 600.0 * inside, abs=0.01)
        heights.append(inside)
    assert 0.0 in heights
    assert max(heights) > 0.5


def test_pixel_with_a_picture_says_both(blender45, tmp_path):
    """The fixture has no template, so its layers are not known: that is no success."""
    output = tmp_path / "a.exr"
    done = blender45.render(
        "--material", "test_film", "--stage", "furnace", "--size", "16x16", "--samples", "1",
        "--pixel", "8", "8", "-o", output,
    )  # fmt: skip
    assert done.returncode == 1
    assert "Thickness: 400.000 nm" in done.stdout
    assert f"{output}: test_film (osl)" in done.stdout
    assert output.is_file()
    assert "nacre render: --pixel 8 8: " in done.stderr
    assert "made by an older version" in done.stderr


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--pixel", "16", "0"], "pixel 16 0: must be within 0 0 … 15 15"),
        (["--pixel", "0", "0"], "pixel 0 0: there is nothing"),
        (["--pixel", "1"], "--pixel"),
        (["--pixel", "-1", "0"], "--pixel"),
        ([], "give -o FILE, or --pixel X Y"),
        (["--aov", "depth", "-o", "x.exr"], "--aov"),
        (["--pixel", "1", "1", "--vary", "swirl", "--frames", "1-2"], "--pixel is of one frame"),
    ],
)
def test_wrong_looks_are_told(blender45, arguments, message):
    done = blender45.render(
        "--material", "test_film", "--stage", "furnace", "--size", "16x16", *arguments
    )
    assert done.returncode == 1
    assert message in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
