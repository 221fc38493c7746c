# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Whether a noisy picture can be one of those that a reference was made of.

A reference has the mean and the standard deviation of pictures that differ in their seed. A new
picture of as many samples is held against it by Student's test of each value, as Mitsuba's render
tests do (src/render/tests/test_renders.py), with Šidák's correction for the number of values. Single
bright paths have no normal distribution: as many pixels may fail as of the reference's own pictures,
each against the others, and a few more. Means over blocks show what noise hides in a pixel; none may
be further off than chance allows, or than those pictures are. The mean
ΔE00 of the blocks has a limit of its own beyond what noise alone explains.

All of that is done to values x/(1 + |x|), of the pictures that make the reference too: highlights
count relative to their brightness, and no path outweighs a block.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import stats

from support.colours import delta_e

SIGNIFICANCE = 0.01
FAILING_PERCENT = 0.25  # beyond that of the reference's own pictures
BLOCK_ALLOWANCE = 1.5  # times the worst block of those
BLOCKS = (8, 32)
DELTA_E = 0.25  # of the largest blocks
# Standard deviation of what processors, rounding to half and the Blenders differ in.
FLOOR = 5e-4


@dataclass(frozen=True)
class Reference:
    """Mean and standard deviation of held() pictures, shape (height, width, 3), estimated from so many."""

    mean: np.ndarray
    sigma: np.ndarray
    pictures: int
    blenders: int
    # Of its own pictures, each against the others: the most, and the furthest.
    failing_percent: float = 0.0
    worst_block: float = 0.0

    @property
    def freedom(self) -> int:
        """Deviations are taken from the mean of each Blender's pictures."""
        return self.pictures - self.blenders


@dataclass(frozen=True)
class Comparison:
    failing_percent: float
    failing_limit: float
    worst_block: float
    block_limit: float
    delta_e: float
    delta_e_of_noise: float

    @property
    def passes(self) -> bool:
        return (
            self.failing_percent <= self.failing_limit
            and self.worst_block <= self.block_limit
            and self.delta_e <= DELTA_E + self.delta_e_of_noise
        )

    def __str__(self) -> str:
        return (
            f"{self.failing_percent:.2f} % of the pixels (limit {self.failing_limit:.2f}) are "
            f"unlike the reference, the worst block is off by {self.worst_block:.1f} deviations "
            f"(limit {self.block_limit:.1f}), dE00 of the blocks {self.delta_e:.3f} "
            f"(limit {DELTA_E} + {self.delta_e_of_noise:.3f})"
        )


def held(picture: np.ndarray) -> np.ndarray:
    return picture / (1 + np.abs(picture))


def scene_linear(values: np.ndarray) -> np.ndarray:
    """What held() made these of."""
    return values / (1 - np.abs(values))


def reference(pictures: list[list[np.ndarray]]) -> Reference:
    """Of the pictures of each Blender."""
    pictures = [[held(picture) for picture in of_one] for of_one in pictures]
    means = [np.mean(of_one, axis=0) for of_one in pictures]
    squares = sum(
        np.sum(np.square(of_one - mean), axis=0)
        for of_one, mean in zip(pictures, means, strict=True)
    )
    count = sum(map(len, pictures))
    sigma = np.sqrt(squares / (count - len(pictures)))
    return Reference(np.mean(means, axis=0), sigma, count, len(pictures))


def _without(pictures: list[list[np.ndarray]], i: int, j: int) -> list[list[np.ndarray]]:
    left = [*pictures]
    left[i] = [*pictures[i][:j], *pictures[i][j + 1 :]]
    return left


def calibrated(pictures: list[list[np.ndarray]]) -> Reference:
    """A reference that knows how many pixels of its own pictures fail, each against the others."""
    found = [
        compare(picture, reference(_without(pictures, i, j)))
        for i, of_one in enumerate(pictures)
        for j, picture in enumerate(of_one)
    ]
    return replace(
        reference(pictures),
        failing_percent=max(one.failing_percent for one in found),
        worst_block=max(one.worst_block for one in found),
    )


def blocks(values: np.ndarray, size: int) -> np.ndarray:
    """Means over squares; what does not fill one at the right and lower edge is left out."""
    height, width = (length // size for length in values.shape[:2])
    cut = values[: height * size, : width * size]
    return cut.reshape(height, size, width, size, -1).mean(axis=(1, 3))


def _threshold(count: int, freedom: float) -> float:
    """Of Student's t for one of so many values."""
    probability = 1 - (1 - SIGNIFICANCE) ** (1 / count)
    return float(stats.t.isf(probability / 2, freedom))


def compare(new: np.ndarray, ref: Reference) -> Comparison:
    new = held(new)
    own = np.square(ref.sigma) * (1 + 1 / ref.pictures)
    pixels = (new - ref.mean) / np.sqrt(own + FLOOR**2)
    unlike = np.abs(pixels) > _threshold(pixels.size, ref.freedom)
    worst, limit = 0.0, BLOCK_ALLOWANCE * ref.worst_block
    for size in BLOCKS:
        means, new_means = blocks(ref.mean, size), blocks(new, size)
        # The floor is no noise: a block has it whole.
        deviations = np.sqrt(blocks(own, size) / size**2 + FLOOR**2)
        worst = max(worst, float(np.abs((new_means - means) / deviations).max()))
        limit = max(limit, _threshold(means.size, ref.freedom * size**2))
    # Noise about the reference, the same in each run.
    random = np.random.default_rng(550)
    colours = scene_linear(means)
    noisy = [
        scene_linear(means + deviations * random.standard_normal(means.shape)) for _ in range(64)
    ]
    return Comparison(
        failing_percent=100.0 * float(unlike.any(axis=-1).mean()),
        failing_limit=ref.failing_percent + FAILING_PERCENT,
        worst_block=worst,
        block_limit=limit,
        delta_e=float(delta_e(scene_linear(new_means), colours).mean()),
        delta_e_of_noise=float(np.mean([delta_e(one, colours).mean() for one in noisy])),
    )
