# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The debug shader against the geometry of a disc that an orthographic camera sees under a tilt."""

from __future__ import annotations

import math

import numpy as np
import pytest

from support.osl import shader

DEBUG = shader("nacre_debug")
NORMAL, UV, TO_CAMERA, TO_LIGHT, THICKNESS, COSINE = range(6)
SIZE, TILT, SPAN = 16, 0.7, 0.8


def places() -> np.ndarray:
    """Where on the disc, z = 0, each pixel's middle is; shape (SIZE, SIZE, 3). The camera is turned
    by TILT about x, so that its picture's upward axis is foreshortened."""
    row, column = np.mgrid[0:SIZE, 0:SIZE]
    across = SPAN * ((column + 0.5) / SIZE - 0.5)
    up = SPAN * (0.5 - (row + 0.5) / SIZE)
    return np.stack([across, up / math.cos(TILT), np.zeros_like(across)], axis=-1)


@pytest.fixture
def view(blender):
    def render(mode: int, **values) -> np.ndarray:
        return blender.render(
            osl=DEBUG,
            object="disc",
            width=SIZE,
            height=SIZE,
            samples=64,
            span=SPAN,
            tilt=TILT,
            world=0.0,
            motion_blur=False,
            coordinates="uv",
            values={"mode": mode, **values},
        )

    return render


def test_directions_and_cosine(view):
    towards = np.array([0.0, -math.sin(TILT), math.cos(TILT)])
    np.testing.assert_allclose(view(NORMAL), np.broadcast_to([0.5, 0.5, 1.0], (SIZE, SIZE, 3)))
    np.testing.assert_allclose(
        view(TO_CAMERA), np.broadcast_to(0.5 * towards + 0.5, (SIZE, SIZE, 3)), atol=1e-6
    )
    np.testing.assert_allclose(view(COSINE), math.cos(TILT), atol=1e-6)


def test_texture_coordinates(view):
    """Blender lays the unit square around a circle. A pixel's samples spread over it."""
    expected = 0.5 + 0.5 * places() * [1.0, 1.0, 0.0] - [0.0, 0.0, 0.5]
    np.testing.assert_allclose(view(UV), expected, atol=2e-3)


def test_to_light(view):
    lamp = np.array([0.3, -0.2, 0.9])
    away = lamp - places()
    expected = 0.5 + 0.5 * away / np.linalg.norm(away, axis=-1, keepdims=True)
    np.testing.assert_allclose(view(TO_LIGHT, light=lamp.tolist()), expected, atol=2e-3)
    sun = view(TO_LIGHT, light=[0.0, 3.0, 4.0], light_is_sun=1)
    np.testing.assert_allclose(sun, np.broadcast_to([0.5, 0.8, 0.9], (SIZE, SIZE, 3)), atol=1e-6)


@pytest.mark.parametrize(("nm", "shown"), [(350.0, 0.25), (100.0, 0.0), (2000.0, 1.0)])
def test_thickness_is_held_to_its_range(view, nm, shown):
    image = view(THICKNESS, thickness_nm=nm, thickness_min_nm=200.0, thickness_max_nm=800.0)
    np.testing.assert_allclose(image, shown, atol=1e-6)
