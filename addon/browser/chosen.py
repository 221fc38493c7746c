# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials that were assigned last, and those that are favourites: in the preferences, so that they are
there tomorrow; of this session where Nacre is not installed as an add-on."""

from __future__ import annotations

from collections.abc import Container

import bpy

from ..materials.preferences import preferences

MOST_RECENT = 6


def _kept():
    return preferences() or bpy.context.window_manager.nacre


def recent(known: Container[str]) -> list[str]:
    """Keys of variants that the library still has; so below."""
    return [key for key in _kept().recent.split() if key in known]


def favourites(known: Container[str]) -> list[str]:
    return [key for key in _kept().favourites.split() if key in known]


def remember(key: str) -> None:
    others = [other for other in _kept().recent.split() if other != key]
    _kept().recent = " ".join([key, *others][:MOST_RECENT])


def turn_favourite(key: str) -> bool:
    """Returns whether it is one now."""
    kept = _kept().favourites.split()
    is_one = key not in kept
    kept = [*kept, key] if is_one else [other for other in kept if other != key]
    _kept().favourites = " ".join(kept)
    return is_one
