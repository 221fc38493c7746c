# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials that were assigned last, and those that are favourites: in the preferences, so that they are
there tomorrow; of this session where Nacre is not installed as an add-on."""

from __future__ import annotations

from collections.abc import Container

import bpy

from .settings import preferences

MOST_RECENT = 6


def _kept():
    return preferences() or bpy.context.window_manager.nacre


def recent(known: Container[str]) -> list[str]:
    """Those that the library still has; so below."""
    return [material_id for material_id in _kept().recent.split() if material_id in known]


def favourites(known: Container[str]) -> list[str]:
    return [material_id for material_id in _kept().favourites.split() if material_id in known]


def remember(material_id: str) -> None:
    others = [other for other in _kept().recent.split() if other != material_id]
    _kept().recent = " ".join([material_id, *others][:MOST_RECENT])


def turn_favourite(material_id: str) -> bool:
    """Returns whether it is one now."""
    kept = _kept().favourites.split()
    is_one = material_id not in kept
    kept = [*kept, material_id] if is_one else [other for other in kept if other != material_id]
    _kept().favourites = " ".join(kept)
    return is_one
