# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectra, materials and lights in textures, and back; texels are read without the tool."""

from __future__ import annotations

import json
import warnings

import numpy as np
import OpenImageIO as oiio
import pytest

from support.images import json_attribute, read_all, spec_of

warnings.filterwarnings("ignore", module="colour")
import colour  # noqa: E402
from colour.io import fichet2021  # noqa: E402

GRID = np.arange(324, 836)
PATCHES = ["colorchecker/dark-skin", "colorchecker/light-skin", "colorchecker/foliage"]
#: What a number that is stored so is off by at most, of the largest of its spectrum.
PRECISION = {"float": 2.0**-24, "half": 2.0**-11, "byte": 0.5 / 255}
FILES = [
    ("t.exr", "float"),
    ("t.exr", "half"),
    ("t.tx", "float"),
    ("t.tx", "half"),
    ("t.ftxt", "float"),
    ("t.png", "byte"),
]


def texels(path):
    """(height, width, channels) and the attributes; no channel is multiplied by another."""
    if path.suffix == ".ftxt":
        lines = path.read_text(encoding="utf-8").splitlines()
        comments = dict(line[2:].split(": ", 1) for line in lines if line.startswith("#"))
        rows = [line for line in lines if not line.startswith("#")]
        width, height = map(int, rows[0].split(";"))
        values = np.array([[float(v) for v in row.split(";")] for row in rows[1:]], np.float32)
        return values.reshape(height, width, 4).astype(float), comments
    hints = oiio.ImageSpec()
    hints.attribute("oiio:UnassociatedAlpha", 1)
    image = oiio.ImageInput.open(str(path), hints)
    assert image, oiio.geterror()
    pixels = image.read_image(oiio.FLOAT)
    attributes = {item.name: item.value for item in image.spec().extra_attribs}
    image.close()
    return pixels.astype(float), attributes


def published(key):
    """Of a patch, 324 … 835 nm at 1 nm, as the CIE would have it between the samples."""
    chart = colour.SDS_COLOURCHECKERS["ISO 17321-1"]
    names = {name.replace(" ", "-"): name for name in chart}
    sd = chart[names[key.split("/")[1]]].copy()
    sd = sd.interpolate(colour.SpectralShape(sd.shape.start, sd.shape.end, 1))
    return np.interp(GRID, sd.wavelengths, sd.values)


def read_back(nacre, path):
    """Names and columns of `nacre info --spectra`."""
    lines = nacre.ok("info", path, "--spectra", "-").splitlines()
    table = np.array([[float(v) for v in line.split(",")] for line in lines[1:]])
    return table[:, 0], dict(zip(lines[0].split(",")[1:], table[:, 1:].T, strict=True))


@pytest.mark.parametrize(("name", "depth"), FILES)
def test_packed_spectra_are_the_published_values(nacre, tmp_path, name, depth):
    path = tmp_path / name
    nacre.ok("bake", "spectra", *PATCHES, "--columns", 2, "--depth", depth, "-o", path)
    pixels, attributes = texels(path)
    assert pixels.shape == (2, 256, 4)
    assert json_attribute(attributes, "names") == PATCHES
    assert json_attribute(attributes, "kinds") == ["reflectance"] * 3
    maximum = json_attribute(attributes, "maximum") if depth == "byte" else [1.0] * 3
    for number, key in enumerate(PATCHES):
        row, column = divmod(number, 2)
        block = pixels[row, 128 * column : 128 * (column + 1)]
        wanted = published(key)
        # Texel i, channel c: 324 + 4 i + c nm.
        assert block[59, 1] * maximum[number] == pytest.approx(wanted[4 * 59 + 1], abs=0.003)
        off = np.max(np.abs(block.ravel() * maximum[number] - wanted)) / wanted.max()
        assert off <= PRECISION[depth] * 1.001
    assert not pixels[1, 128:, :].any()
    error = json_attribute(attributes, "error")
    assert 0 < error["relative"] <= PRECISION[depth] * 1.001


@pytest.mark.parametrize(("name", "depth"), FILES)
@pytest.mark.parametrize("layout", ["packed", "single"])
def test_spectra_come_back(nacre, tmp_path, name, depth, layout):
    path = tmp_path / name
    keys = [*PATCHES, "lamp/hps", "D65"]
    options = ("--layout", layout, "--columns", 2, "--depth", depth)
    nacre.ok("bake", "spectra", *keys, *options, "-o", path)
    exact = tmp_path / "exact.csv"
    nacre.ok("bake", "spectra", *keys, "-o", exact)
    _, wanted = read_back_csv(exact)
    wavelengths, spectra = read_back(nacre, path)
    assert np.array_equal(wavelengths, GRID)
    assert list(spectra) == keys
    for key in keys:
        off = np.max(np.abs(spectra[key] - resampled(wanted, key))) / wanted[key][1].max()
        assert off <= PRECISION[depth] * 1.001, key
    # What was read is baked to the same texels again.
    again = tmp_path / ("again" + path.suffix)
    nacre.ok("bake", "spectra", path, *options, "-o", again)
    assert np.array_equal(texels(path)[0], texels(again)[0])


def read_back_csv(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    table = np.array([[float(v) for v in line.split(",")] for line in lines[1:]])
    names = lines[0].split(",")[1:]
    return table[:, 0], {
        name: (table[:, 0], values) for name, values in zip(names, table[:, 1:].T, strict=True)
    }


def resampled(csv, key):
    """Where all samples of the file stand on whole nanometres nothing is interpolated."""
    wavelengths, values = csv[key]
    return np.interp(GRID, wavelengths, values)


def test_bytes_say_how_wrong_they_are(nacre, tmp_path):
    path = tmp_path / "t.png"
    result = nacre("bake", "spectra", "D65", "--maximum", "global", PATCHES[0], "-o", path)
    assert result.returncode == 0
    error = json_attribute(texels(path)[1], "error")
    assert f"values are off by up to {error['max']:.2g}" in result.stderr
    assert f"{100 * error['relative']:.3g} % of the largest of their spectrum" in result.stderr
    # Divided by the maximum of D65 a patch is next to nothing.
    assert error["relative"] > 0.3
    quiet = nacre("--quiet", "bake", "spectra", "D65", "-o", path)
    assert quiet.stderr == ""


def test_spectral_images_are_those_of_the_field(nacre, tmp_path):
    path = tmp_path / "chart.exr"
    nacre.ok("bake", "spectra", *PATCHES, "--layout", "image", "--columns", 2, "-o", path)
    wavelengths, pixels = colour.read_spectral_image_Fichet2021(str(path))["T"]
    assert np.allclose(wavelengths, GRID, atol=1e-6, rtol=0)
    assert pixels.shape == (2, 2, 512)
    for number, key in enumerate(PATCHES):
        assert np.max(np.abs(pixels[divmod(number, 2)] - published(key))) < 1e-6
    assert spec_of(path)["spectralLayoutVersion"] == "1.0"
    assert list(read_back(nacre, path)[1]) == PATCHES


def test_spectral_images_of_others_are_read(nacre, tmp_path):
    path = tmp_path / "lamps.exr"
    sds = [
        colour.SDS_ILLUMINANTS[name].copy().align(colour.SpectralShape(400, 700, 10))
        for name in "AB"
    ]
    layout = fichet2021.Specification_Fichet2021(is_emissive=True)
    lamps = colour.MultiSpectralDistributions(sds)
    colour.write_spectral_image_Fichet2021(lamps, str(path), "float32", layout)
    user = {"XDG_DATA_HOME": str(tmp_path / "data")}
    answer = json.loads(
        nacre.ok("--json", "library", "import", path, "--as", "mine/lamps", env=user)
    )
    assert [entry["kind"] for entry in answer] == ["spectrum"] * 2
    shown = json.loads(nacre.ok("--json", "library", "show", answer[0]["key"], env=user))
    assert shown["kind"] == "emission"
    _, spectra = read_back(nacre, path)
    assert np.allclose(list(spectra.values()), [sd.values for sd in sds], rtol=1e-6)


def test_packed_textures_of_others_are_read_by_their_width(nacre, tmp_path):
    path = tmp_path / "theirs.ftxt"
    values = np.linspace(0, 1, 512)
    rows = [";".join(map(repr, map(float, row))) for row in values.reshape(128, 4)]
    path.write_text("128;1\n" + "\n".join(rows) + "\n", encoding="utf-8")
    wavelengths, spectra = read_back(nacre, path)
    assert np.array_equal(wavelengths, GRID)
    assert np.allclose(spectra["1"], values, atol=1e-7)


METALS = ["Au/Johnson", "Cu/Johnson"]


def decoded(pixels, row, attributes):
    """Intensity, n, k and colour by the documented rule."""
    limits = (
        np.array(json.loads(attributes["nacre:limits"])[row])
        if "nacre:limits" in attributes
        else pixels[row, 513]
    )
    maximum = json.loads(attributes["nacre:maximum"])[row] if "nacre:maximum" in attributes else 1.0
    n = limits[0] + pixels[row, :512, 1] * (limits[1] - limits[0])
    k = limits[2] + pixels[row, :512, 2] * (limits[3] - limits[2])
    rgb = pixels[row, 512, :3]
    if "nacre:colour_maximum" in attributes:
        rgb = rgb * json.loads(attributes["nacre:colour_maximum"])[row]
    return pixels[row, :512, 0] * maximum, n, k, rgb


@pytest.mark.parametrize(("name", "depth"), FILES)
def test_materials_hold_what_an_interference_shader_needs(nacre, tmp_path, name, depth):
    path = tmp_path / name
    nacre.ok("bake", "material", *METALS, "--depth", depth, "-o", path)
    pixels, attributes = texels(path)
    assert pixels.shape == (2, 516, 4)
    unit = PRECISION[depth]
    for row, key in enumerate(METALS):
        intensity, n, k, rgb = decoded(pixels, row, attributes)
        at = json.loads(
            nacre.ok("--json", "library", "show", key, *(f"--at={nm}" for nm in GRID[::20]))
        )
        wanted = np.array([[value["n"], value["k"]] for value in at["at"]])
        assert np.max(np.abs(n[::20] - wanted[:, 0])) <= 2 * unit * wanted[:, 0].max() + 1e-7
        assert np.max(np.abs(k[::20] - wanted[:, 1])) <= 2 * unit * wanted[:, 1].max() + 1e-7
        index = wanted @ [1, 1j]
        reflectance = np.abs((index - 1) / (index + 1)) ** 2
        assert np.max(np.abs(intensity[::20] - reflectance)) <= 2 * unit
        record = {"wavelength_nm": list(map(float, GRID)), "kind": "reflectance"}
        [answer] = nacre.evaluate("spectrum", [{**record, "values": list(map(float, intensity))}])
        assert np.max(np.abs(rgb - answer["rgb"])) < 6 * unit
        assert json_attribute(attributes, "colours")[row] == pytest.approx(rgb, abs=6 * unit)
    # The limits of n and k are rounded as well, but not in an attribute.
    roundings = 1 if depth == "byte" else 2
    assert json_attribute(attributes, "error")["relative"] <= roundings * PRECISION[depth] * 1.001
    spectra = read_back(nacre, path)[1]
    assert list(spectra)[:3] == ["Au/Johnson reflectance", "Au/Johnson n", "Au/Johnson k"]
    assert np.allclose(spectra["Cu/Johnson k"], decoded(pixels, 1, attributes)[2], rtol=1e-6)


def test_materials_as_they_are_and_with_a_spectrum_of_their_own(nacre, tmp_path):
    path = tmp_path / "m.exr"
    nacre.ok("bake", "material", METALS[0], "--as-they-are", "--intensity", PATCHES[0], "-o", path)
    pixels, _ = texels(path)
    assert np.max(np.abs(pixels[0, :512, 0] - published(PATCHES[0]))) < 1e-6
    assert pixels[0, 513] == pytest.approx([0, 1, 0, 1])
    assert pixels[0, 225, 2] == pytest.approx(2.455, abs=0.005)  # k of gold at 549 nm


@pytest.mark.parametrize(("name", "depth"), FILES)
def test_lights_stand_four_a_row(nacre, tmp_path, name, depth):
    path = tmp_path / name
    keys = ["D65", "A", "F11", "lamp/hps", "line:589.3"]
    nacre.ok("bake", "lights", *keys, "--depth", depth, "-o", path)
    pixels, attributes = texels(path)
    assert pixels.shape == (2, 516, 4)
    maximum = json_attribute(attributes, "maximum") if depth == "byte" else [1.0] * 5
    d65 = colour.SDS_ILLUMINANTS["D65"].copy().align(colour.SpectralShape(360, 830, 1))
    got = pixels[0, 36 : 36 + 471, 0] * maximum[0]
    assert np.max(np.abs(got - d65.values)) <= PRECISION[depth] * d65.values.max() * 1.001 + 1e-4
    # The colour of a light is that of its power: D65 is white, A is not.
    white = np.array(json_attribute(attributes, "colours")[0])
    assert np.max(np.abs(white / white[1] - 1)) < max(5e-4, 3 * PRECISION[depth])
    scales = json_attribute(attributes, "colour_maximum") if depth == "byte" else [1.0] * 5
    for light in range(5):
        rgb = pixels[light // 4, 512 + light % 4, :3] * scales[light]
        wanted = np.maximum(
            json_attribute(attributes, "colours")[light], 0 if depth == "byte" else -9
        )
        assert np.max(np.abs(rgb - wanted)) <= PRECISION[depth] * wanted.max() * 1.001
    warm = pixels[0, 513, :3]
    assert warm[0] > warm[1] > warm[2]
    assert not pixels[1, :512, 1:].any()
    assert list(read_back(nacre, path)[1]) == keys


def test_bytes_name_the_colours_that_they_cannot_hold(nacre, tmp_path):
    path = tmp_path / "l.png"
    result = nacre("bake", "lights", "D65", "line:500", "-o", path)
    assert result.returncode == 0
    assert "what is negative in the colour of line:500 is 0" in result.stderr
    pixels, attributes = texels(path)
    exact = json_attribute(attributes, "colours")[1]
    assert exact[0] < 0 < exact[1]
    assert pixels[0, 513, :3] == pytest.approx([0, 1, exact[2] / exact[1]], abs=0.5 / 255)
    assert "negative" not in nacre("bake", "lights", "D65", "-o", path).stderr


def test_half_says_where_it_ends(nacre, tmp_path):
    (tmp_path / "dim.csv").write_text("wavelength_nm,a\n400,1e-9\n700,1e-8\n", encoding="utf-8")
    half = ("--depth", "half", "-o", "t.exr")
    result = nacre("bake", "spectra", "dim.csv", *half, cwd=tmp_path)
    assert result.returncode == 0
    assert "half is coarse below 6e-5: values are off by up to 1e-08, 100 %" in result.stderr
    assert json_attribute(texels(tmp_path / "t.exr")[1], "error")["relative"] == 1
    assert nacre("bake", "spectra", "D65", *half, cwd=tmp_path).stderr == ""


def test_materials_and_lights_as_columns(nacre, tmp_path):
    path = tmp_path / "m.csv"
    nacre.ok("bake", "material", *METALS, "-o", path)
    wavelengths, columns = read_back_csv(path)
    assert np.array_equal(wavelengths, GRID)
    nacre.ok("bake", "material", *METALS, "-o", tmp_path / "m.exr")
    _, spectra = read_back(nacre, tmp_path / "m.exr")
    assert list(columns) == list(spectra)
    for name, (_, values) in columns.items():
        assert np.max(np.abs(values - spectra[name])) <= 2 * PRECISION["float"] * values.max()
    nacre.ok("bake", "lights", "D65", "lamp/hps", "-o", path)
    wavelengths, columns = read_back_csv(path)
    assert list(columns) == ["D65", "lamp/hps"]
    assert columns["D65"][1][wavelengths == 325] == 28.6447


def test_one_pixel_of_a_spectral_image(nacre, tmp_path):
    wide = tmp_path / "wide.exr"
    pixels = np.random.default_rng(7).random((101, 100, 3)).astype(np.float32)
    image = oiio.ImageOutput.create(str(wide))
    header = oiio.ImageSpec(100, 101, 3, oiio.FLOAT)
    header.channelnames = [f"T.{nm},000000nm" for nm in (450, 550, 650)]
    assert image.open(str(wide), header)
    image.write_image(pixels)
    image.close()
    error = nacre.fails("info", wide, "--spectra", "-")
    assert "has 10100 spectra" in error
    assert "--pixel X,Y" in error
    lines = nacre.ok("info", wide, "--spectra", "-", "--pixel=99,100", "--pixel=3,7").splitlines()
    assert lines[0] == "wavelength_nm,99 100,3 7"
    values = np.array([line.split(",") for line in lines[1:]], float)
    assert values[:, 0].tolist() == [450, 550, 650]
    assert np.array_equal(values[:, 1:].T.astype(np.float32), pixels[[100, 7], [99, 3]])
    for pixel, message in {
        "100,0": "within 0 … 99, 0 … 100",
        "1;2": "12,7",
        "-1,0": "--pixel",
    }.items():
        assert message in nacre.fails("info", wide, "--spectra", "-", f"--pixel={pixel}")
    nacre.ok("bake", "lights", "D65", "-o", tmp_path / "l.exr")
    error = nacre.fails("info", tmp_path / "l.exr", "--spectra", "-", "--pixel", "0,0")
    assert "belongs to a spectral image" in error


def test_matching_functions_come_back(nacre, tmp_path):
    for name in ("cmf.exr", "cmf.ftxt", "cmf.png"):
        path = tmp_path / name
        nacre.ok("bake", "cmf", "-o", path)
        _, spectra = read_back(nacre, path)
        cmfs = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy()
        wanted = cmfs.align(colour.SpectralShape(360, 830, 1)).values.T
        limit = 0.5 / 255 * wanted.max() if name.endswith("png") else 1e-6
        assert np.max(np.abs(list(spectra.values()) - wanted)) <= limit * 1.001
    nacre.ok("bake", "cmf", "-o", tmp_path / "cmf.csv")
    _, exact = read_back_csv(tmp_path / "cmf.csv")
    off = np.abs(np.array([values for _, values in exact.values()]) - wanted)
    assert np.max(off) < 1e-14


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("spectra", "D65", "-o", "t.jpg"), "t.jpg: -o: must end in .exr, .tx (float, half)"),
        (("spectra", "D66", "-o", "t.exr"), "D66: INPUT: must be a file, the key of a spectrum"),
        (("spectra", "colorchecker/dark", "-o", "t.exr"), "colorchecker/dark-skin"),
        (("spectra", "none.exr", "-o", "t.exr"), "none.exr"),
        (("spectra", "D65", "--columns", "0", "-o", "t.exr"), "--columns: must be a whole number"),
        (("spectra", "D65", "--columns=-1", "-o", "t.exr"), "whole number ≥ 1 (got -1)"),
        (("spectra", "big.csv", "-o", "t.exr"), "holds values of up to 3.4e38"),
        (("spectra", "1e6.csv", "--depth", "half", "-o", "t.exr"), "half ends at 65504"),
        (("lights", PATCHES[0], "-o", "t.exr"), "dark-skin: kind: must be an emission"),
        (("lights", "D65", "--depth", "half", "-o", "t.csv"), "--depth: must not be set"),
        (("spectra", "D65", "--columns", "600", "-o", "t.exr"), "sides in [1, 65536]"),
        (("spectra", "D65", "--layout", "image", "-o", "t.tx"), "must end in .exr for --layout"),
        (("spectra", "D65", PATCHES[0], "--layout", "image", "-o", "t.exr"), "holds one kind"),
        (("spectra", "neg.csv", "-o", "t.png"), "must be ≥ 0 for a .png"),
        (("spectra", "far.csv", "-o", "t.exr"), "must overlap 324 … 835 nm (got 900 … 1000)"),
        (("material", "nothing", "-o", "t.exr"), "nothing"),
        (("material", *METALS, "--intensity", "D65", "-o", "t.exr"), "once for each of the 2"),
        (("material", METALS[0], "--as-they-are", "-o", "t.png"), "bytes hold nothing above 1"),
        (("lights", "neg.csv", "-o", "t.exr"), "an emission must be ≥ 0"),
    ],
)
def test_bad_input_leaves_nothing(nacre, tmp_path, arguments, message):
    (tmp_path / "neg.csv").write_text("wavelength_nm,a\n400,-1\n700,1\n", encoding="utf-8")
    (tmp_path / "far.csv").write_text("wavelength_nm,a\n900,1\n1000,1\n", encoding="utf-8")
    for name in ("big", "1e6"):
        values = f"wavelength_nm,a\n400,{name.replace('big', '1e39')}\n700,1\n"
        (tmp_path / f"{name}.csv").write_text(values, encoding="utf-8")
    before = set(tmp_path.iterdir())
    assert message in nacre.fails("bake", *arguments, cwd=tmp_path)
    assert set(tmp_path.iterdir()) == before


def test_kind_in_place_of_what_is_stated_is_said(nacre, tmp_path):
    """One note an input, with both kinds; none where --kind only tells what the input does not."""
    untold, told, out = tmp_path / "a.csv", tmp_path / "b.csv", tmp_path / "t.exr"
    untold.write_text("wavelength_nm,a,b\n400,0.5,0.4\n700,0.6,0.7\n", encoding="utf-8")
    told.write_text("# KIND: reflectance\n" + untold.read_text("utf-8"), encoding="utf-8")
    for kind, said in (("reflectance", 0), ("emission", 1)):
        result = nacre("bake", "spectra", untold, told, PATCHES[0], "--kind", kind, "-o", out)
        assert result.returncode == 0, result.stderr
        for source in (told, PATCHES[0]):
            words = f"{source}: --kind emission in place of the kind reflectance, which it states\n"
            assert result.stderr.count(words) == said, result.stderr
        assert str(untold) not in result.stderr
        assert json_attribute(read_all(out)[1], "kinds") == [kind] * 5
    assert nacre("--quiet", "bake", "spectra", told, "--kind", "emission", "-o", out).stderr == ""

    imported = nacre("library", "import", told, "--kind", "emission", "--as", "mine")
    assert f"{told}: --kind emission in place of the kind reflectance" in imported.stderr
    assert imported.returncode == 0


@pytest.mark.parametrize("command", [("bake", "spectra", "-o", "t.exr"), ("library", "import")])
def test_values_that_cannot_be_of_the_kind_are_refused(nacre, tmp_path, own_library, command):
    (tmp_path / "lamp.csv").write_text(
        "# KIND: emission\nwavelength_nm,value\n400,0.5\n700,90\n", encoding="utf-8"
    )
    error = nacre.fails(*command, "lamp.csv", "--kind", "reflectance", cwd=tmp_path)
    assert "lamp.csv: " in error
    assert "is stated to be of the kind emission and cannot be of the kind reflectance: " in error
    assert "a reflectance must be in [0, 2], 1 for all of the light (got 0.5 … 90)" in error
    assert sorted(path.name for path in tmp_path.iterdir()) == ["lamp.csv"]


@pytest.mark.parametrize("light", ["D65", "cie/A", "blackbody:3200"])
def test_a_light_is_no_reflectance(nacre, tmp_path, light):
    error = nacre.fails("bake", "spectra", light, "--kind", "reflectance", "-o", tmp_path / "t.exr")
    assert f"{light}: " in error
    assert "is stated to be of the kind emission and cannot be of the kind reflectance" in error
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("128;1\n1;1;1;1\n", "texel: must be as many as 128 x 1 = 128 (got 1)"),
        ("3;1\n" + "1;1;1;1\n" * 3, "is not a texture of spectra"),
        ("# nacre:quantity: spectra\n# nacre:count: 2\n128;1\n" + "1;1;1;1\n" * 128, "2 high"),
        (
            "# nacre:quantity: spectra\n# nacre:count: 1e9\n128;1\n" + "1;1;1;1\n" * 128,
            "nacre:count",
        ),
        (
            "# nacre:quantity: spectra\n# nacre:names: [1]\n128;1\n" + "1;1;1;1\n" * 128,
            "nacre:names",
        ),
        ("# nacre:quantity: materials\n128;1\n" + "1;1;1;1\n" * 128, "516 texels wide"),
        ("# nacre:quantity: lights\n128;1\n" + "1;1;1;1\n" * 128, "516 texels wide"),
        ("# nacre:quantity: colour_matching_functions\n1;1\n1;1;1;1\n", "471 texels of RGB"),
    ],
)
def test_bad_textures_are_refused_with_their_name(nacre, tmp_path, text, message):
    path = tmp_path / "bad.ftxt"
    path.write_text(text, encoding="utf-8")
    error = nacre.fails("info", path, "--spectra", "-")
    assert "bad.ftxt" in error
    assert message in error
