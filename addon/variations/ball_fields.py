# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How sources of a thickness lie on the ball of a picture: as their nodes do on a sphere, except that
noise is other noise."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache

import numpy as np

from ..thickness.sources import ON, STRENGTH, UPON, ZERO_CELSIUS, Source
from .ball import smooth_step

Values = Mapping[str, float | Sequence[float]]
_WAVES = 7  # for each octave
_OCTAVES = 4


def thickness(stack: Sequence[tuple[Source, Values]], lowest: float, normal: np.ndarray):
    """`stack`: sources with their values, the lowest first, on what lies below all. A number where
    nothing varies, or an array."""
    # The object's x is to the right, its y away from the viewer, its z up.
    place = np.stack([normal[..., 0], -normal[..., 2], normal[..., 1]], axis=-1)
    below: np.ndarray | float = lowest
    for source, values in stack:
        below = _upon(below, source, values, place)
    return below


def _upon(below, source: Source, values: Values, place: np.ndarray):
    share = values.get(STRENGTH, 1.0) * bool(values.get(ON, True))
    form = _FORMS.get(source.id)
    if form is None:
        return below
    return form(values, below, place) * share + below * (1.0 - share)


def _mix(values: Values, low: str, high: str, part):
    return values[low] + (values[high] - values[low]) * part


def _clouds(values: Values, _below, place: np.ndarray):
    noise = _noise(place, values["Scale"], values["Detail"], 0.0)
    return _mix(values, "Minimum", "Maximum", smooth_step(noise, -2.0, 2.0))


def _painted(values: Values, _below, place: np.ndarray):
    """A picture or paint that is not known here."""
    return _mix(values, "Minimum", "Maximum", (place[..., 2] + 1.0) / 2.0)


def _away(values: Values, place: np.ndarray):
    if "Start" not in values:  # from an object, which begins at the upper front
        away = place - np.array([-0.5, -0.6, 0.6])
        return np.linalg.norm(away, axis=-1) / (2.0 * values["Reach"])
    away = ((place + 1.0) / 2.0 - np.array(values["Start"])) * np.array(values["Axes"])
    return np.linalg.norm(away, axis=-1) / values["Reach"]


def _gradient(values: Values, _below, place: np.ndarray):
    return _mix(values, "Near", "Far", np.minimum(_away(values, place), 1.0))


def _height(values: Values, _below, place: np.ndarray):
    whole = values["Top"] - values["Bottom"]
    part = (place[..., 2] - values["Bottom"]) / whole if whole else 0.0 * place[..., 2]
    return _mix(values, "Near", "Far", np.clip(part, 0.0, 1.0))


def _faces(values: Values, _below, _place):
    """A ball has no edges."""
    return values["Faces"]


def _heat(values: Values, below, place: np.ndarray):
    fallen = np.exp(-_away(values, place))
    kelvin = _mix(values, "Coldest", "Hottest", fallen) + ZERO_CELSIUS
    slower = 1.0 / (values["At"] + ZERO_CELSIUS) - 1.0 / kelvin
    own = values["Grown"] * np.exp(values["Growth"] * slower)
    return np.hypot(own, below) if values.get(UPON) else own


def _drop(values: Values, below, place: np.ndarray):
    x, z = place[..., 0], place[..., 2]
    centre = values["Centre"]
    # Seen from the front, its middle is the middle of the map.
    r = np.hypot(x / 2.0 + 0.5 - centre[0], z / 2.0 + 0.5 - centre[1]) / values["Radius"]
    return below + values["Height"] * np.clip(1.0 - r * r, 0.0, 1.0)


def _drainage(values: Values, _below, place: np.ndarray):
    depth = np.clip((1.0 - place[..., 2]) / 2.0, 0.0, 1.0)
    film = values["Bottom"] * np.sqrt(depth / values["Time"])
    edge = values["Black Film"]
    return values["Black Thickness"] + (film - values["Black Thickness"]) * smooth_step(
        depth, edge, edge + 0.02
    )


def _swirl(values: Values, below, place: np.ndarray):
    carried = place + 0.25 * values["Flow"] * np.stack(
        [
            _noise(place, values["Scale"] * 0.6, 0.0, values["Time"] + 9.0 * axis)
            for axis in range(3)
        ],
        axis=-1,
    )
    change = 0.6 * values["Amount"] * _noise(carried, values["Scale"], 2.0, values["Time"])
    return below * np.maximum(1.0 + change, 0.0)


def _noise(place: np.ndarray, scale: float, detail: float, time: float) -> np.ndarray:
    """Waves of all directions, about −1 to 1."""
    directions, phases = _waves()
    count = _WAVES * (1 + int(min(max(detail, 0.0), _OCTAVES - 1)))
    frequency = 2.0 ** (np.arange(count) // _WAVES)
    turns = ((2.6 * scale * frequency)[:, None] * directions[:count]).astype(np.float32)
    # Not as a product of matrices: threads for one so small are waited for.
    angles = (phases[:count] + 0.7 * time).astype(np.float32)
    for axis in range(3):
        angles = angles + place[..., axis, None].astype(np.float32) * turns[:, axis]
    weights = (1.0 / frequency / np.sqrt(_WAVES / 2.0)).astype(np.float32)
    return np.einsum("...i,i->...", np.sin(angles), weights)


@lru_cache(maxsize=1)
def _waves() -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(7)
    directions = random.normal(size=(_WAVES * _OCTAVES, 3))
    directions *= random.uniform(0.6, 1.4, (len(directions), 1)) / np.linalg.norm(
        directions, axis=1, keepdims=True
    )
    return directions, random.uniform(0.0, 2.0 * np.pi, len(directions))


_FORMS: dict[str, Callable] = {
    "map": _painted,
    "attribute": _painted,
    "noise": _clouds,
    "gradient": _gradient,
    "height": _height,
    "distance": _gradient,
    "edge": _faces,
    "temperature": _heat,
    "heat_point": _heat,
    "heat_curve": _heat,
    "drop": _drop,
    "drainage": _drainage,
    "swirl": _swirl,
}
