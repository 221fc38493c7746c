# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours that a film takes along its thickness, at normal incidence, from its own tables."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import bpy

from ..materials import recipe as recipes
from ..materials.material import interface_item
from ..materials.thickness import thickness_range, thickness_socket
from . import colour_names, edited

CHIPS = 16
_FINE = 112  # rows that names are found in
_COLUMNS = 8  # over the angle; the last one is normal incidence


@dataclass(frozen=True)
class Chip:
    """One colour of the strip: sRGB from 0 to 1, as it is shown."""

    thickness: float
    rgb: tuple[float, float, float]
    name: str


def chips(material: bpy.types.Material) -> tuple[Chip, ...]:
    """Along the whole range; nothing where the thickness cannot vary, or nothing can be computed."""
    socket = thickness_socket(material)
    if socket is None:
        return ()
    return _chips(*along(material, *thickness_range(socket), CHIPS))


def describe(material: bpy.types.Material) -> None:
    """Puts the colours into the tooltip of the thickness: `5–70 nm: straw at 21, purple at 41`."""
    socket = thickness_socket(material)
    if socket is None:
        return
    item = interface_item(socket)
    low, high = thickness_range(socket)
    said = f"{low:g}–{high:g}{unit(socket)}"
    names = colour_names.along(*along(material, low, high, _FINE))
    item.description = f"{said}: {names}" if names else said


def unit(socket: bpy.types.NodeSocket) -> str:
    """What follows a number of the socket: nothing after a factor."""
    return " nm" if thickness_range(socket)[1] > 10.0 else ""


Colours = tuple[tuple[float, ...], ...]  # linear Rec.709


def along(
    material: bpy.types.Material, low: float, high: float, count: int
) -> tuple[tuple[float, ...], Colours]:
    """Thicknesses at even steps and their colours; nothing where they cannot be computed."""
    found = edited.known(material)
    try:
        colours = _colours(*found, count) if found else ()
    except ValueError:  # of an unfinished edit
        colours = ()
    step = (high - low) / (count - 1)
    return tuple(low + step * index for index in range(len(colours))), colours


@lru_cache(maxsize=128)
def _colours(_library: str, wanted: recipes.Recipe, count: int) -> Colours:
    import nacre

    size = {"R": (count, _COLUMNS)}
    tables = nacre.preview_tables(wanted.template, size, **wanted.conditions._asdict())
    return tuple(map(tuple, tables["R"][:, -1].tolist()))


@lru_cache(maxsize=32)
def _chips(values: tuple[float, ...], colours: Colours) -> tuple[Chip, ...]:
    from ..core import plot

    return tuple(
        Chip(value, tuple(map(float, plot.encode(colour))), colour_names.name(colour))
        for value, colour in zip(values, colour_names.brightened(colours), strict=True)
    )
