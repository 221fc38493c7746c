# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours that materials of the library are known by."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nacre
from support.colours import lab

TEMPLATES = Path(__file__).resolve().parents[2] / "osl" / "templates"


def lightness_chroma_hue(material: str, value: float, angle_deg: float = 0.0):
    """CIE L*, C*ab, hue angle in degrees of the exact reflectance."""
    text = (TEMPLATES / f"{material}.toml").read_text("utf-8")
    rgb = nacre.template_spectrum(text, value, angle_deg).colours[0]
    lightness, a, b = lab(rgb)
    return lightness, np.hypot(a, b), np.degrees(np.arctan2(b, a)) % 360


# Names in the order of rising temperature, as charts for tool steel have them, e.g.
# https://gdgwsteel.org/news/Tempering-colors.html; yellow is near 90°, blue near 290°.
TEMPER = [
    (10, "pale straw", 80, 100),
    (20, "straw", 80, 100),
    (33, "brown", 60, 85),
    (38, "purple", 310, 360),
    (48, "blue", 280, 310),
    (65, "light blue", 250, 275),
]


@pytest.mark.parametrize(("thickness_nm", "name", "first", "last"), TEMPER)
def test_temper_colours_of_steel(thickness_nm, name, first, last):
    _, _, hue = lightness_chroma_hue("tempered_steel", thickness_nm)
    assert first <= hue <= last, name


def test_temper_colours_of_steel_come_in_order():
    """From yellow over red to blue, never back; straw and light blue are the light ones."""
    steps = [lightness_chroma_hue("tempered_steel", d) for d in np.arange(20.0, 66.0)]
    turned = np.unwrap([hue for _, _, hue in steps], period=360)
    assert (np.diff(turned) < 0).all()
    lightness = [step[0] for step in steps]
    darkest = int(np.argmin(lightness))
    assert 35 <= 20 + darkest <= 50
    assert lightness[0] > 50 < lightness[-1]


@pytest.mark.parametrize("beetle", ["jewel_beetle", "raja_beetle", "rose_chafer"])
def test_beetles_shift_from_green_to_blue(beetle):
    hues = [lightness_chroma_hue(beetle, 1.0, angle)[2] for angle in (0, 20, 40, 60)]
    assert (np.diff(hues) > 0).all()
    assert 120 <= hues[0] <= 185  # green
    assert 260 <= hues[-1] <= 310  # blue


def test_black_film_of_soap_is_black_and_thicker_ones_have_colours():
    black, chroma = (
        lightness_chroma_hue("soap_film", 5.0)[0],
        lightness_chroma_hue("soap_film", 400.0)[1],
    )
    assert black < 2
    assert chroma > 20
