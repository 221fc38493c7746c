# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Icons of an edited stack: colours over angle and thickness, and a spectrum."""

from __future__ import annotations

from functools import lru_cache

import bpy

from ..blender import icons
from ..materials import recipe as recipes
from . import edited
from .stack import read_stack

COLUMNS, ROWS = 48, 96


def swatch(material: bpy.types.Material) -> int:
    """Icon of the colours over angle (right: grazing) and thickness (up: more)."""
    wanted = recipes.recipe(material)
    rows = 1 if not _varies(wanted.template) else ROWS
    key = (edited.library_digest(wanted), wanted, rows)
    return icons.drawn(f"{material.session_uid}:swatch", key, _draw_swatch)


def spectrum(material: bpy.types.Material, value: float, angle_deg: float) -> int:
    """Icon of R from 380 to 780 nm at a value of what varies."""
    wanted = recipes.recipe(material)
    key = (edited.library_digest(wanted), wanted, round(value, 3), round(angle_deg, 1))
    return icons.drawn(f"{material.session_uid}:spectrum", key, _draw_spectrum)


@lru_cache(maxsize=64)
def _varies(template: str) -> bool:
    made = read_stack(template)
    return made.varying is not None or made.has_scale


def _draw_swatch(_library: str, wanted: recipes.Recipe, rows: int):
    import nacre

    from ..core import plot

    tables = nacre.preview_tables(
        wanted.template, {"R": (rows, COLUMNS)}, **wanted.conditions._asdict()
    )
    return plot.swatch(tables["R"])


def _draw_spectrum(_library: str, wanted: recipes.Recipe, value: float, angle_deg: float):
    import nacre

    found = nacre.template_spectrum(
        wanted.template, value, angle_deg, **wanted.conditions._asdict()
    )
    return icons.draw_curve(tuple(found.reflectance))
