# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light and observer that colours are computed for, and the wavelengths of spectra."""

from __future__ import annotations

from typing import NamedTuple


class Conditions(NamedTuple):
    """As `nacre.compile_template` takes them, by name."""

    illuminant: str = "D65"
    observer: str = "cie1931"
    adaptation: str = "bradford"


FIRST_NM, LAST_NM = 360, 830
"""Of spectra, in steps of 1 nm."""

USUAL = Conditions()
ADAPTATIONS = ("bradford", "cat16", "none")
AS_COMPILED = "AS_COMPILED"

# Items of menus. The numbers are stored in .blend files: append, never reorder.
ILLUMINANTS = (
    ("D65", "D65", "Daylight", 0),
    ("D50", "D50", "Warm daylight, as in print", 1),
    ("D55", "D55", "Daylight, as in photography", 2),
    ("D75", "D75", "Shade", 3),
    ("A", "A", "Incandescent lamp", 4),
    ("E", "E", "Equal energy at all wavelengths", 5),
    ("F2", "F2", "Fluorescent lamp, cool white", 6),
    ("F11", "F11", "Fluorescent lamp of three narrow bands", 7),
    (AS_COMPILED, "As Compiled", "The light that the material was compiled for", 8),
)
OBSERVERS = (
    ("cie1931", "CIE 1931", "2 degrees, the usual one", 0),
    ("cie1964", "CIE 1964", "10 degrees, for large fields", 1),
)


def menu_item(illuminant: str) -> str:
    return illuminant if illuminant in {item[0] for item in ILLUMINANTS} else AS_COMPILED


def conditions_problem(*names: object) -> str:
    """What is wrong with names from a file, or nothing; the library knows which lights there are."""
    for what, name in zip(Conditions._fields, names, strict=True):
        if not isinstance(name, str) or not name:
            return f"{what}: must be a name (got {name!r})"
    for index, known in ((1, [item[0] for item in OBSERVERS]), (2, ADAPTATIONS)):
        if names[index] not in known:
            what = Conditions._fields[index]
            return f"{what}: must be one of {', '.join(known)} (got {names[index]!r})"
    return ""
