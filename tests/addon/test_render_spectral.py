# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`render --spectral`: pictures in bands, wrong usage, what was interrupted."""

from __future__ import annotations

import json
import signal
import subprocess
import time

import numpy as np
import OpenImageIO as oiio
import pytest

from nacre import library
from support.images import read_all, read_image
from support.paths import DRIVER, FIXTURES

WHAT = ("--material", "test_film", "--stage", "furnace", "--size", "16x16", "--samples", "24")


def channels_of(path):
    buffer = oiio.ImageBuf(str(path))
    return dict(
        zip(
            buffer.spec().channelnames,
            np.moveaxis(buffer.get_pixels(oiio.FLOAT), -1, 0),
            strict=True,
        )
    )


def test_an_exr_has_a_channel_for_each_wavelength(blender, tmp_path):
    exr, png = tmp_path / "a.exr", tmp_path / "a.png"
    done = blender.render(*WHAT, "--spectral", "--view", "Standard", "--json", "-o", exr, "-o", png)
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["materials"] == {"test_film": "nodes"}
    assert (report["bands"], report["passes"], report["passes_resumed"]) == (24, 8, 0)
    assert 0.0 < report["delta_e"] <= 0.1
    found = channels_of(exr)
    assert sum(name.startswith("S0.") for name in found) == 24
    rgb = np.stack([found[name] for name in "RGB"], axis=-1)
    assert rgb.max() > 0.1
    encoded = np.where(
        rgb <= 0.0031308, 12.92 * rgb, 1.055 * np.maximum(rgb, 0) ** (1 / 2.4) - 0.055
    )
    np.testing.assert_allclose(read_image(png), np.clip(encoded, 0, 1), atol=0.005)
    assert sorted(path.name for path in tmp_path.glob("a*")) == ["a.exr", "a.png"]


def test_under_daylight_a_film_has_the_colours_of_rgb(blender, tmp_path):
    bands, rgb = tmp_path / "bands.exr", tmp_path / "rgb.exr"
    shipped = blender.with_materials("tempered_steel")
    what = ("--material", "tempered_steel", *WHAT[2:])
    for path, how in ((bands, ("--spectral", "--bands", "48")), (rgb, ("--form", "nodes"))):
        done = shipped.render(*what, *how, "-o", path)
        assert done.returncode == 0, done.stderr
    found = np.stack([channels_of(bands)[name] for name in "RGB"], axis=-1)
    np.testing.assert_allclose(found.mean((0, 1)), read_image(rgb).mean((0, 1)), rtol=5e-3)


def test_a_film_without_its_template_is_a_mixture(blender45, tmp_path):
    """What no table in bands can be made for has the colours of RGB under daylight all the same."""
    bands, rgb = tmp_path / "bands.exr", tmp_path / "rgb.exr"
    for path, how in ((bands, ("--spectral", "--bands", "48")), (rgb, ("--form", "nodes"))):
        done = blender45.render(*WHAT, *how, "-o", path)
        assert done.returncode == 0, done.stderr
        said = "was made by an older version: assign it again; its colours are taken for mixtures"
        assert (said in done.stderr) == (path == bands)
    found = np.stack([channels_of(bands)[name] for name in "RGB"], axis=-1)
    np.testing.assert_allclose(found.mean((0, 1)), read_image(rgb).mean((0, 1)), rtol=5e-3)


def test_a_lamp_can_be_any_light(blender45, tmp_path):
    """White under sodium is orange, as bright as under the world's own white."""
    found = {}
    for light in ("World=D65", "World=lamp/lps"):
        path = tmp_path / "a.exr"
        done = blender45.render(*WHAT, "--spectral", "--light", light, "-o", path)
        assert done.returncode == 0, done.stderr
        found[light] = np.array([channels_of(path)[name].max() for name in "RGB"])
    daylight, sodium = found.values()
    assert daylight[2] > 0.2
    assert sodium[0] > 2 * sodium[1]
    assert sodium[2] < 0.0


def test_bands_are_where_a_sensor_has_them(blender, tmp_path):
    path = tmp_path / "cube.exr"
    done = blender.render(
        *WHAT,
        "--spectral",
        "--wavelengths",
        "400:700:10",
        "--light",
        "World=A",
        "--json",
        "-o",
        path,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["bands"] == 33
    found = channels_of(path)
    wanted = [f"S0.{nm},000nm" for nm in range(400, 701, 10)]
    assert set(wanted) < set(found)
    # A third channel of white is what the lamp has there, and colours are those of the eye's bands.
    eye = tmp_path / "eye.exr"
    done = blender.render(*WHAT, "--spectral", "--bands", "48", "--light", "World=A", "-o", eye)
    assert done.returncode == 0, done.stderr
    by_eye = channels_of(eye)
    for name in "RGB":
        np.testing.assert_allclose(found[name].mean(), by_eye[name].mean(), rtol=0.01, atol=2e-3)


def test_a_metal_is_what_it_is_given(blender45, tmp_path):
    scene = tmp_path / "wall.blend"
    blender45.call("pictures.wall", file=str(scene), of_metal=True)
    metals, found = ("Au/Johnson", "Ag/Johnson"), []
    for metal in metals:
        done = blender45.render(
            "--blend", scene, "--size", "8x8", "--samples", "8", "--spectral", "--bands", "24",
            "--surface", f"Wall={metal}", "-o", tmp_path / "wall.exr",
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        channels = channels_of(tmp_path / "wall.exr")
        bands = {name: values[4, 4] for name, values in channels.items() if name.startswith("S0.")}
        found.append(np.array(list(bands.values())))
    at = [float(name[3:-2].replace(",", ".")) for name in bands]
    gold, silver = (
        np.interp(at, np.arange(360, 831), library.medium(metal).index_on_grid())
        for metal in metals
    )
    expected = (np.abs((gold - 1) / (gold + 1)) / np.abs((silver - 1) / (silver + 1))) ** 2
    np.testing.assert_allclose(found[0] / found[1], expected, rtol=5e-3)
    done = blender45.render(
        "--blend", scene, "--spectral", "--surface", "Wall=SiO2/Malitson", "-o", tmp_path / "x.exr"
    )
    assert done.returncode == 1
    assert "SiO2/Malitson is no metal" in done.stderr


def test_a_surface_has_the_reflectance_that_it_is_given(blender45, tmp_path):
    """In every band, whatever its colour in RGB was; from the library, and from a file."""
    nm = np.arange(360, 831, 10)
    rising = (nm - 300) / 1000
    (tmp_path / "paints.csv").write_text(
        "wavelength_nm,rising,white\n"
        + "".join(f"{at},{value},1\n" for at, value in zip(nm, rising, strict=True))
    )
    scene = tmp_path / "wall.blend"
    blender45.call("pictures.wall", file=str(scene))
    found = []
    for surface in (f"{tmp_path}/paints.csv#white", f"{tmp_path}/paints.csv#rising"):
        path = tmp_path / "wall.exr"
        done = blender45.render(
            "--blend", scene, "--size", "8x8", "--samples", "8", "--spectral", "--bands", "24",
            "--surface", f"Wall={surface}", "-o", path,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        channels = channels_of(path)
        bands = {name: values[4, 4] for name, values in channels.items() if name.startswith("S0.")}
        found.append(np.array(list(bands.values())))
    at = [float(name[3:-2].replace(",", ".")) for name in bands]
    np.testing.assert_allclose(found[1] / found[0], np.interp(at, nm, rising), rtol=2e-3)
    for wrong, words in (
        (
            "Wall/Coat=colorchecker/red",
            "say which colour of Wall, Wall/COLOUR=…; there are: Diffuse",
        ),
        ("Wall=F11", "is a light, not a reflectance"),
        ("Wall=none.csv", "none.csv"),
    ):
        done = blender45.render(
            "--blend", scene, "--spectral", "--surface", wrong, "-o", tmp_path / "x.exr"
        )
        assert done.returncode == 1
        assert words in done.stderr


def test_a_render_that_was_killed_goes_on(blender45, tmp_path):
    """Only the passes that are not there yet are rendered; the picture is that of one go."""
    whole, path = tmp_path / "whole.exr", tmp_path / "a.exr"
    what = (*WHAT[:-3], "64x64", "--samples", "240", "--spectral", "--bands", "30")
    process = subprocess.Popen(
        blender45.command(DRIVER, "render", *what, "--quiet", "-o", path),
        env=blender45.surroundings,
    )
    folder = tmp_path / "a.exr.passes"
    deadline = time.monotonic() + 120
    while not (folder / "002.exr").exists():
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    assert not path.exists()
    done = blender45.render(*what, "--resume", "--json", "-o", path)
    assert done.returncode == 0, done.stderr
    assert 3 <= json.loads(done.stdout)["passes_resumed"] <= 9
    assert not folder.exists()
    done = blender45.render(*what, "-o", whole)
    assert done.returncode == 0, done.stderr
    np.testing.assert_array_equal(read_all(path)[0], read_all(whole)[0])


def test_passes_of_another_picture_are_not_taken_for_it(blender45, tmp_path):
    path = tmp_path / "a.exr"
    folder = tmp_path / "a.exr.passes"
    folder.mkdir()
    (folder / "passes.json").write_text("{}")
    (folder / "000.exr").write_bytes(b"something else")
    done = blender45.render(*WHAT, "--spectral", "--resume", "--json", "-o", path)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["passes_resumed"] == 0
    assert not folder.exists()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--spectral", "--bands", "25"), "must be auto or a multiple of 3 in 3 … 300 (got '25')"),
        (("--bands", "24"), "--bands needs --spectral"),
        (("--light", "World=A"), "--light needs --spectral"),
        (("--surface", "Wall=colorchecker/red"), "--surface needs --spectral"),
        (("--wavelengths", "400:700:10"), "--wavelengths needs --spectral"),
        (("--spectral", "--wavelengths", "400:700"), "must be FIRST:LAST:STEP in nm"),
        (
            ("--spectral", "--wavelengths", "400:900:10"),
            "must have bands within 360 … 830 nm (got 395 … 905)",
        ),
        (("--spectral", "--bands", "24", "--wavelengths", "400:700:10"), "are one too many"),
        (("--mode", "paths"), "--mode needs --spectral"),
        (("--spectral", "--surface", "Wall=a.csv"), "--surface: no material 'Wall'; there are: "),
        (("--spectral", "--light", "Key=A"), "--light: no lamp 'Key' in the scene"),
        (("--spectral", "--light", "World=candle"), "--light: illuminant: must be one of E, A"),
        (("--spectral", "--light", "World=colorchecker/red"), "is a reflectance, not a light"),
        (("--spectral", "--form", "osl"), "--form osl does not go with it"),
        (("--spectral", "--aov", "thickness"), "--aov does not go with --spectral"),
    ],
)
def test_wrong_usage(blender45, tmp_path, options, message):
    done = blender45.render(*WHAT, *options, "-o", tmp_path / "a.exr")
    assert done.returncode == 1
    assert message in done.stderr
    assert not (tmp_path / "a.exr").exists()


def test_paths_draw_the_colours_of_bands(blender45, tmp_path):
    found = []
    for mode in ("bands", "paths"):
        exr, png = tmp_path / f"{mode}.exr", tmp_path / f"{mode}.png"
        done = blender45.render(
            *WHAT, "--samples", "256", "--spectral", "--mode", mode, "--light", "World=F11", "--json",
            "-o", exr, "-o", png,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        report = json.loads(done.stdout)
        assert report["passes"] == (1 if mode == "paths" else report["bands"] // 3)
        channels = channels_of(exr)
        assert any(name.startswith("S0.") for name in channels) == (mode == "bands")
        found.append(np.stack([channels[name] for name in "RGB"], axis=-1).mean((0, 1)))
        assert png.is_file()
    np.testing.assert_allclose(found[1], found[0], rtol=0.01)


def test_a_material_without_nodes_is_refused(blender45, tmp_path):
    done = blender45.render(
        "--compiled", FIXTURES / "test_grating", *WHAT[2:], "--spectral", "-o", tmp_path / "a.exr"
    )
    assert done.returncode == 1
    assert "has no form as nodes; OSL is needed for it" in done.stderr
