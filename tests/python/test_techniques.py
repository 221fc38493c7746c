# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Closed forms as techniques of materials: how far their colours are from the multilayer's, which is
the table of cpp_tools/doc/models.md."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

import colour
import numpy as np
import pytest

import nacre
from support.colours import lab

DOC = Path(__file__).parents[2] / "cpp_tools" / "doc" / "models.md"
FILMS = {
    "soap film": ('medium = "water/Daimon-20C"', 'medium = "air"'),
    "oil on water": ("abbe = { n_d = 1.47, v_d = 50 }", 'medium = "water/Daimon-20C"'),
    "titania on glass": ("cauchy = [2.2, 0.032]", 'medium = "N-BK7/SCHOTT"'),
    "oxide on titanium": ("cauchy = [2.2, 0.032]", 'medium = "Ti/Johnson"'),
}
EXACT = 0.005  # a table of two decimals says 0.00
ANGLES = np.degrees(np.arccos(np.linspace(0.1, 1.0, 10)))
THICKNESSES = np.linspace(50.0, 1000.0, 39)


def template(film: str, technique: str) -> str:
    layer, base = FILMS[film]
    return (
        'schema = 1\n[material]\nid = "t"\nname = "T"\ncategory = "T"\nsource = "made up"\n'
        f'[ambient]\nmedium = "air"\n[[layer]]\n{layer}\n'
        "thickness_nm = { default = 100, min = 0, max = 1000, varies = true }\n"
        f'[substrate]\n{base}\n[stack]\ntechnique = "{technique}"\n'
    )


@lru_cache
def colours(film: str, technique: str) -> np.ndarray:
    """CIE L*a*b* of the reflection, shape (angles, thicknesses, 3)."""
    text = template(film, technique)
    rgb = [
        [nacre.template_spectrum(text, nm, angle).colours[0] for nm in THICKNESSES]
        for angle in ANGLES
    ]
    return lab(rgb)


def mean_difference(film: str, technique: str) -> float:
    """ΔE00 from the multilayer."""
    pair = colours(film, technique), colours(film, "multilayer")
    return float(colour.delta_E(*pair, method="CIE 2000").mean())


def table() -> dict[tuple[str, str], str]:
    """Cells of the table by (technique, film)."""
    text = DOC.read_text("utf-8").split("## Closed forms as materials")[1]
    rows = [re.split(r"\s*\|\s*", line.strip("| ")) for line in re.findall(r"(?m)^\|.*\|$", text)]
    start = next(i for i, row in enumerate(rows) if row[1:] == list(FILMS))
    body = rows[start + 2 : start + 9]
    return {
        (row[0].strip("`"), film): cell
        for row in body
        for film, cell in zip(FILMS, row[1:], strict=True)
    }


@pytest.mark.parametrize(("technique", "film"), table())
def test_the_table_is_right(technique, film):
    said = table()[technique, film]
    if said == "–":
        with pytest.raises(nacre.NacreError, match=f'with technique "{technique}"'):
            nacre.template_spectrum(template(film, technique))
        return
    found = mean_difference(film, technique)
    assert found == pytest.approx(float(said), abs=EXACT if float(said) < 1 else 0.05)
