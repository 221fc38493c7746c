# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a mirror shows of the lights that a scene can be put into."""

from __future__ import annotations

import numpy as np
import pytest

MADE_HERE = ("STUDIO", "SOFTBOXES", "WINDOW", "SKY")
ENVIRONMENTS = (
    "CITY", "COURTYARD", "FOREST", "INTERIOR", "NIGHT", "PHOTO_STUDIO", "SUNRISE", "SUNSET",
)  # fmt: skip
LUMINANCE = (0.2126, 0.7152, 0.0722)
# A pixel has sixteen samples, and edges of softboxes are as sharp as half of one.
ALIKE = 0.03


def mirror(blender, light: str, strength=1.0, rotation_deg=0.0, turn_deg=0.0) -> np.ndarray:
    return blender.picture(
        "lighting.mirror",
        light=light,
        strength=strength,
        rotation_deg=rotation_deg,
        turn_deg=turn_deg,
    )


def test_these_are_all(blender):
    assert tuple(blender.call("lighting.names")) == (*MADE_HERE, *ENVIRONMENTS)


@pytest.mark.parametrize("light", [*MADE_HERE, *ENVIRONMENTS])
def test_there_is_light_and_dark_to_mirror(blender, light):
    shown = mirror(blender, light) @ LUMINANCE
    assert np.all(np.isfinite(shown))
    assert 0.03 < np.mean(shown) < 3.0, np.mean(shown)
    dark, bright = np.percentile(shown, (10, 99))
    assert bright > 0.4, bright
    assert bright > 3.0 * dark, (dark, bright)


@pytest.mark.parametrize("light", [*MADE_HERE, "SUNSET"])
def test_a_light_turns_as_its_angle_says(blender, light):
    straight = mirror(blender, light, turn_deg=20.0)
    turned = mirror(blender, light, rotation_deg=70.0, turn_deg=90.0)
    assert np.mean(np.abs(turned - straight)) < ALIKE * np.mean(straight)
    away = mirror(blender, light, rotation_deg=70.0, turn_deg=20.0)
    assert np.mean(np.abs(away - straight)) > 3.0 * ALIKE * np.mean(straight)


@pytest.mark.parametrize("light", ["STUDIO", "SKY", "CITY"])
def test_strength_is_a_factor(blender, light):
    once, twice = mirror(blender, light), mirror(blender, light, strength=2.0)
    np.testing.assert_allclose(twice, 2.0 * once, rtol=1e-3, atol=1e-4)
