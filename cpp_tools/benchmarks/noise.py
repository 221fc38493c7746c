# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""How noisy a picture is."""

from __future__ import annotations

import numpy as np

WHITE = np.array([0.95047, 1.0, 1.08883])
"""D65."""


def lab(xyz: np.ndarray, brightness: float) -> np.ndarray:
    relative = np.maximum(xyz, 0.0) / (WHITE * brightness)
    f = np.where(relative > 216 / 24389, np.cbrt(relative), (24389 / 27 * relative + 16) / 116)
    x, y, z = np.moveaxis(f, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def noise(found: np.ndarray, reference: np.ndarray) -> tuple[float, float]:
    """Of two pictures in XYZ: RMS of Y over its mean, and of a* and b*, where what is brighter than 99 % is
    white."""
    y = reference[..., 1]
    brightness = float(np.percentile(y, 99))
    chroma = lab(found, brightness)[..., 1:] - lab(reference, brightness)[..., 1:]
    return (
        float(np.sqrt(np.mean((found[..., 1] - y) ** 2)) / y.mean()),
        float(np.sqrt((chroma**2).sum(axis=-1).mean())),
    )
