# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A disc's first order under a lamp: each colour where the grating equation puts it."""

from __future__ import annotations

import json
import tomllib
from dataclasses import dataclass

import numpy as np
import pytest

from support.paths import TEMPLATES, manifest
from support.tool import nacre

HEIGHT = 128
WAVELENGTHS = np.arange(380.0, 761.0)


@dataclass(frozen=True)
class SetUp:
    """Eye, lamp and the point looked at, all in the plane x = 0; the opening angle."""

    eye: tuple[float, float]
    lamp: tuple[float, float]
    target_y: float
    fov_deg: float

    def pixel_y(self) -> np.ndarray:
        """Where on the disc the centres of the pixels look, top row first."""
        eye_y, eye_z = self.eye
        axis = np.array([self.target_y - eye_y, -eye_z])
        axis /= np.linalg.norm(axis)
        up = np.array([-axis[1], axis[0]])  # turned towards +z
        if up[1] < 0:
            up = -up
        offset = (1 - (np.arange(HEIGHT) + 0.5) / HEIGHT * 2) * np.tan(np.radians(self.fov_deg / 2))
        rays = axis[None, :] + offset[:, None] * up[None, :]
        return eye_y - eye_z * rays[:, 0] / rays[:, 1]


SET_UPS = {
    "lamp opposite": SetUp((-3.0, 4.0), (3.0, 5.0), 1.05, 10.0),
    "lamp above the eye": SetUp((-4.0, 3.0), (-1.0, 6.0), -2.05, 14.0),
    "low sun": SetUp((-2.0, 5.0), (6.0, 2.5), 1.3, 16.0),
}


def unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def wavelength_at(y: np.ndarray, set_up: SetUp, pitch_nm: float) -> np.ndarray:
    """First order of the grating equation along the grooves' normal: λ = d |v_y + l_y|."""
    to_eye = unit(np.stack([set_up.eye[0] - y, np.full_like(y, set_up.eye[1])], axis=-1))
    to_lamp = unit(np.stack([set_up.lamp[0] - y, np.full_like(y, set_up.lamp[1])], axis=-1))
    return pitch_nm * np.abs(to_eye[:, 0] + to_lamp[:, 0])


def colour_of_lines() -> np.ndarray:
    """Linear Rec. 709 of a reflectance of 1 nm width under D65, for WAVELENGTHS."""
    grid = list(range(360, 831))
    records = [
        {"wavelength_nm": grid, "values": [float(nm == line) for nm in grid], "kind": "reflectance"}
        for line in WAVELENGTHS
    ]
    answers = json.loads(nacre("eval", "spectrum", stdin=json.dumps(records)))
    return np.array([answer["rgb"] for answer in answers])


def first_order_strength(y: np.ndarray, set_up: SetUp, wavelengths: np.ndarray) -> np.ndarray:
    """1 − cos φ of rectangular grooves, φ = 2π n h (cos θ_i' + cos θ_o') / λ inside the cover."""
    template = tomllib.loads((TEMPLATES / "cd.toml").read_text("utf-8"))["grating"]
    cover = template["cover"]["sellmeier"]
    squared = 1 + sum(
        b / (1 - c / (wavelengths / 1000) ** 2) for b, c in zip(cover["b"], cover["c"], strict=True)
    )
    cosines = 0.0
    for other in (set_up.eye, set_up.lamp):
        towards = unit(np.stack([other[0] - y, np.full_like(y, other[1])], axis=-1))
        cosines = cosines + np.sqrt(1 - towards[:, 0] ** 2 / squared)
    phase = 2 * np.pi * np.sqrt(squared) * template["depth_nm"] * cosines / wavelengths
    return 1 - np.cos(phase)


def predicted(y: np.ndarray, set_up: SetUp, material: dict) -> np.ndarray:
    """Channel values along the column up to a factor that varies slowly: the colour of the one
    wavelength that reaches the eye times the efficiency of the order at it."""
    grating = material["grating"]
    wavelengths = wavelength_at(y, set_up, grating["pitch_nm"])
    colours = colour_of_lines()
    columns = [np.interp(wavelengths, WAVELENGTHS, colours[:, c], 0.0, 0.0) for c in range(3)]
    return np.stack(columns, axis=-1) * first_order_strength(y, set_up, wavelengths)[:, None]


def peak(values: np.ndarray) -> float:
    """Position of the maximum between pixels, by the centre of what is above 70 % of it."""
    top = int(np.argmax(values))
    first = last = top
    while first > 0 and values[first - 1] > 0.7 * values[top]:
        first -= 1
    while last + 1 < len(values) and values[last + 1] > 0.7 * values[top]:
        last += 1
    weight = values[first : last + 1] - 0.7 * values[top]
    return float(np.average(np.arange(first, last + 1), weights=weight))


@pytest.mark.parametrize("name", SET_UPS)
def test_streak_of_a_cd_peaks_where_the_grating_equation_says(blender, name):
    set_up = SET_UPS[name]
    y = set_up.pixel_y()
    picture = blender.picture(
        "disc.render",
        material="cd",
        eye=[0.0, *set_up.eye],
        lamp=[0.0, *set_up.lamp],
        target=[0.0, set_up.target_y, 0.0],
        fov_deg=set_up.fov_deg,
        height=HEIGHT,
        samples=4096,
    )
    assert picture.shape == (HEIGHT, 1, 3)
    column = picture[:, 0]
    expected = predicted(y, set_up, manifest("cd"))
    shifts = [peak(column[:, c]) - peak(expected[:, c]) for c in range(3)]
    print(f"{name}, Blender {blender.version}: shifts in pixels", np.round(shifts, 2))
    assert np.abs(shifts).max() <= 1.0


@pytest.mark.parametrize(
    ("metal", "tint"),
    [
        ("Al/Rakic", None),
        ("Cu/Johnson", None),
        ("Au/Johnson", None),
        ("Al/Rakic", (1.0, 0.5, 0.25)),
    ],
    ids=["aluminium", "copper", "gold", "saturated tint"],
)
def test_disc_in_a_white_world_has_the_colour_of_its_metal(blender, tmp_path, metal, tint):
    """The orders share out what the metal reflects, whatever its colour; short waves have a fourth
    order, with 1 % of the light, which the material leaves out."""
    text = (TEMPLATES / "cd.toml").read_text("utf-8")
    (tmp_path / "disc.toml").write_text(
        text.replace("Al/Rakic", metal).replace('id = "cd"', 'id = "disc"'), "utf-8"
    )
    nacre("compile", tmp_path / "disc.toml", "--quiet", "-o", tmp_path)
    made = json.loads((tmp_path / "disc" / "disc.json").read_text("utf-8"))
    own = next(socket["default"] for socket in made["sockets"] if socket["name"] == "tint")
    values = {"roughness": 0.05, **({"tint": (*tint, 1.0)} if tint else {})}
    picture = blender.pictures(
        "furnace.render",
        lambda: {"material": "disc", "form": "osl", "values": values, "lit": "all", "size": 16,
                 "samples": 2048},
        materials=tmp_path,
    )()  # fmt: skip
    mean = picture[4:12, 4:12].mean(axis=(0, 1))
    print(f"{metal}, Blender {blender.version}:", np.round(mean, 4), np.round(tint or own, 4))
    np.testing.assert_allclose(mean, tint or own, rtol=0.03)
