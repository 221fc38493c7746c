# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre eval stack` against closed forms and against the tmm package (Byrnes 2016)."""

from __future__ import annotations

import json
import math
import random

import pytest
import tmm

GLASS = {"n": [[1, 0], [1.5, 0]], "d_nm": [], "angle_deg": 0, "wavelength_nm": 550, "pol": "s"}


def stack(name, n, d_nm, angle_deg=0.0, wavelength_nm=550.0, pol="s", coherence=None):
    record = {
        "n": [[complex(value).real, complex(value).imag] for value in n],
        "d_nm": list(d_nm),
        "angle_deg": angle_deg,
        "wavelength_nm": wavelength_nm,
        "pol": pol,
    }
    if coherence:
        record["coherence"] = coherence
    return pytest.param(record, id=name)


def both(name, *arguments, **options):
    return [stack(f"{name}-{pol}", *arguments, **options, pol=pol) for pol in "sp"]


def random_layers(count, seed, absorbing):
    random_number = random.Random(seed)
    n = [random_number.uniform(1.2, 2.6) for _ in range(count)]
    k = [random_number.uniform(0.0, 0.05) if absorbing else 0.0 for _ in range(count)]
    d_nm = [random_number.uniform(20.0, 300.0) for _ in range(count)]
    return [complex(*pair) for pair in zip(n, k, strict=True)], d_nm


DIELECTRIC_40, THICKNESS_40 = random_layers(40, 1, absorbing=False)
ABSORBING_12, THICKNESS_12 = random_layers(12, 2, absorbing=True)
MIRROR = [2.4 if i % 2 == 0 else 1.46 for i in range(15)]
MIRROR_NM = [550 / 4 / n for n in MIRROR]

COHERENT = [
    *both("bare-glass", [1, 1.5], []),
    *both("bare-glass-brewster", [1, 1.5], [], math.degrees(math.atan(1.5))),
    *both("soap-film", [1, 1.33, 1], [380], 45.0),
    *both("quarter-wave", [1, 1.38, 1.52], [550 / 4 / 1.38]),
    *both("zero-thickness", [1, 2.4, 1.33, 1.5], [0, 0], 30.0),
    *both("gold", [1, 0.42 + 2.35j], [], 60.0),
    *both("oxide-on-iron", [1, 2.36 + 0.1j, 2.9 + 3.1j], [45], 20.0),
    *both("silver-40nm-glass", [1, 0.06 + 3.6j, 1.52], [40], 70.0),
    *both("total-reflection", [1.5, 1.0], [], 60.0),
    *both("frustrated", [1.5, 1.0, 1.5], [200], 60.0),
    *both("past-critical-in-the-middle", [1.5, 1.38, 1.0], [150], 50.0),
    *both("grazing-89.9", [1, 1.33, 1.5], [500], 89.9),
    *both("grazing-metal", [1, 1.45, 0.2 + 3.4j], [100], 89.9),
    *both("mirror-15", [1, *MIRROR, 1.52], MIRROR_NM, 35.0),
    *both("40-layers", [1, *DIELECTRIC_40, 1.5], THICKNESS_40, 25.0, 633.0),
    *both("12-absorbing", [1, *ABSORBING_12, 1.5], THICKNESS_12, 50.0, 450.0),
    *both("ink", [1, 3.1 + 3.3j, 1.38, 1.0 + 6.6j], [8, 380], 10.0, 600.0),
]


@pytest.mark.parametrize("record", COHERENT)
def test_coherent_stacks_agree_with_tmm(nacre, record):
    n = [complex(*pair) for pair in record["n"]]
    expected = tmm.coh_tmm(
        record["pol"],
        n,
        [math.inf, *record["d_nm"], math.inf],
        math.radians(record["angle_deg"]),
        record["wavelength_nm"],
    )
    answer = nacre.evaluate("stack", record)
    assert answer["R"] == pytest.approx(expected["R"], abs=1e-12)
    assert answer["T"] == pytest.approx(expected["T"], abs=1e-12)
    assert answer["A"] == pytest.approx(1 - expected["R"] - expected["T"], abs=1e-12)
    assert abs(complex(*answer["r"]) - expected["r"]) <= 1e-12
    assert abs(complex(*answer["t"]) - expected["t"]) <= 1e-12 * max(1, abs(expected["t"]))


INCOHERENT = [
    *both("window", [1, 1.52, 1], [1e6], 40.0, coherence=["i"]),
    *both("coated-window", [1, 1.38, 1.52, 1], [100, 1e6], 30.0, coherence=["c", "i"]),
    *both("two-panes", [1, 1.52, 1, 1.52, 1], [3e6, 1e7, 3e6], 55.0, coherence=["i", "i", "i"]),
    *both("weakly-absorbing", [1, 2.0, 1.52 + 1e-6j, 1], [80, 1e5], 20.0, coherence=["c", "i"]),
]


@pytest.mark.parametrize("record", INCOHERENT)
def test_incoherent_stacks_agree_with_tmm(nacre, record):
    expected = tmm.inc_tmm(
        record["pol"],
        [complex(*pair) for pair in record["n"]],
        [math.inf, *record["d_nm"], math.inf],
        ["i", *record["coherence"], "i"],
        math.radians(record["angle_deg"]),
        record["wavelength_nm"],
    )
    answer = nacre.evaluate("stack", record)
    assert answer["R"] == pytest.approx(expected["R"], abs=1e-12)
    assert answer["T"] == pytest.approx(expected["T"], abs=1e-12)
    assert answer["r"] is None
    assert answer["t"] is None


def test_coherence_may_list_the_outer_media_as_tmm_does(nacre):
    record = INCOHERENT[2].values[0]
    with_ends = {**record, "coherence": ["i", *record["coherence"], "i"]}
    first, second = nacre.evaluate("stack", [record, with_ends])
    assert first == second


FILM = {**GLASS, "n": [1, 1.33, [1.5, 0.1], 1.5], "d_nm": [3000, 200], "angle_deg": 30}


def test_spread_and_bandwidth_are_averages(nacre):
    """The spread of 9 nm against a sum over thicknesses; the bandwidth of the same effect."""
    x = [0.02 * i for i in range(-400, 401)]
    batch = [{**FILM, "d_nm": [3000 + 9 * each, 200]} for each in x]
    weights = [0.02 * math.exp(-each * each / 2) / math.sqrt(2 * math.pi) for each in x]
    expected = sum(
        w * one["R"] for w, one in zip(weights, nacre.evaluate("stack", batch), strict=True)
    )
    fwhm = 9 / 3000 * FILM["wavelength_nm"] * 2 * math.sqrt(2 * math.log(2))
    spread, band = nacre.evaluate(
        "stack",
        [{**FILM, "spread_nm": [9, 0]}, {**FILM, "d_nm": [3000, 0], "bandwidth_nm": fwhm}],
    )
    assert spread["R"] == pytest.approx(expected, abs=1e-12)
    assert spread["r"] is None
    alike = nacre.evaluate("stack", {**FILM, "d_nm": [3000, 0], "spread_nm": [9, 0]})
    assert band["R"] == pytest.approx(alike["R"], abs=1e-14)


def test_layers_say_what_they_absorb(nacre):
    plain, s, p, u = nacre.evaluate(
        "stack", [FILM, *({**FILM, "pol": pol, "layers": True} for pol in "spu")]
    )
    assert "A_layers" not in plain
    assert s["A_layers"] == pytest.approx([0, s["A"]], abs=1e-14)
    assert u["A_layers"][1] == pytest.approx((s["A_layers"][1] + p["A_layers"][1]) / 2, abs=1e-15)


def test_fifty_micrometres_of_metal_reflect_like_the_bulk_and_pass_nothing(nacre):
    metal = [0.2, 3.4]
    thick = {**GLASS, "n": [[1, 0], metal, [1.5, 0]], "d_nm": [50_000], "angle_deg": 45, "pol": "p"}
    bulk = {**thick, "n": [[1, 0], metal], "d_nm": []}
    thick_answer, bulk_answer = nacre.evaluate("stack", [thick, bulk])
    assert thick_answer["R"] == pytest.approx(bulk_answer["R"], abs=1e-15)
    assert 0.0 <= thick_answer["T"] < 1e-100


def test_bare_glass_by_hand(nacre):
    answer = nacre.evaluate("stack", GLASS)
    assert answer["R"] == pytest.approx(0.04, abs=1e-15)  # ((1 - 1.5) / (1 + 1.5))²
    assert answer["T"] == pytest.approx(0.96, abs=1e-15)
    assert answer["r"] == pytest.approx([-0.2, 0.0], abs=1e-15)
    assert answer["t"] == pytest.approx([0.8, 0.0], abs=1e-15)
    assert list(answer) == ["R", "T", "A", "r", "t"]


def test_a_plain_number_is_a_clear_medium(nacre):
    plain, paired = nacre.evaluate("stack", [{**GLASS, "n": [1, 1.5]}, GLASS])
    assert plain == paired


def test_p_amplitude_has_the_opposite_sign_at_normal_incidence(nacre):
    assert nacre.evaluate("stack", {**GLASS, "pol": "p"})["r"] == pytest.approx([0.2, 0.0])


def test_unpolarised_is_the_mean_of_s_and_p(nacre):
    film = {**GLASS, "n": [[1, 0], [2.1, 0.02], [1.5, 0]], "d_nm": [240], "angle_deg": 65}
    s, p, u = nacre.evaluate("stack", [{**film, "pol": pol} for pol in "spu"])
    for key in "RTA":
        assert u[key] == pytest.approx((s[key] + p[key]) / 2, abs=1e-15)
    assert u["r"] is None
    assert u["t"] is None


def test_numbers_survive_the_round_trip(nacre):
    text = nacre.ok("eval", "stack", stdin=json.dumps(COHERENT[12].values[0]))
    value = json.loads(text)["R"]
    assert repr(value) in text or json.dumps(value) in text


def test_batch_keeps_its_order_and_answers_beside_errors(nacre):
    bad = {**GLASS, "angle_deg": 90}
    result = nacre("eval", "stack", stdin=json.dumps([GLASS, bad, {**GLASS, "pol": "p"}]))
    assert result.returncode == 1
    first, second, third = json.loads(result.stdout)
    assert first["R"] == pytest.approx(0.04)
    assert second == {"error": "angle_deg: must be in [0, 90) (got 90)"}
    assert third["r"][0] > 0
    assert "nacre eval stack: -:1: [1].angle_deg: must be in [0, 90) (got 90)" in result.stderr


def test_file_in_file_out(nacre, tmp_path):
    source, target = tmp_path / "in.json", tmp_path / "out.json"
    source.write_text(json.dumps([GLASS] * 3))
    assert nacre.ok("eval", "stack", source, "-o", target) == ""
    assert len(json.loads(target.read_text())) == 3


def test_empty_batch(nacre):
    assert nacre.evaluate("stack", []) == []


def test_sixty_four_layers_are_allowed(nacre):
    record = {**GLASS, "n": [[1, 0], *[[1.4, 0]] * 64, [1.5, 0]], "d_nm": [10] * 64}
    assert 0 < nacre.evaluate("stack", record)["R"] < 1


BAD = {
    "negative-thickness": (
        {"n": [[1, 0], [1.3, 0], [1.5, 0]], "d_nm": [-5]},
        "d_nm[0]: must be ≥ 0 (got -5)",
    ),
    "nan-thickness": (
        {"n": [[1, 0], [1.3, 0], [1.5, 0]], "d_nm": [math.nan]},
        "d_nm[0]: must be ≥ 0 (got NaN)",
    ),
    "infinite-thickness": (
        {"n": [[1, 0], [1.3, 0], [1.5, 0]], "d_nm": [math.inf]},
        "d_nm[0]: must be ≥ 0 (got Infinity)",
    ),
    "text-thickness": (
        {"n": [[1, 0], [1.3, 0], [1.5, 0]], "d_nm": ["5"]},
        'd_nm[0]: must be a number ≥ 0 (got "5")',
    ),
    "thickness-missing": ({"n": [[1, 0], [1.3, 0], [1.5, 0]]}, "d_nm: must have one thickness"),
    "zero-index": ({"n": [[1, 0], [0, 1]]}, "n[1][0]: must be > 0 (got 0)"),
    "negative-index": ({"n": [[-1, 0], [1.5, 0]]}, "n[0][0]: must be > 0 (got -1)"),
    "gain": ({"n": [[1, 0], [1.5, -0.1]]}, "n[1][1]: must be ≥ 0 (got -0.1)"),
    "absorbing-ambient": ({"n": [[1, 0.1], [1.5, 0]]}, "n[0][1]: must be 0 in the ambient"),
    "not-a-pair": ({"n": [[1, 0], "1.5"]}, 'n[1]: must be [n, k] (got "1.5")'),
    "one-medium": ({"n": [[1, 0]]}, "n: must list 2 … 66 indices"),
    "65-layers": ({"n": [[1, 0]] * 67, "d_nm": [1] * 65}, "at most 64 layers (got 67)"),
    "angle-90": ({"angle_deg": 90}, "angle_deg: must be in [0, 90) (got 90)"),
    "angle-negative": ({"angle_deg": -1}, "angle_deg: must be in [0, 90) (got -1)"),
    "angle-nan": ({"angle_deg": math.nan}, "angle_deg: must be in [0, 90) (got NaN)"),
    "wavelength-zero": ({"wavelength_nm": 0}, "wavelength_nm: must be > 0 (got 0)"),
    "polarisation": ({"pol": "x"}, 'pol: must be one of s, p, u (got "x")'),
    "unknown-key": ({"thickness": [1]}, "thickness: is not known here; the keys are n, d_nm,"),
    "coherence-length": ({"coherence": ["c"]}, "coherence: must have one of c, i for each"),
    "coherence-word": (
        {"n": [[1, 0], [1.3, 0], [1.5, 0]], "d_nm": [5], "coherence": ["x"]},
        'coherence[0]: must be c or i (got "x")',
    ),
    "spread-length": ({"spread_nm": [1]}, "spread_nm: must have one value for each of the 0"),
    "spread-negative": (
        {"n": [1, 1.3, 1.5], "d_nm": [5], "spread_nm": [-2]},
        "spread_nm[0]: must be ≥ 0 (got -2)",
    ),
    "spread-incoherent": (
        {"n": [1, 1.3, 1.5], "d_nm": [5], "spread_nm": [2], "coherence": ["i"]},
        "spread_nm[0]: must be 0 in a layer that is incoherent (got 2)",
    ),
    "bandwidth": ({"bandwidth_nm": -1}, "bandwidth_nm: must be ≥ 0 (got -1)"),
    "layers-word": ({"layers": "yes"}, 'layers: must be true or false (got "yes")'),
    "layers-of-averages": (
        {"n": [1, 1.3, 1.5], "d_nm": [5], "layers": True, "bandwidth_nm": 2},
        "layers: must be false where layers have a spread or light a bandwidth",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_record_names_field_value_and_what_is_allowed(nacre, name):
    change, message = BAD[name]
    result = nacre("eval", "stack", stdin=json.dumps({**GLASS, **change}))
    assert result.returncode == 1
    assert message in json.loads(result.stdout)["error"]
    assert message in result.stderr


def test_all_problems_of_a_record_come_at_once(nacre):
    record = {**GLASS, "angle_deg": 95, "wavelength_nm": -1, "pol": "q"}
    errors = nacre.fails("eval", "stack", stdin=json.dumps(record)).splitlines()
    assert len(errors) == 3


@pytest.mark.parametrize("key", ["n", "d_nm", "wavelength_nm"])
def test_missing_key(nacre, key):
    record = {name: value for name, value in GLASS.items() if name != key}
    assert f"{key}: is missing" in nacre.fails("eval", "stack", stdin=json.dumps(record))


ONE_FILM = {"n": [1, 2.2, [2.9, 3.1]], "d_nm": [90], "wavelength_nm": 480}
ASK_FOR_LIGHT = {
    "stack": ONE_FILM,
    "film": {**ONE_FILM, "model": "opaque_base"},
    "colour": {"n": ONE_FILM["n"], "d_nm": ONE_FILM["d_nm"]},
}


@pytest.mark.parametrize("kind", ASK_FOR_LIGHT)
def test_light_is_unpolarised_and_comes_straight_on_where_nothing_else_is_said(nacre, kind):
    record = ASK_FOR_LIGHT[kind]
    both, angle_only, pol_only, neither, other = nacre.evaluate(
        kind,
        [
            {**record, "angle_deg": 0, "pol": "u"},
            {**record, "angle_deg": 50},
            {**record, "pol": "p"},
            record,
            {**record, "angle_deg": 50, "pol": "u"},
        ],
    )
    assert neither == both
    assert angle_only == other != both
    assert pol_only == nacre.evaluate(kind, {**record, "angle_deg": 0, "pol": "p"})


BAD_TEXT = {
    "truncated": ('[{"n": [[1,0],\n [1.5', ":2:"),
    "empty": ("", ":1:"),
    "not-an-object": ("3", "must be one record"),
    "deep": ("[" * 1000, "nested deeper than 64 levels"),
    "trailing": ("{} {}", "not valid JSON"),
}


@pytest.mark.parametrize("name", BAD_TEXT)
def test_bad_text_is_one_error_and_no_answer(nacre, name):
    text, message = BAD_TEXT[name]
    result = nacre("eval", "stack", stdin=text)
    assert result.returncode == 1
    assert result.stdout == ""
    assert message in result.stderr


# What a parser of JSON passes over, or ends at, is an error of its own record.
BAD_RECORDS = {
    '{"pol": "s", "pol": "p"}': "pol: must be there once only",
    '{"angle_deg": 1e999}': "angle_deg: must be in [0, 90) (got 1e999)",
    '{"d_nm": [1, -1e+9999]}': "d_nm[1]: must be ≥ 0 (got -1e+9999)",
    '{"wavelength_nm": ' + "9" * 400 + "}": "must be > 0 (got " + "9" * 40 + "...)",
    "1e999": "must be an object (got 1e999)",
}


@pytest.mark.parametrize("record", BAD_RECORDS, ids=lambda record: record[:20])
def test_a_bad_record_ends_no_batch(nacre, record):
    result = nacre("eval", "stack", stdin=f"[{json.dumps(GLASS)}, {record}, {json.dumps(GLASS)}]")
    assert result.returncode == 1
    good, bad, after = json.loads(result.stdout)
    assert good == after
    assert set(good) > {"R", "T"}
    assert BAD_RECORDS[record] in bad["error"]


def test_errors_name_the_line_of_their_record(nacre, tmp_path):
    path = tmp_path / "batch.json"
    records = [json.dumps(record) for record in (GLASS, GLASS, {**GLASS, "wavelength_nm": -3})]
    path.write_text("[\n" + ",\n".join(records) + "\n]\n")
    assert f"{path}:4: [2].wavelength_nm: must be > 0 (got -3)" in nacre.fails(
        "eval", "stack", path
    )
