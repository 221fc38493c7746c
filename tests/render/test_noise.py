# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The comparison of noisy pictures tells noise from faults."""

from __future__ import annotations

import numpy as np
import pytest

from support import noise

SIZE = 64


def picture(seed: int, sigma: float = 0.03, bright: float = 0.0) -> np.ndarray:
    """A ramp with noise; `bright`: the share of pixels that a single bright path hits."""
    random = np.random.default_rng(seed)
    ramp = np.linspace(0.1, 0.9, SIZE)[None, :, None] * np.array([1.0, 0.6, 0.3])
    values = ramp + sigma * random.standard_normal((SIZE, SIZE, 3))
    hit = random.random((SIZE, SIZE, 1)) < bright
    return np.where(hit, values + 2.0 * random.exponential(size=(SIZE, SIZE, 1)), values)


def stored(**options) -> noise.Reference:
    return noise.calibrated([[picture(100 * b + i, **options) for i in range(8)] for b in (1, 2)])


@pytest.mark.parametrize("bright", [0.0, 0.01])
@pytest.mark.parametrize("seed", range(1000, 1008))
def test_another_seed_passes(seed, bright):
    found = noise.compare(picture(seed, bright=bright), stored(bright=bright))
    assert found.passes, found


@pytest.mark.parametrize("bright", [0.0, 0.002])
@pytest.mark.parametrize(
    "fault",
    [
        pytest.param(lambda p: p * 1.03, id="3 % brighter"),
        pytest.param(lambda p: p[:, :, [1, 0, 2]], id="channels swapped"),
        pytest.param(lambda p: np.roll(p, 2, axis=1), id="moved by two pixels"),
        pytest.param(lambda p: p[::-1], id="upside down"),
        pytest.param(lambda p: p + np.where(np.arange(SIZE) < 4, 0.1, 0)[:, None, None], id="edge"),
    ],
)
def test_faults_do_not_pass(fault, bright):
    rotated = [
        [np.swapaxes(picture(100 * b + i, bright=bright), 0, 1) for i in range(8)] for b in (1, 2)
    ]
    # Upside down shows where the ramp runs downwards, to the side where it runs across.
    ref = noise.calibrated(rotated)
    found = noise.compare(fault(np.swapaxes(picture(0, bright=bright), 0, 1)), ref)
    sideways = noise.compare(fault(picture(0, bright=bright)), stored(bright=bright))
    assert not (found.passes and sideways.passes), (found, sideways)


def test_a_hole_of_one_block_does_not_pass():
    """Black where nothing else is, as a missing object would be."""
    spoilt = picture(0)
    spoilt[8:16, 40:48] = 0.0
    assert not noise.compare(spoilt, stored()).passes


def test_deviation_is_about_each_blender_s_own_mean():
    """A difference between the Blenders is not taken for noise."""
    first = [picture(i) for i in range(8)]
    other = [1.5 * one for one in first]
    both = noise.reference([first, other])
    apart = [noise.reference([one]).sigma for one in (first, other)]
    np.testing.assert_allclose(both.sigma**2, np.mean(np.square(apart), axis=0))
    assert both.freedom == 14
    assert not noise.compare(first[0], both).passes
