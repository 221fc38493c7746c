# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines and profiles of plates."""

from __future__ import annotations

import math


def round_edges(bottom: float, top: float, radius: float) -> list[tuple[float, float]]:
    """Profile of a plate."""
    steps = 5
    turns = [0.5 * math.pi * i / steps for i in range(steps + 1)]
    curve = [(radius * (1.0 - math.sin(a)), radius * (1.0 - math.cos(a))) for a in turns]
    return [(i, bottom + z) for i, z in curve] + [(i, top - z) for i, z in reversed(curve)]


def softened(corners, cut: float):
    """Corners as short arcs."""
    points = []
    count = len(corners)
    for i, (x, y) in enumerate(corners):
        ends = []
        for j in (i - 1, (i + 1) % count):
            dx, dy = corners[j][0] - x, corners[j][1] - y
            length = math.hypot(dx, dy)
            ends.append((x + cut * dx / length, y + cut * dy / length))
        (ax, ay), (bx, by) = ends
        for t in (0.0, 0.25, 0.5, 0.75, 1.0):
            p, q, s = (1 - t) ** 2, 2 * t * (1 - t), t * t
            points.append((p * ax + q * x + s * bx, p * ay + q * y + s * by))
    return points
