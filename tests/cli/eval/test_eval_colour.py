# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre eval colour` and --sampling: colours of stacks from few wavelengths, and what that costs."""

from __future__ import annotations

import itertools
import json

import numpy as np
import pytest

from support.paths import ROOT

SOAP = {"n": [1, "water/Daimon-20C", 1], "d_nm": [400], "angle_deg": 30}


def etalon(line_nm: float, pairs: int, half_waves: int, angle_deg: float) -> dict:
    """Two mirrors (HL)^pairs H around some half-waves of L: at 0 degrees it passes `line_nm`."""
    high, low = 2.35, 1.46
    quarter = {n: line_nm / 4 / n for n in (high, low)}
    mirror = [high, low] * pairs + [high]
    films = [*mirror, low, *mirror]
    d_nm = [quarter[n] for n in films]
    d_nm[len(mirror)] *= 2 * half_waves
    return {"n": [1, *films, "N-BK7/SCHOTT"], "d_nm": d_nm, "angle_deg": angle_deg}


LINES_NM = (430, 470, 510, 550, 590, 630, 670)
STUDIES = {
    "soap film, 50 … 1500 nm": [
        {**SOAP, "d_nm": [d_nm], "angle_deg": angle}
        for d_nm, angle in itertools.product(range(50, 1501, 50), (0, 30, 60, 80))
    ],
    "soap film, 10 µm": [{**SOAP, "d_nm": [10000], "angle_deg": angle} for angle in (0, 30, 60)],
    "oxide on iron, 0 … 400 nm": [
        {"n": [1, "Fe3O4/Querry", "Fe/Johnson"], "d_nm": [d_nm], "angle_deg": angle}
        for d_nm, angle in itertools.product(range(0, 401, 40), (0, 30, 60))
    ],
    "etalon, line of 7 nm": [
        etalon(*of) for of in itertools.product(LINES_NM, (2,), (3,), (0, 30))
    ],
    "etalon, line of 2 nm": [
        etalon(*of) for of in itertools.product(LINES_NM, (4,), (1,), (0, 30))
    ],
    "etalon, line of 0.7 nm": [
        etalon(*of) for of in itertools.product(LINES_NM, (5,), (1,), (0, 30))
    ],
}
SAMPLINGS = ("adaptive", "full", "steps:8", "steps:32", "hierarchical:3", "hierarchical:6")


def rgb(answers) -> np.ndarray:
    return np.array(
        [[a[part]["rgb"] for part in ("reflectance", "transmittance")] for a in answers]
    )


def row(nacre, study: str) -> list[str]:
    """Cells of the table of sampling.md: wavelengths in the mean, and the largest error."""
    records = STUDIES[study]
    truth = rgb(nacre.evaluate("colour", records, "--sampling", "reference"))
    cells = []
    for sampling in SAMPLINGS:
        answers = nacre.evaluate("colour", records, "--sampling", sampling)
        wavelengths = np.mean([answer["wavelengths"] for answer in answers])
        cells.append(f"{wavelengths:.1f}")
        cells.append(f"{np.max(np.abs(rgb(answers) - truth)):.1e}")
    return [study, *cells]


def rows_of_the_page() -> dict[str, list[str]]:
    text = (ROOT / "cpp_tools/doc/sampling.md").read_text(encoding="utf-8")
    rows = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("| ")]
    return {cells[0].strip(): [cell.strip() for cell in cells[1:]] for cells in rows}


@pytest.mark.parametrize("study", STUDIES)
def test_the_page_states_wavelengths_and_errors(nacre, study):
    _, *cells = row(nacre, study)
    stated = rows_of_the_page()[study]
    for cell, said in zip(cells, stated, strict=True):
        assert float(cell) == pytest.approx(float(said), rel=0.06)
    adaptive_wavelengths, adaptive_error = map(float, cells[:2])
    assert adaptive_error <= 1e-3
    if study.startswith("soap film, 50"):
        assert adaptive_wavelengths <= 16
    assert adaptive_wavelengths <= 96 or "10 µm" in study


@pytest.mark.parametrize(("pairs", "half_waves", "width_nm"), [(2, 3, 7), (4, 1, 2), (5, 1, 0.7)])
def test_the_lines_are_as_wide_as_the_page_says(nacre, pairs, half_waves, width_nm):
    film = etalon(550, pairs, half_waves, 0)
    wavelengths = 550 + np.linspace(-6, 6, 2401)
    index = json.loads(nacre.ok("--json", "library", "show", "N-BK7/SCHOTT", "--at", "550"))["at"][
        0
    ]
    film["n"][-1] = index["n"]
    answers = nacre.evaluate(
        "stack", [{**film, "wavelength_nm": nm, "pol": "u"} for nm in wavelengths]
    )
    transmittance = np.array([answer["T"] for answer in answers])
    above = wavelengths[transmittance > transmittance.max() / 2]
    assert above[-1] - above[0] == pytest.approx(width_nm, rel=0.15)


def test_colours_are_those_of_the_spectrum(nacre):
    """Reflectances of `eval stack`, summed by `eval spectrum`."""
    index = json.loads(
        nacre.ok(
            "--json", "library", "show", "Au/Johnson", *(f"--at={nm}" for nm in range(360, 831))
        )
    )["at"]
    base = {"d_nm": [250], "angle_deg": 50}
    stacks = [
        {**base, "n": [1, 1.7, [at["n"], at["k"]]], "wavelength_nm": nm, "pol": "p"}
        for nm, at in zip(range(360, 831), index, strict=True)
    ]
    spectrum = [answer["R"] for answer in nacre.evaluate("stack", stacks)]
    for light in (
        {"illuminant": "A", "observer": "cie1964"},
        {"illuminant": "D65"},
        {"illuminant": "F11"},
    ):
        wanted = nacre.evaluate(
            "spectrum",
            {
                "wavelength_nm": list(range(360, 831)),
                "values": spectrum,
                "kind": "reflectance",
                **light,
            },
            "--cat",
            "cat16",
        )
        record = {**base, "n": [1, 1.7, "Au/Johnson"], "pol": "p", **light}
        got = nacre.evaluate("colour", record, "--sampling", "full", "--cat", "cat16")
        for key in ("XYZ", "Lab", "rgb"):
            assert got["reflectance"][key] == pytest.approx(wanted[key], abs=1e-9)
        few = nacre.evaluate("colour", record, "--cat", "cat16")
        assert few["reflectance"]["rgb"] == pytest.approx(wanted["rgb"], abs=1e-3)
        assert few["wavelengths"] < 96


def test_spaces_gamut_and_white(nacre):
    mirror = {"n": [1, [0.0001, 20]], "d_nm": [], "angle_deg": 0, "illuminant": "A"}
    for space in ("lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene"):
        colour = nacre.evaluate("colour", mirror, "--space", space)
        assert colour["space"] == space
        assert colour["reflectance"]["rgb"] == pytest.approx([1, 1, 1], abs=2e-5)
    green = etalon(500, 2, 1, 0)
    assert min(nacre.evaluate("colour", green)["transmittance"]["rgb"]) < 0
    assert min(nacre.evaluate("colour", green, "--gamut", "clip")["transmittance"]["rgb"]) == 0


def test_incoherent_panes_are_summed_at_one_nanometre(nacre):
    pane = {"n": [1, "N-BK7/SCHOTT", 1], "d_nm": [1e6], "angle_deg": 0, "coherence": ["i"]}
    colour = nacre.evaluate("colour", pane)
    assert colour["wavelengths"] == 471
    assert sum(colour["reflectance"]["rgb"]) / 3 == pytest.approx(0.0815, abs=0.001)


BOX = {"wavelength_nm": [380, 499.9, 500, 600, 600.1, 780], "values": [0, 0, 0.8, 0.8, 0, 0]}


@pytest.mark.parametrize("kind", ["emission", "reflectance"])
def test_spectra_are_sampled_too(nacre, kind):
    """A constant between two wavelengths: steps and levels get worse as they grow."""
    record = {**BOX, "kind": kind}
    truth = np.array(nacre.evaluate("spectrum", record)["XYZ"])
    for name, numbers in (("steps", (1, 8, 32, 128)), ("hierarchical", (0, 3, 6, 9))):
        errors = [
            np.max(
                np.abs(
                    np.array(nacre.evaluate("spectrum", record, "--sampling", f"{name}:{n}")["XYZ"])
                    - truth
                )
            )
            for n in numbers
        ]
        assert errors[0] < 1e-12
        assert errors[1] < 0.03
        assert errors[-1] > 0.05
    full = nacre.evaluate("spectrum", record, "--sampling", "full")
    assert full["XYZ"] == pytest.approx(list(truth), abs=1e-14)


def test_steps_are_counted_from_the_lower_bound(nacre):
    """A constant in bounds, as D. Schiffner's light of steps has it (Wellenlängenbasiertes
    Beleuchtungsmodell im Shader, 2008): the sum at its lower bound and every N nm above, over Σ ȳ."""
    cmf = np.loadtxt(
        ROOT / "cpp_tools/data/cmf/cie_1931_2deg_1nm.csv", delimiter=",", comments=("#", "w")
    )
    matching = {int(nm): xyz for nm, *xyz in cmf}
    for step in (1, 8, 32, 64, 128):
        inside = [matching[nm] for nm in range(450, 651, step)]
        expected = step * np.sum(inside, axis=0) / cmf[:, 2].sum()
        found = nacre.evaluate("spectrum", {"spectrum": "study/box"}, "--sampling", f"steps:{step}")
        assert found["XYZ"] == pytest.approx(list(expected), rel=1e-9)
        if step == 64:
            assert found["XYZ"][0] == pytest.approx(0.994, abs=5e-4)


LIGHTS = [
    {"wavelength_nm": [360, 830], "values": [value, value], "kind": "emission"}
    for value in (0.2, 1.5, 4.0)
]


def test_range_of_a_batch(nacre):
    """L6: every record alone, or all by the same factor."""
    plain = np.array([a["rgb"] for a in nacre.evaluate("spectrum", LIGHTS)])
    clamped = np.array([a["rgb"] for a in nacre.evaluate("spectrum", LIGHTS, "--range", "clamp")])
    assert np.array_equal(clamped, np.clip(plain, 0, 1))
    shared = np.array(
        [a["rgb"] for a in nacre.evaluate("spectrum", LIGHTS, "--range", "normalise")]
    )
    assert shared.max() == 1
    assert np.allclose(shared, plain / plain.max(), rtol=1e-15)
    batch = [SOAP, {**SOAP, "d_nm": [90]}]
    colours = rgb(nacre.evaluate("colour", batch, "--range", "normalise"))
    assert colours.max() == 1


def test_a_bad_record_beside_good_ones_keeps_its_place(nacre):
    result = nacre(
        "eval", "spectrum", "--range", "normalise", stdin=json.dumps([LIGHTS[0], {}, LIGHTS[2]])
    )
    assert result.returncode == 1
    first, bad, last = json.loads(result.stdout)
    assert "error" in bad
    assert max(last["rgb"]) == 1
    assert max(first["rgb"]) == pytest.approx(0.05)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"n": [1, "watre", 1]}, "n[1]: "),
        ({"n": [1, [1.3], 1]}, "n[1]: must be a key of the library, n or [n, k] (got [1.3])"),
        ({"n": [1, [1.3, -1], 1]}, "n[1][1]: must be ≥ 0 (got -1"),
        ({"n": [1]}, "n: must list 2 … 66 media"),
        ({"n": [[1, 0.5], 1.3, 1]}, "n[0]: must not absorb in the ambient"),
        ({"n": [1, "TiO2/Devore-o", 1]}, "n[1]: must be within the data, 430 … 1530 nm"),
        ({"d_nm": [1, 2]}, "d_nm: must have one thickness for each of the 1 layers of n (got 2)"),
        ({"angle_deg": 90}, "angle_deg: must be in [0, 90)"),
        ({"pol": "x"}, "pol: must be one of s, p, u"),
        ({"illuminant": "D64"}, "illuminant: "),
        ({"coherence": ["x"]}, "coherence[0]: must be c or i"),
        ({"angle": 1}, "angle: "),
    ],
)
def test_bad_records(nacre, change, message):
    assert message in nacre.fails("eval", "colour", stdin=json.dumps({**SOAP, **change}))


@pytest.mark.parametrize("name", ["fast", "steps:0", "steps:129", "steps:x", "hierarchical:10"])
def test_unknown_samplings(nacre, name):
    error = nacre.fails("eval", "colour", "--sampling", name, stdin=json.dumps([SOAP, SOAP]))
    assert error.count("must be adaptive, full, reference, steps:1 … steps:128") == 1
