# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`nacre eval grating`: the conical grating equation and scalar efficiencies."""

from __future__ import annotations

import json
import math

import pytest

CD = {
    "pitch_nm": 1600,
    "grating_vector": [1, 0, 0],
    "normal": [0, 0, 1],
    "k_in": [0, 0, -1],
    "wavelength_nm": 550,
    "orders": [-3, 3],
    "profile": {"kind": "rectangular", "phase_rad": math.pi, "duty": 0.5},
}


def expected_direction(record, order):
    """k_out∥ = k_in∥ + m λ/d ĝ, on the side of the normal; None when evanescent."""

    def unit(v):
        length = math.hypot(*v)
        return [x / length for x in v]

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b, strict=True))

    normal, k_in = unit(record["normal"]), unit(record["k_in"])
    vector = record["grating_vector"]
    g = unit([x - dot(vector, normal) * n for x, n in zip(vector, normal, strict=True)])
    shift = order * record["wavelength_nm"] / record["pitch_nm"]
    tangential = [
        k - dot(k_in, normal) * n + shift * gi for k, n, gi in zip(k_in, normal, g, strict=True)
    ]
    rest = 1 - dot(tangential, tangential)
    return (
        None
        if rest < 0
        else [t + math.sqrt(rest) * n for t, n in zip(tangential, normal, strict=True)]
    )


GEOMETRIES = {
    "normal": {},
    "oblique": {"k_in": [math.sin(0.5), 0, -math.cos(0.5)]},
    "conical": {"k_in": [0.3, 0.6, -0.8], "grating_vector": [2, 1, 0]},
    "tilted": {"normal": [0.2, -0.3, 0.9], "grating_vector": [0, 1, 1], "k_in": [0.1, 0.2, -3]},
    "dvd": {"pitch_nm": 740, "wavelength_nm": 650, "k_in": [0.5, 0.1, -0.5]},
}


@pytest.mark.parametrize("name", GEOMETRIES)
def test_directions_follow_the_grating_equation(nacre, name):
    record = {**CD, **GEOMETRIES[name]}
    for answer in nacre.evaluate("grating", record)["orders"]:
        expected = expected_direction(record, answer["order"])
        if expected is None:
            assert answer["direction"] is None
            assert answer["efficiency"] == 0
        else:
            assert answer["direction"] == pytest.approx(expected, abs=1e-12)


def test_first_order_of_a_cd_by_hand(nacre):
    orders = {o["order"]: o for o in nacre.evaluate("grating", CD)["orders"]}
    assert sorted(orders) == [-3, -2, -1, 0, 1, 2, 3]
    assert orders[1]["direction"] == pytest.approx(
        [550 / 1600, 0, math.sqrt(1 - (550 / 1600) ** 2)], abs=1e-15
    )
    assert orders[3]["direction"] is None  # 3 · 550 > 1600


def test_rectangle_of_half_a_wave_empties_the_even_orders(nacre):
    """φ = π, duty ½: η_m ∝ 1/m² for odd m, 0 for even m (Goodman, square-wave phase grating)."""
    record = {**CD, "wavelength_nm": 200, "orders": [-7, 7]}
    efficiency = {o["order"]: o["efficiency"] for o in nacre.evaluate("grating", record)["orders"]}
    for m in range(-7, 8):
        expected = efficiency[1] / m**2 if m % 2 else 0.0
        assert efficiency[m] == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("kind", ["sinusoidal", "rectangular", "blazed"])
def test_efficiencies_share_the_reflected_power(nacre, kind):
    record = {**CD, "orders": [-2, 2], "profile": {"kind": kind, "phase_rad": 2.0}}
    total = sum(order["efficiency"] for order in nacre.evaluate("grating", record)["orders"])
    assert total == pytest.approx(1.0, abs=1e-6)  # ±3 are evanescent


def test_without_a_profile_the_answer_is_directions_alone(nacre):
    """Where light goes does not depend on the profile, how much of it does."""
    with_profile = nacre.evaluate("grating", CD)["orders"]
    bare = {key: value for key, value in CD.items() if key != "profile"}
    without = nacre.evaluate("grating", bare)["orders"]
    assert {key for order in without for key in order} == {"order", "direction"}
    for full, directions in zip(with_profile, without, strict=True):
        assert full["efficiency"] is not None
        del full["efficiency"]
        assert full == directions


BAD = {
    "pitch": ({"pitch_nm": 0}, "pitch_nm: must be > 0 (got 0)"),
    "pitch-nan": ({"pitch_nm": math.nan}, "pitch_nm: must be > 0 (got NaN)"),
    "normal-zero": ({"normal": [0, 0, 0]}, "normal: must have a length > 0"),
    "normal-short": ({"normal": [0, 1]}, "normal: must be [x, y, z] (got 2 numbers)"),
    "from-below": ({"k_in": [0, 0, 1]}, "k_in: must point towards the surface"),
    "grooves": ({"grating_vector": [0, 0, 2]}, "grating_vector: must not be parallel"),
    "orders": ({"orders": [3, -3]}, "orders: must be [first, last]"),
    "orders-huge": ({"orders": [0, 10**12]}, "orders: must be [first, last]"),
    "orders-real": ({"orders": [0, 1.5]}, "orders: must be [first, last]"),
    "profile": ({"profile": {"kind": "round", "phase_rad": 1}}, "profile.kind: must be one of"),
    "duty": (
        {"profile": {"kind": "rectangular", "phase_rad": 1, "duty": 1}},
        "profile.duty: must be in (0, 1) (got 1)",
    ),
    "profile-key": (
        {"profile": {"kind": "blazed", "phase_rad": 1, "depth": 1}},
        "profile.depth: is not known here",
    ),
    "profile-phase": ({"profile": {"kind": "blazed"}}, "profile.phase_rad: is missing"),
    "profile-null": ({"profile": None}, "profile: must be an object (got null)"),
    "profile-type": ({"profile": 3}, "profile: must be an object (got 3)"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_record(nacre, name):
    change, message = BAD[name]
    assert message in nacre.fails("eval", "grating", stdin=json.dumps({**CD, **change}))
