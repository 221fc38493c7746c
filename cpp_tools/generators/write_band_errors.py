# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of cpp_tools/doc/bands.md anew: how exact bands are for every light of the library.

usage: write_band_errors.py [PAGE]

Needs the Python package, with NACRE_LIBRARY or installed.
"""

from __future__ import annotations

import sys
from pathlib import Path

import nacre
from nacre import library

PAGE = Path(__file__).parents[1] / "doc" / "bands.md"
FILMS_NM = (500, 1000, 2000, 3000, 4000, 6000, 8000, 12000)


def _reflectances() -> tuple[list[float], list[list[float]]]:
    nm = [float(nm) for nm in range(360, 831)]
    found = []
    for key in library.keys("spectra"):
        spectrum = library.spectrum(key)
        if spectrum.kind == "reflectance":
            samples = nacre.shapes.total(nacre.shapes.Scaled(key, 1.0), nm)
            found.append(list(samples))
    return nm, found


def lights() -> list[str]:
    return [key for key in library.keys("spectra") if library.spectrum(key).kind == "emission"]


def lamp_rows() -> list[str]:
    nm, reflectances = _reflectances()
    eye = nacre.bands(48, ["D65"])
    rows = []
    for key in lights():
        errors = [nacre.bands(count, [key]).error(key, nm, reflectances) for count in (24, 48)]
        errors.append(eye.error(key, nm, reflectances))
        cells = " | ".join(f"{error.mean:.3f} / {error.max:.2f}" for error in errors)
        rows.append(f"| {library.spectrum(key).name} | `{key}` | {cells} |")
    return rows


def film_rows() -> list[str]:
    rows = []
    for nd in FILMS_NM:
        of_each = [nacre.choose_bands([lamp], films_nm=[nd])[1] for lamp in ("D65", "A", "F11")]
        cells = " | ".join(str(choice.passes) if choice.met else "more" for choice in of_each)
        rows.append(f"| {nd} nm | {cells} |")
    return rows


def written(page: str) -> str:
    """The page with the rows of its two tables in place of those that are there."""
    for name, rows in (("lights", lamp_rows()), ("films", film_rows())):
        start = page.index(f"<!-- table: {name} -->")
        head_end = page.index("|\n", page.index("|---", start)) + 2
        tail = page.index("\n\n", head_end - 1)
        page = page[:head_end] + "\n".join(rows) + page[tail:]
    return page


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE
    target.write_text(written(target.read_text("utf-8")), "utf-8")
