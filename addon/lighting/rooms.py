# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lights to put a scene into: what a menu says of them, and where the bright rectangles hang."""

from __future__ import annotations

from dataclasses import dataclass

MADE_HERE = (
    (
        "STUDIO",
        "Studio",
        "A grey sweep under a large softbox, with a strip of light on either side",
    ),
    ("SOFTBOXES", "Softboxes", "Three softboxes in a dark room: the clearest reflections"),
    ("WINDOW", "Window", "A bright window with bars in a dim room, as soap bubbles show it"),
    ("SKY", "Sky", "A clear sky over dark ground, the sun behind the camera's left shoulder"),
)
ENVIRONMENTS = (
    ("CITY", "City", "Blender's own picture of a street"),
    ("COURTYARD", "Courtyard", "Blender's own picture of a courtyard"),
    ("FOREST", "Forest", "Blender's own picture of a forest"),
    ("INTERIOR", "Interior", "Blender's own picture of a room with lamps"),
    ("NIGHT", "Night", "Blender's own picture of a street at night"),
    ("PHOTO_STUDIO", "Photo Studio", "Blender's own picture of a studio"),
    ("SUNRISE", "Sunrise", "Blender's own picture of a sunrise"),
    ("SUNSET", "Sunset", "Blender's own picture of a sunset"),
)
GAINS = {"PHOTO_STUDIO": 2.5, "NIGHT": 1.5}  # of pictures that are darker than a picture should be
LIGHTS = (*MADE_HERE, *ENVIRONMENTS)


def name_of(light: str) -> str:
    return next((name for key, name, _ in LIGHTS if key == light), light)


def picture_of(light: str) -> str:
    """File name of an environment of Blender's."""
    return f"{light.removeprefix('PHOTO_').lower()}.exr"


@dataclass(frozen=True)
class Softbox:
    """A bright rectangle at infinity: the tangents of half its width and height as they are seen."""

    azimuth_deg: float  # from +X towards +Y; the default camera stands at -42
    elevation_deg: float
    half_size: tuple[float, float]
    radiance: tuple[float, float, float]  # linear Rec.709
    panes: tuple[int, int] = (1, 1)
    edge: float = 0.06  # how soft, as a part of the half size
    falloff: float = 0.0  # how much darker the corners are
    is_hidden: bool = False  # from the camera itself; things mirror it


@dataclass(frozen=True)
class Room:
    """What is around the softboxes: radiance at nadir, horizon and zenith."""

    nadir: float
    horizon: float
    zenith: float
    softboxes: tuple[Softbox, ...]


_WARM, _COOL, _WHITE = (1.0, 0.94, 0.86), (0.88, 0.95, 1.0), (1.0, 1.0, 1.0)


def _of(tint: tuple[float, float, float], power: float) -> tuple[float, float, float]:
    return tuple(power * channel for channel in tint)


# Two dim cards below the horizon, as photographers hold them beside a thing: its upright faces, which the
# default camera looks down on, mirror what would be dark floor. Clear films keep a dark ground. Brighter ones
# would part what stands on a floor, which hides them, from what stands on none.
_CARDS = tuple(
    Softbox(azimuth, -30.0, (0.8, 0.6), _of(_WHITE, 0.3), edge=0.5, is_hidden=True)
    for azimuth in (42.0, -138.0)
)

ROOMS = {
    "STUDIO": Room(
        nadir=0.12,
        horizon=0.5,
        zenith=0.22,
        softboxes=(
            Softbox(-42.0, 78.0, (0.9, 0.6), _of(_WHITE, 7.0), edge=0.25, falloff=0.35),
            Softbox(-125.0, 18.0, (0.16, 0.9), _of(_COOL, 6.0), edge=0.2, falloff=0.2),
            Softbox(40.0, 18.0, (0.16, 0.9), _of(_WARM, 6.0), edge=0.2, falloff=0.2),
            *_CARDS,
        ),
    ),
    "SOFTBOXES": Room(
        nadir=0.01,
        horizon=0.04,
        zenith=0.02,
        softboxes=(
            Softbox(-95.0, 40.0, (0.5, 0.5), _of(_WHITE, 9.0), falloff=0.3),
            Softbox(15.0, 25.0, (0.25, 0.7), _of(_WARM, 7.0), falloff=0.2),
            Softbox(150.0, 35.0, (0.6, 0.4), _of(_COOL, 6.0), falloff=0.2),
            *_CARDS,
        ),
    ),
    "WINDOW": Room(
        nadir=0.03,
        horizon=0.08,
        zenith=0.05,
        softboxes=(
            Softbox(-100.0, 28.0, (0.42, 0.6), _of(_COOL, 9.0), (2, 3), 0.015, 0.15),
            Softbox(60.0, 24.0, (0.2, 0.3), _of(_WARM, 3.0), (2, 2), 0.02, 0.15),
            *_CARDS,
        ),
    ),
}
