# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light and observer that an edited stack can be computed for, as items of a menu."""

from __future__ import annotations

# The numbers are stored in .blend files: append, never reorder.
ILLUMINANTS = (
    ("D65", "D65", "Daylight", 0),
    ("D50", "D50", "Warm daylight, as in print", 1),
    ("D55", "D55", "Daylight, as in photography", 2),
    ("D75", "D75", "Shade", 3),
    ("A", "A", "Incandescent lamp", 4),
    ("E", "E", "Equal energy at all wavelengths", 5),
    ("F2", "F2", "Fluorescent lamp, cool white", 6),
    ("F11", "F11", "Fluorescent lamp of three narrow bands", 7),
)
OBSERVERS = (
    ("cie1931", "CIE 1931", "2 degrees, the usual one", 0),
    ("cie1964", "CIE 1964", "10 degrees, for large fields", 1),
)


def light_problem(illuminant: object, observer: object) -> str:
    """What is wrong with names from a file, or nothing."""
    for what, name, items in (
        ("illuminant", illuminant, ILLUMINANTS),
        ("observer", observer, OBSERVERS),
    ):
        known = [item[0] for item in items]
        if name not in known:
            return f"{what}: must be one of {', '.join(known)} (got {name!r})"
    return ""
