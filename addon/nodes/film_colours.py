# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours that a film takes along its thickness, at normal incidence, from its own tables."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import bpy

from ..core import colour_names
from ..core.manifest import ManifestError
from ..core.stack import StackError
from . import stack
from .material import WHEN_MADE
from .thickness import thickness_range, thickness_socket

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
    if socket is None or stack.library_problem():
        return ()
    try:
        wanted = stack.recipe(material)
        return _chips(stack.library_digest(wanted), wanted, *thickness_range(socket))
    except (StackError, ManifestError, ValueError):  # the panel says what is wrong with an edit
        return ()


def describe(material: bpy.types.Material) -> None:
    """Puts the colours into the tooltip of the thickness: `5–70 nm: straw at 21, purple at 41`."""
    socket = thickness_socket(material)
    if socket is None:
        return
    tree = socket.node.node_tree
    items = tree.interface.items_tree
    item = next(item for item in items if item.identifier == socket.identifier)
    unit = " nm" if item.max_value > 10.0 else ""  # or factors
    said = f"{item.min_value:g}–{item.max_value:g}{unit}"
    names = _names(material, item.min_value, item.max_value)
    item.description = f"{said}: {names}" if names else said


def _names(material: bpy.types.Material, low: float, high: float) -> str:
    if stack.library_problem():
        return ""
    try:
        wanted = stack.recipe(material)
        return _found_names(stack.library_digest(wanted), wanted, low, high)
    except (StackError, ManifestError, ValueError):
        return ""


@lru_cache(maxsize=128)
def _found_names(_library: str, wanted: stack.Recipe, low: float, high: float) -> str:
    return colour_names.along(_spaced(low, high, _FINE), _colours(wanted, _FINE))


@lru_cache(maxsize=32)
def _chips(_library: str, wanted: stack.Recipe, low: float, high: float) -> tuple[Chip, ...]:
    from ..core import plot

    shown = colour_names.brightened(_colours(wanted, CHIPS))
    return tuple(
        Chip(value, tuple(map(float, plot.encode(colour))), colour_names.name(colour))
        for value, colour in zip(_spaced(low, high, CHIPS), shown, strict=True)
    )


def _colours(wanted: stack.Recipe, count: int) -> list[list[float]]:
    import nacre

    size = {"R": (count, _COLUMNS)}
    tables = nacre.preview_tables(wanted.template, size, **wanted.conditions._asdict())
    return tables["R"][:, -1].tolist()


def _spaced(low: float, high: float, count: int) -> list[float]:
    return [low + (high - low) * index / (count - 1) for index in range(count)]


def register() -> None:
    WHEN_MADE.append(describe)


def unregister() -> None:
    WHEN_MADE.remove(describe)
