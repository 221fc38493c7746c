# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Media by the names that people type."""

from __future__ import annotations

import pytest
from nacre_extension.films.media import meant

MEDIA = (
    ("air", ""),
    ("Cu/Johnson", "Copper"),
    ("TiO2/Devore", "Titanium dioxide, rutile"),
    ("TiO2/Sarkar", "Titanium dioxide, a film"),
    ("brass/Querry", "Brass, 70 % copper"),
    ("water/Daimon-20C", "Water, 20 °C"),
    ("water/Hale", "Water, 25 °C, with absorption"),
)


@pytest.mark.parametrize(
    ("typed", "wanted"),
    [
        ("copper", "Cu/Johnson"),
        (" Copper ", "Cu/Johnson"),
        ("cu", "Cu/Johnson"),
        ("cu/johnson", "Cu/Johnson"),
        ("AIR", "air"),
        ("water", "water/Daimon-20C"),
        ("water, 25 °c, with absorption", "water/Hale"),
        ("tio2", "TiO2/Devore"),
        ("rutile", "TiO2/Devore"),
        # What could be several things, and what is none, is said and not guessed.
        ("titanium", "titanium"),
        ("foobar", "foobar"),
        ("", ""),
    ],
)
def test_a_medium_is_known_by_its_name(typed, wanted):
    assert meant(typed, MEDIA) == wanted
