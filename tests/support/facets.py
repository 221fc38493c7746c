# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Smith's model of a rough surface, GGX, apart from the tool's own; directions have shape (n, 3)."""

from __future__ import annotations

import numpy as np


def smith_lambda(w: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """Λ of directions; -1 - Λ(-w) where they point down."""
    slope = ((alpha * w[:, :2]) ** 2).sum(axis=1) / np.maximum(w[:, 2] ** 2, 1e-18)
    return 0.5 * (np.copysign(np.sqrt(1 + slope), w[:, 2]) - 1)


def visible_normals(
    view: np.ndarray, alpha: np.ndarray, turn: np.ndarray, rise: np.ndarray
) -> np.ndarray:
    """Facets as they are seen along `view`, by the sampling of Dupuy and Benyoub 2023; `turn` and
    `rise` are numbers in [0, 1), two for each facet."""
    stretched = np.concatenate([alpha * view[:, :2], view[:, 2:]], axis=1)
    stretched /= np.linalg.norm(stretched, axis=1, keepdims=True)
    azimuth = 2 * np.pi * turn
    z = (1 - rise) * (1 + stretched[:, 2]) - stretched[:, 2]
    across = np.sqrt(np.clip(1 - z * z, 0, 1))
    half = stretched + np.stack([across * np.cos(azimuth), across * np.sin(azimuth), z], axis=1)
    facet = np.concatenate([alpha * half[:, :2], np.maximum(half[:, 2:], 1e-12)], axis=1)
    return facet / np.linalg.norm(facet, axis=1, keepdims=True)
