# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre eval spectrum` against colour-science on the same 1 nm tables, and against published values."""

from __future__ import annotations

import json
import math
import random

import colour
import numpy as np
import pytest

GRID = np.arange(360, 831)
OBSERVERS = {
    "cie1931": "CIE 1931 2 Degree Standard Observer",
    "cie1964": "CIE 1964 10 Degree Standard Observer",
}


def cmfs(observer):
    return colour.MSDS_CMFS[OBSERVERS[observer]].copy().align(colour.SpectralShape(360, 830, 1))


def gaussian(centre, width, wavelengths):
    return np.exp(-(((np.asarray(wavelengths) - centre) / width) ** 2))


def rough(seed, count):
    random_number = random.Random(seed)
    return [random_number.random() for _ in range(count)]


def spectrum(name, wavelengths, values, kind, observer="cie1931", illuminant=None):
    record = {
        "wavelength_nm": [float(x) for x in wavelengths],
        "values": [float(x) for x in values],
        "kind": kind,
        "observer": observer,
    }
    if illuminant:
        record["illuminant"] = illuminant
    return pytest.param(record, id=name)


FIVE = np.arange(380, 781, 5)
TEN = np.arange(360, 831, 10)
EMISSIONS = [
    spectrum("equal-energy", [360, 830], [1, 1], "emission"),
    spectrum("equal-energy-10deg", [360, 830], [1, 1], "emission", "cie1964"),
    spectrum("line-546", GRID, gaussian(546, 1.5, GRID), "emission"),
    spectrum("line-589", GRID, gaussian(589, 2, GRID), "emission", "cie1964"),
    spectrum("led", FIVE, gaussian(450, 15, FIVE) + 0.6 * gaussian(560, 60, FIVE), "emission"),
    spectrum("laser-one-texel", [531, 532, 533], [0, 1, 0], "emission"),
    spectrum("triangle-off-grid", [500.25, 540.5, 610.75], [0, 3, 0], "emission"),
    spectrum("rough-1nm", GRID, rough(1, 471), "emission"),
    spectrum("rough-5nm", FIVE, rough(2, 81), "emission", "cie1964"),
    spectrum("wider-than-visible", [200, 1200], [0, 5], "emission"),
    spectrum("bright", TEN, 1e4 * gaussian(600, 100, TEN), "emission"),
]
REFLECTANCES = [
    spectrum("grey", [360, 830], [0.18, 0.18], "reflectance", illuminant="E"),
    spectrum("ramp", [360, 830], [0, 1], "reflectance", illuminant="E"),
    spectrum("ramp-A", [360, 830], [0, 1], "reflectance", illuminant="A"),
    spectrum("ramp-D65", [360, 830], [1, 0], "reflectance", illuminant="D65"),
    spectrum("default-light", [360, 830], [0.3, 0.7], "reflectance"),
    spectrum("band-10deg", TEN, gaussian(520, 40, TEN), "reflectance", "cie1964", "D65"),
    spectrum("notch", GRID, 1 - gaussian(580, 12, GRID), "reflectance", illuminant="D65"),
    spectrum("fringes", GRID, np.cos(3e4 / GRID) ** 2, "reflectance", illuminant="D65"),
    spectrum("rough-A-10deg", GRID, rough(3, 471), "reflectance", "cie1964", "A"),
    spectrum("rough-5nm-D65", FIVE, rough(4, 81), "reflectance", illuminant="D65"),
    spectrum("step", [360, 599.999, 600, 830], [0, 0, 1, 1], "reflectance", illuminant="A"),
]


def on_grid(record):
    """To 1 nm as colour-science does for equal steps, else linearly; ends are held."""
    wavelengths, values = record["wavelength_nm"], record["values"]
    if len(values) >= 6 and len(set(np.diff(wavelengths))) == 1:
        samples = colour.SpectralDistribution(dict(zip(wavelengths, values, strict=True)))
        return samples.align(colour.SpectralShape(360, 830, 1)).values
    return np.interp(GRID, wavelengths, values)


def light_on_grid(name):
    """The CIE's table in steps of 5 nm, linear in between."""
    if name == "E":
        return np.ones(471)
    light = colour.SDS_ILLUMINANTS[f"FL{name[1:]}" if name.startswith("F") else name]
    return np.interp(GRID, light.wavelengths, light.values)


def reference_xyz(values, observer, light):
    shape = dict(zip(GRID, values, strict=True))
    return (
        colour.sd_to_XYZ(
            colour.SpectralDistribution(shape),
            cmfs(observer),
            colour.SpectralDistribution(dict(zip(GRID, light, strict=True))),
            method="Integration",
        )
        / 100
    )


@pytest.mark.parametrize("record", EMISSIONS)
def test_emission_agrees_with_colour_science(nacre, record):
    expected = reference_xyz(on_grid(record), record["observer"], np.ones(471))
    answer = nacre.evaluate("spectrum", record)
    scale = max(1.0, float(np.max(expected)))
    assert np.max(np.abs(np.array(answer["XYZ"]) - expected)) <= 1e-9 * scale
    assert answer["xy"] == pytest.approx(colour.XYZ_to_xy(expected).tolist(), abs=1e-9)


@pytest.mark.parametrize("record", REFLECTANCES)
def test_reflectance_agrees_with_colour_science(nacre, record):
    light = light_on_grid(record.get("illuminant", "D65"))
    expected = reference_xyz(on_grid(record), record["observer"], light)
    answer = nacre.evaluate("spectrum", record)
    assert np.max(np.abs(np.array(answer["XYZ"]) - expected)) <= 1e-9

    white = reference_xyz(np.ones(471), record["observer"], light)
    lab = colour.XYZ_to_Lab(expected, colour.XYZ_to_xy(white))
    assert answer["Lab"] == pytest.approx(lab.tolist(), abs=1e-6)


# colour-science has Ohno's method on its own locus, for the 1931 observer as well.
@pytest.mark.parametrize(
    "record", [{"blackbody_K": 3000}, {"daylight_K": 6504}, {"illuminant": "F7"}], ids=str
)
def test_colour_temperature_is_that_of_the_1931_observer(nacre, record):
    answers = [nacre.evaluate("spectrum", {**record, "observer": name}) for name in OBSERVERS]
    assert answers[0]["xy"] != answers[1]["xy"]
    assert answers[0]["cct_K"] == answers[1]["cct_K"]
    assert answers[0]["duv"] == answers[1]["duv"]
    patch = {"spectrum": "colorchecker/white-9-5", "illuminant": "A"}
    patches = [nacre.evaluate("spectrum", {**patch, "observer": name}) for name in OBSERVERS]
    assert patches[0]["cct_K"] == patches[1]["cct_K"]


def test_daylight_is_white_to_both_observers(nacre):
    light = light_on_grid("D65")
    white = reference_xyz(light, "cie1964", np.ones(471))
    record = {"wavelength_nm": GRID.tolist(), "values": light.tolist(), "kind": "emission"}
    answer = nacre.evaluate("spectrum", {**record, "observer": "cie1964"})
    luminance = answer["XYZ"][1]
    assert answer["rgb"] == pytest.approx([luminance] * 3, rel=1e-12)
    lab = colour.XYZ_to_Lab(np.array(answer["XYZ"]), colour.XYZ_to_xy(white))
    assert answer["Lab"] == pytest.approx(lab.tolist(), abs=1e-6)
    assert answer["Lab"][1:] == pytest.approx([0, 0], abs=1e-9)


@pytest.mark.parametrize("illuminant", ["E", "A", "D65", "D50"])
@pytest.mark.parametrize("observer", list(OBSERVERS))
@pytest.mark.parametrize("space", ["lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene"])
def test_a_perfect_white_is_white(nacre, illuminant, observer, space):
    record = {
        "wavelength_nm": [360, 830],
        "values": [1, 1],
        "kind": "reflectance",
        "illuminant": illuminant,
        "observer": observer,
    }
    answer = nacre.evaluate("spectrum", record, "--space", space)
    assert answer["rgb"] == pytest.approx([1, 1, 1], abs=1e-12)
    assert answer["Lab"] == pytest.approx([100, 0, 0], abs=1e-10)
    assert answer["space"] == space


# CIE 015:2018, chromaticities for the 1931 observer; sums over 5 nm, ours are over 1 nm.
PUBLISHED_XY = {"A": (0.44758, 0.40745), "D65": (0.31272, 0.32903), "D50": (0.34567, 0.35851)}


@pytest.mark.parametrize("name", PUBLISHED_XY)
def test_named_lights_have_their_published_chromaticity(nacre, name):
    answer = nacre.evaluate("spectrum", {"illuminant": name})
    assert answer["xy"] == pytest.approx(PUBLISHED_XY[name], abs=3e-5)
    assert answer["XYZ"][1] == pytest.approx(1, abs=1e-15)


LED = [f"LED-{name}" for name in ("B1", "B2", "B3", "B4", "B5", "BH1", "RGB1", "V1", "V2")]
DAYLIGHT = ["D50", "D55", "D65", "D75"]
LIGHTS = ["E", "A", "B", "C", *DAYLIGHT, *(f"F{i}" for i in range(1, 13)), *LED]


def test_every_light_is_listed(nacre):
    listed = nacre.ok("library", "list", "--kind", "illuminants").split()
    assert sorted(listed) == sorted(LIGHTS)


@pytest.mark.parametrize("observer", list(OBSERVERS))
def test_every_light_agrees_with_colour_science(nacre, observer):
    answers = nacre.evaluate(
        "spectrum", [{"illuminant": name, "observer": observer} for name in LIGHTS]
    )
    for name, answer in zip(LIGHTS, answers, strict=True):
        expected = reference_xyz(light_on_grid(name), observer, np.ones(471))
        assert answer["XYZ"] == pytest.approx((expected / expected[1]).tolist(), abs=1e-9), name


def test_colour_temperature_of_every_light_agrees_with_colour_science(nacre):
    for name, answer in zip(
        LIGHTS, nacre.evaluate("spectrum", [{"illuminant": n} for n in LIGHTS]), strict=True
    ):
        uv = colour.UCS_to_uv(colour.XYZ_to_UCS(np.array(answer["XYZ"])))
        cct, duv = colour.temperature.uv_to_CCT_Ohno2013(uv)
        assert answer["cct_K"] == pytest.approx(cct, abs=0.1), name
        assert answer["duv"] == pytest.approx(duv, abs=1e-6), name


@pytest.mark.parametrize("illuminant", ["D65", "A"])
@pytest.mark.parametrize("chart", ["ISO 17321-1", "ColorChecker N Ohta"])
def test_colour_checker_agrees_with_colour_science(nacre, chart, illuminant):
    patches = colour.SDS_COLOURCHECKERS[chart]
    records = [
        {
            "wavelength_nm": patch.wavelengths.tolist(),
            "values": patch.values.tolist(),
            "kind": "reflectance",
            "illuminant": illuminant,
        }
        for patch in patches.values()
    ]
    assert len(records) == 24
    light = light_on_grid(illuminant)
    for record, answer in zip(records, nacre.evaluate("spectrum", records), strict=True):
        expected = reference_xyz(on_grid(record), "cie1931", light)
        assert np.max(np.abs(np.array(answer["XYZ"]) - expected)) <= 1e-9


def test_lights_by_temperature_and_lines(nacre):
    hot, same, mercury, alone = nacre.evaluate(
        "spectrum",
        [
            {"illuminant": "blackbody:3500"},
            {"blackbody_K": 3500},
            {"illuminant": "line:436@2,546@1"},
            {"illuminant": "line:546"},
        ],
    )
    assert hot == same
    at = dict(zip(GRID, cmfs("cie1931").values, strict=True))
    xyz = 2 * at[436] + at[546]
    assert mercury["XYZ"] == pytest.approx((xyz / xyz[1]).tolist(), abs=1e-12)
    assert alone["cct_K"] is None


def test_colour_temperature(nacre):
    incandescent, warm, daylight, line = nacre.evaluate(
        "spectrum",
        [
            {"illuminant": "A"},
            {"blackbody_K": 3500},
            {"daylight_K": 6504},
            {"wavelength_nm": [519, 520, 521], "values": [0, 1, 0], "kind": "emission"},
        ],
    )
    assert incandescent["cct_K"] == pytest.approx(2856, abs=1)
    assert warm["cct_K"] == pytest.approx(3500, abs=1)
    assert warm["duv"] == pytest.approx(0, abs=1e-5)
    # IES TM-30: D65 lies 0.0032 above the Planckian locus.
    assert daylight["cct_K"] == pytest.approx(6503, abs=3)
    assert daylight["duv"] == pytest.approx(0.0032, abs=1e-4)
    assert line["cct_K"] is None
    assert line["duv"] is None


def test_equal_energy_has_unit_luminance(nacre):
    record = {"wavelength_nm": [360, 830], "values": [1, 1], "kind": "emission"}
    assert nacre.evaluate("spectrum", record)["XYZ"][1] == pytest.approx(1, abs=1e-14)


def test_black_has_no_chromaticity(nacre):
    record = {"wavelength_nm": [360, 830], "values": [0, 0], "kind": "reflectance"}
    answer = nacre.evaluate("spectrum", record)
    assert answer["XYZ"] == [0, 0, 0]
    assert answer["xy"] is None
    assert answer["cct_K"] is None


RAMP = {"wavelength_nm": [400, 500, 600], "values": [0, 1, 0], "kind": "emission"}
BAD = {
    "sizes": (
        {"values": [1, 2]},
        "values: must have one value for each of the 3 wavelengths (got 2)",
    ),
    "descending": ({"wavelength_nm": [400, 600, 500]}, "wavelength_nm[2]: must be > 600 nm"),
    "doubled": ({"wavelength_nm": [400, 400, 500]}, "wavelength_nm[1]: must be > 400 nm"),
    "nan": ({"values": [0, math.nan, 0]}, "values[1]: must be finite (got NaN)"),
    "one-sample": ({"wavelength_nm": [500], "values": [1]}, "wavelength_nm: must have ≥ 2"),
    "invisible": ({"wavelength_nm": [900, 950, 1000]}, "must reach into the visible 360 … 830 nm"),
    "kind": ({"kind": "glow"}, 'kind: must be one of emission, reflectance (got "glow")'),
    "observer": ({"observer": "cie2015"}, "observer: must be one of cie1931, cie1964"),
    "light": ({"kind": "reflectance", "illuminant": "F99"}, "illuminant: must be one of"),
    "light-of-emission": ({"illuminant": "D65"}, "illuminant: belongs to kind reflectance"),
    "unknown-key": ({"wavelength": [1]}, "wavelength: is not known here"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_record(nacre, name):
    change, message = BAD[name]
    assert message in nacre.fails("eval", "spectrum", stdin=json.dumps({**RAMP, **change}))


@pytest.mark.parametrize(
    ("record", "message"),
    [
        ({"blackbody_K": 10}, "blackbody_K: must be in [100, 1000000] (got 10)"),
        ({"daylight_K": 3000}, "daylight_K: must be in [4000, 25000] (got 3000)"),
        ({"illuminant": "D66"}, "illuminant: must be one of"),
        ({"illuminant": 65}, "illuminant: "),
        ({"illuminant": "line:546@-1"}, "illuminant: must have lines of a finite power > 0"),
        ({"illuminant": "blackbody:1"}, "illuminant: must be within 100 … 1000000 K (got 1)"),
        ({"illuminant": "A", "space": "x"}, "space: is not known here"),
        ({}, "wavelength_nm: is missing"),
    ],
)
def test_bad_source(nacre, record, message):
    assert message in nacre.fails("eval", "spectrum", stdin=json.dumps(record))


def test_unknown_space_lists_the_known_ones(nacre):
    errors = nacre.fails("eval", "spectrum", "--space", "srgb", stdin=json.dumps(RAMP))
    assert "lin_rec709_scene" in errors
    assert "srgb" in errors


@pytest.mark.parametrize(("option", "how"), [("bradford", "Bradford"), ("cat16", "CAT16")])
def test_white_is_adapted_as_asked(nacre, option, how):
    light = {"illuminant": "A"}
    chip = {"wavelength_nm": GRID.tolist(), "values": rough(7, 471), "kind": "reflectance"}
    batch = json.dumps([light, chip | light])
    white, answer = json.loads(nacre.ok("eval", "spectrum", "--cat", option, stdin=batch))
    matrix = colour.adaptation.matrix_chromatic_adaptation_VonKries(
        np.array(white["XYZ"]), colour.xy_to_XYZ([0.3127, 0.3290]), how
    )
    rgb_to_xyz = colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_RGB_to_XYZ
    expected = np.linalg.solve(rgb_to_xyz, matrix @ answer["XYZ"])
    np.testing.assert_allclose(answer["rgb"], expected, rtol=0, atol=1e-4)  # theirs: four digits


def test_a_line_lights_a_reflectance_that_is_not_adapted(nacre):
    record = json.dumps(
        {
            "wavelength_nm": [400, 700],
            "values": [0.5, 0.5],
            "kind": "reflectance",
            "illuminant": "line:589.3",
        }
    )
    assert "can be adapted" in nacre.fails("eval", "spectrum", stdin=record)
    answer = json.loads(nacre.ok("eval", "spectrum", "--cat", "none", stdin=record))
    assert answer["XYZ"][1] == pytest.approx(0.5, abs=1e-12)
    assert answer["rgb"][0] > answer["rgb"][1] > 0 > answer["rgb"][2]


def test_colours_are_brought_into_the_gamut(nacre):
    green = json.dumps({"illuminant": "line:520"})

    def rgb(mapping):
        output = nacre.ok("eval", "spectrum", "--gamut", mapping, stdin=green)
        return np.array(json.loads(output)["rgb"])

    kept = rgb("keep")
    assert kept.min() < 0
    np.testing.assert_array_equal(rgb("clip"), kept.clip(0, 1))
    scaled = (kept / kept.max()).clip(0, 1)
    np.testing.assert_allclose(rgb("scale"), scaled, rtol=0, atol=1e-15)
    assert rgb("desaturate").min() == 0
    assert 1 < rgb("desaturate").max() < kept.max()  # a light, of Y = 1


def test_bright_lights_keep_their_colour(nacre):
    """Of Y = 1: a bulb is inside the gamut; of sodium the way to white, straight in xy, is gone as far
    as the edge from red to green."""
    bulb, sodium = (
        nacre.evaluate("spectrum", [{"illuminant": key}], "--gamut", "keep")[0]
        for key in ("A", "lamp/lps")
    )
    mapped_bulb, mapped = nacre.evaluate(
        "spectrum", [{"illuminant": "A"}, {"illuminant": "lamp/lps"}], "--gamut", "desaturate"
    )
    assert mapped_bulb["rgb"] == bulb["rgb"]
    assert min(sodium["rgb"]) < 0
    rec709 = colour.RGB_COLOURSPACES["sRGB"]
    red, green, _ = rec709.primaries
    white, line = rec709.whitepoint, np.array(sodium["xy"])
    along, _ = np.linalg.solve(np.stack([line - white, red - green], axis=1), red - white)
    xyz = colour.xy_to_XYZ(white + along * (line - white))
    expected = np.linalg.solve(rec709.matrix_RGB_to_XYZ, xyz)
    np.testing.assert_allclose(mapped["rgb"], expected, rtol=0, atol=2e-3)  # theirs: four digits
    assert mapped["rgb"][2] == pytest.approx(0.0, abs=1e-12)


def test_gamut_needs_an_rgb_space(nacre):
    errors = nacre.fails(
        *("eval", "spectrum", "--space", "xyz_d65", "--gamut", "clip"),
        stdin=json.dumps({"illuminant": "A"}),
    )
    assert "--gamut: must be keep in a space that is not RGB" in errors


def test_spectra_of_the_library_by_name(nacre):
    chart = colour.SDS_COLOURCHECKERS["ColorChecker N Ohta"]["dark skin"]
    patch, under_a, lamp, inline = nacre.evaluate(
        "spectrum",
        [
            {"spectrum": "colorchecker/dark-skin"},
            {"spectrum": "colorchecker/dark-skin", "illuminant": "A", "observer": "cie1964"},
            {"spectrum": "lamp/hps"},
            {
                "wavelength_nm": chart.wavelengths.tolist(),
                "values": chart.values.tolist(),
                "kind": "reflectance",
            },
        ],
    )
    assert patch["XYZ"] == pytest.approx(inline["XYZ"], rel=1e-12)
    assert under_a["XYZ"][0] > patch["XYZ"][0]
    assert 1900 < lamp["cct_K"] < 2200


def test_any_spectrum_is_a_light_or_a_material(nacre):
    """Under a light as narrow as itself a box is white; twice as bright, or a peak of 117 brought down."""
    box, dim, lit, daylight, patch = nacre.evaluate(
        "spectrum",
        [
            {"spectrum": "study/box", "kind": "reflectance", "illuminant": "study/box"},
            {"spectrum": "study/box", "kind": "reflectance", "scale": 0.5, "illuminant": "lamp/hps"},
            {"wavelength_nm": [360, 449, 450, 650, 651, 830], "values": [0, 0, 0.5, 0.5, 0, 0],
             "kind": "reflectance", "illuminant": "lamp/hps"},
            {"spectrum": "study/daylight", "kind": "reflectance", "scale": 0.005},
            {"spectrum": "study/gold", "kind": "emission", "scale": 3},
        ],
    )  # fmt: skip
    assert box["rgb"] == pytest.approx([1, 1, 1], abs=1e-12)
    assert dim["XYZ"] == pytest.approx(lit["XYZ"], rel=1e-12)
    assert 0.3 < daylight["XYZ"][1] < 0.6
    plain, gold = nacre.evaluate(
        "spectrum",
        [{"spectrum": "study/gold", "kind": "emission"}, {"spectrum": "study/gold", "illuminant": "E"}],
    )  # fmt: skip
    assert patch["XYZ"] == pytest.approx([3 * value for value in plain["XYZ"]], rel=1e-12)
    assert plain["XYZ"] == pytest.approx(gold["XYZ"], rel=1e-12)


@pytest.mark.parametrize(
    ("record", "message"),
    [
        (
            {"spectrum": "study/daylight", "kind": "reflectance"},
            "[0].spectrum: study/daylight: a reflectance must be in [0, 2], 1 for all of the light (got",
        ),
        ({"spectrum": "study/box", "kind": "object"}, "[0].kind: must be"),
        ({"spectrum": "study/box", "kind": "reflectance", "scale": 0}, "[0].scale: must be > 0"),
        ({"spectrum": "colorchecker/dark"}, "[0].spectrum: must be a key of the library"),
        ({"spectrum": 3}, "[0].spectrum: must be"),
        ({"spectrum": "lamp/hps", "illuminant": "A"}, "an emission is its own light"),
        ({"spectrum": "lamp/hps", "values": [1]}, "[0].values: is not known here"),
        ({"illuminant": "study/gold"}, "[0].illuminant: must be a light"),
    ],
)
def test_wrong_names_of_spectra(nacre, record, message):
    assert message in nacre.fails("eval", "spectrum", stdin=json.dumps([record]))


def test_a_null_character_does_not_end_a_batch(nacre):
    errors = nacre.fails("eval", "spectrum", stdin='[{"illuminant": "A"}]\n\0 and more')
    assert "-:2: not valid JSON: a null character" in errors
