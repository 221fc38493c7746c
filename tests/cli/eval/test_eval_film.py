# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre eval film` and `eval slits`: closed forms beside the multilayer."""

from __future__ import annotations

import itertools
import json
import math

import pytest

from support.paths import ROOT

SOAP = {"n": [1, 1.33, 1], "d_nm": [400], "angle_deg": 30, "wavelength_nm": 550, "pol": "s"}
OIL = {**SOAP, "n": [1, 1.47, 1.33]}
TEMPER = {**SOAP, "n": [1, 2.2, [2.9, 3.1]], "d_nm": [60]}
EXACT = {
    "airy": (SOAP, OIL),
    "opaque_base": (SOAP, OIL, TEMPER),
    "free_film": (SOAP,),
    "etalon": (SOAP,),
    "recursion": (
        SOAP,
        TEMPER,
        {**SOAP, "n": [1, [0.2, 3.3], 1.46, [2.4, 0.01], 1.5], "d_nm": [12, 250, 1e5]},
        {**SOAP, "n": [1.5, 1, 1.5], "d_nm": [120]},
        {**SOAP, "n": [1, 1.5], "d_nm": []},
    ),
}


@pytest.mark.parametrize(
    ("model", "film"), [(model, film) for model, films in EXACT.items() for film in films]
)
def test_exact_forms_agree_with_the_stack(nacre, model, film):
    batch = [
        {**film, "angle_deg": angle, "pol": pol}
        for angle, pol in itertools.product((0, 45, 89), "spu")
    ]
    stacks = nacre.evaluate("stack", batch)
    answers = nacre.evaluate("film", [{"model": model, **record} for record in batch])
    for record, stack, answer in zip(batch, stacks, answers, strict=True):
        assert answer["R"] == pytest.approx(stack["R"], abs=1e-12)
        assert answer["exact"] == stack["R"] or record["pol"] == "u"
        assert answer["error"] == pytest.approx(answer["R"] - answer["exact"], abs=1e-16)


def test_the_cut_series_states_its_error(nacre):
    dense = {**SOAP, "model": "series", "n": [1, 2.4, 3.5], "d_nm": [115], "angle_deg": 0}
    answer = nacre.evaluate("film", dense)
    assert 1e-4 < abs(answer["error"]) < 1e-3
    assert abs(nacre.evaluate("film", {**SOAP, "model": "series"})["error"]) < 1e-4


def table_of_the_page(first_cell: str) -> list[list[str]]:
    text = (ROOT / "cpp_tools/doc/models.md").read_text(encoding="utf-8")
    rows = text[text.index(f"| {first_cell} |") :].split("\n\n")[0].splitlines()
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in rows]


SERIES_FILMS = ([1, 1.33, 1], [1, 1.47, 1.33], [1, 2.4, 1.5], [1, 2.4, 3.5])


@pytest.mark.parametrize("row", range(4))
def test_the_page_states_the_error_of_the_series(nacre, row):
    (_, *angles), _, *rows = table_of_the_page("film")
    for angle, stated in zip(angles, rows[row][1:], strict=True):
        batch = [
            {
                **SOAP,
                "model": "series",
                "n": SERIES_FILMS[row],
                "d_nm": [d_nm],
                "angle_deg": int(angle.rstrip("°")),
                "pol": pol,
            }
            for d_nm in range(0, 1001, 3)
            for pol in "sp"
        ]
        worst = max(abs(answer["error"]) for answer in nacre.evaluate("film", batch))
        assert worst == pytest.approx(float(stated), rel=0.05)


def test_the_page_states_how_far_apart_the_bands_are(nacre):
    """The thickness at which the bands start anew, over that of a whole round trip of phase."""
    _, _, *rows = table_of_the_page("angle")
    batch = []
    for angle, *factors in rows:
        for n, factor in zip((1.33, 1.47, 2.4), factors, strict=True):
            degrees = int(angle.rstrip("°"))
            cos_film = math.sqrt(1 - (math.sin(math.radians(degrees)) / n) ** 2)
            period = 550 / (2 * n * cos_film) * float(factor)  # 0.0005 off at most
            record = {
                "model": "path_difference",
                "wavelength_nm": 550,
                "n": [1, n, 1],
                "angle_deg": degrees,
                "view_angle_deg": degrees,
            }
            batch += [{**record, "d_nm": [period * share]} for share in (0.999, 1.001)]
    bands = [answer["bands"] for answer in nacre.evaluate("film", batch)]
    assert min(bands[0::2]) > 0.99
    assert max(bands[1::2]) < 0.01


def test_an_etalon_with_given_mirrors(nacre):
    record = {**SOAP, "model": "etalon", "mirror_reflectance": 0.9}
    answer = nacre.evaluate("film", record)
    cos_film = math.sqrt(1 - (math.sin(math.radians(30)) / 1.33) ** 2)
    half = 2 * math.pi * 1.33 * 400 * cos_film / 550
    assert answer["R"] == pytest.approx(
        1 - 1 / (1 + 4 * 0.9 / 0.01 * math.sin(half) ** 2), abs=1e-12
    )
    assert answer["exact"] is None
    assert answer["error"] is None


def test_bands_of_the_path_difference(nacre):
    record = {key: SOAP[key] for key in ("n", "d_nm", "angle_deg", "wavelength_nm")}
    record |= {"model": "path_difference", "view_angle_deg": 60}
    answer = nacre.evaluate("film", record)
    inside = [math.sqrt(1 - (math.sin(math.radians(a)) / 1.33) ** 2) for a in (30, 60)]
    assert answer == {
        "bands": pytest.approx(2 * 1.33 * 400 * math.prod(inside) / 550 % 1, abs=1e-12)
    }


@pytest.mark.parametrize("pol", ["s", "p"])
def test_uv_is_the_bare_interface(nacre, pol):
    record = {**SOAP, "n": [1, [2.9, 3.1]], "d_nm": [], "angle_deg": 70, "pol": pol}
    stack = nacre.evaluate("stack", record)
    answer = nacre.evaluate("film", {"model": "uv", **record})
    assert answer["R"] == pytest.approx(stack["R"], abs=1e-14)
    assert answer[f"r_{pol}"] == pytest.approx(stack["r"], abs=1e-14)


def test_slits(nacre):
    record = {"width_nm": 2000, "angle_deg": 10, "wavelength_nm": 500}
    x = math.pi * 2000 * math.sin(math.radians(10)) / 500
    single = (math.sin(x) / x) ** 2
    assert nacre.evaluate("slits", record)["intensity"] == pytest.approx(single, abs=1e-15)
    double = single * math.cos(3 * x) ** 2
    answer = nacre.evaluate("slits", {**record, "spacing_nm": 6000})
    assert answer["intensity"] == pytest.approx(double, abs=1e-14)


WRONG = {
    "model": ({"model": "magic"}, "model: must be"),
    "absorbing-film": ({"n": [1, [2, 0.1], 1]}, "n[1]: must have k = 0"),
    "absorbing-base": ({"n": [1, 2, [2, 1]]}, "n[2]: must have k = 0"),
    "two-layers": ({"d_nm": [1, 2]}, "d_nm: must have one thickness"),
    "no-film": ({"n": [1, 2], "d_nm": []}, "n: must list ambient, film and base"),
    "total-reflection": ({"n": [1.5, 1, 1.5], "angle_deg": 60}, "critical angle of the film"),
    "negative": ({"d_nm": [-1]}, "d_nm[0]: must be ≥ 0 (got -1)"),
    "angle": ({"angle_deg": 90}, "angle_deg: must be in [0, 90)"),
    "mirror": ({"mirror_reflectance": 0.5}, "mirror_reflectance: is not known here"),
    "not-free": ({"model": "free_film", "n": [1, 1.33, 1.5]}, "n[2]: must equal n[0]"),
    "perfect-mirror": (
        {"model": "etalon", "mirror_reflectance": 1},
        "mirror_reflectance: must be in [0, 1)",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_bad_record(nacre, name):
    change, message = WRONG[name]
    record = {"model": "airy", **SOAP, **change}
    assert message in nacre.fails("eval", "film", stdin=json.dumps(record))


def test_slits_are_seen_straight_ahead_where_no_angle_is_given(nacre):
    assert nacre.evaluate("slits", {"width_nm": 1000, "wavelength_nm": 550})["intensity"] == 1.0


def test_bad_slits(nacre):
    record = {"width_nm": 2000, "spacing_nm": 10, "angle_deg": 10, "wavelength_nm": 500}
    message = nacre.fails("eval", "slits", stdin=json.dumps(record))
    assert "spacing_nm: must be 0 for one slit, or at least the width" in message
