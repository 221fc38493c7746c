# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera that sees what a viewport shows, from the viewport's projection matrix.

Matrices are rows of an OpenGL projection: the camera looks along −z, w is −z in perspective and 1 in
an orthographic view. Every kind of view is covered alike, also one through a camera with zoom and
offset, since the frame is read from the matrix alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

Matrix = Sequence[Sequence[float]]

SENSOR_MM = 36.0
_LEAST_CLIP, _INFINITY = 1e-3, 1e6


@dataclass(frozen=True)
class Frame:
    """Settings of a Blender camera. `sensor_fit` names the side of the picture that `extent` is of."""

    is_perspective: bool
    sensor_fit: str  # HORIZONTAL or VERTICAL
    extent: float  # of the view at distance 1; of an orthographic view at any distance
    shift: tuple[float, float]
    clip: tuple[float, float]
    back: float  # by how much the camera stands behind the view's origin

    @property
    def lens_mm(self) -> float:
        return max(SENSOR_MM / self.extent, 1.0)  # Blender's least

    @property
    def sensor_mm(self) -> float:
        return self.lens_mm * self.extent


def frame(projection: Matrix, size: tuple[int, int]) -> Frame:
    """The camera of a picture of `size` that shows the whole view; where the picture has another
    aspect than the view, it shows more on two sides."""
    is_perspective = projection[3][2] != 0.0
    # Half extents of the view at distance 1, or at any distance in an orthographic view.
    half = (1.0 / projection[0][0], 1.0 / projection[1][1])
    column = 2 if is_perspective else 3
    sign = 1.0 if is_perspective else -1.0
    centre = tuple(sign * projection[i][column] * half[i] for i in (0, 1))
    is_wider = size[0] * half[1] >= size[1] * half[0]
    # What fits is measured along the picture's side that the view fills.
    extent = 2.0 * (half[1] if is_wider else half[0])
    near, far = _clip(projection, is_perspective)
    back = 0.0 if is_perspective else max(0.0, _LEAST_CLIP - near)
    return Frame(
        is_perspective=is_perspective,
        sensor_fit="VERTICAL" if is_wider else "HORIZONTAL",
        extent=extent,
        shift=(centre[0] / extent, centre[1] / extent),
        clip=(near + back, far + back),
        back=back,
    )


def _clip(projection: Matrix, is_perspective: bool) -> tuple[float, float]:
    """Distances of the near and the far plane; the near one of an orthographic view lies behind."""
    a, b = projection[2][2], projection[2][3]
    if is_perspective:
        # In single precision a distant far plane rounds to a = −1: it is at infinity then.
        return b / (a - 1.0), b / (a + 1.0) if a < -1.0 else _INFINITY
    return (b + 1.0) / a, (b - 1.0) / a


def height_for(width: int, region: tuple[int, int]) -> int:
    """Of a picture with the region's aspect."""
    return max(1, round(width * region[1] / region[0]))
