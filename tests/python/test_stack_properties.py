# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What holds for every stack, on 12 000 random ones; `pytest -s` prints the seeds.

NACRE_SEED=N draws others.
"""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np
import pytest

import nacre
from nacre import StackResult

STACKS_PER_DEPTH = 2000
DEPTHS = (1, 2, 3, 5, 9, 17)
FIRST_SEED = int(os.environ.get("NACRE_SEED", "550"))


class Stacks(NamedTuple):
    """n: (count, layers + 2); d_nm: (count, layers); angle_deg, wavelength_nm: (count,)."""

    n: np.ndarray
    d_nm: np.ndarray
    angle_deg: np.ndarray
    wavelength_nm: np.ndarray


def draw(layers: int, *, absorbing: bool) -> Stacks:
    seed = FIRST_SEED + layers
    print(f"seed {seed}, {layers} layers")
    rng = np.random.default_rng(seed)
    count = STACKS_PER_DEPTH
    n = rng.uniform(1.2, 2.6, (count, layers + 2)).astype(complex)
    if absorbing:
        kind = rng.random(n.shape)
        n += 1j * np.where(kind < 0.4, 0.0, rng.uniform(0.0, 0.3, n.shape))
        metal = rng.uniform(0.05, 3.5, n.shape) + 1j * rng.uniform(1.0, 6.0, n.shape)
        n = np.where(kind > 0.85, metal, n)
    n[:, 0] = rng.uniform(1.0, 1.6, count)
    return Stacks(
        n,
        rng.uniform(0.0, 400.0, (count, layers)),
        rng.uniform(0.0, 89.5, count),
        rng.uniform(360.0, 830.0, count),
    )


def solve(stacks: Stacks, pol: str) -> StackResult:
    return nacre.stack(*stacks, pol=pol)


each = pytest.mark.parametrize("pol", ["s", "p", "u"])
depths = pytest.mark.parametrize("layers", DEPTHS)


@depths
@each
def test_energy_is_conserved(layers, pol):
    """A lossless stack returns everything; an absorbing one keeps a share between 0 and 1."""
    clear, dark = (solve(draw(layers, absorbing=a), pol) for a in (False, True))
    np.testing.assert_allclose(clear.R + clear.T, 1.0, rtol=0, atol=1e-12)
    np.testing.assert_allclose(dark.R + dark.T + dark.A, 1.0, rtol=0, atol=1e-14)
    for share in (dark.R, dark.T, dark.A):
        assert share.min() >= -1e-12
        assert share.max() <= 1 + 1e-12


@depths
@each
def test_transmittance_is_the_same_from_both_sides(layers, pol):
    """Between transparent media; layers may absorb."""
    stacks = draw(layers, absorbing=True)
    stacks.n[:, -1] = stacks.n[:, -1].real.clip(1.0)
    sine = stacks.n[:, 0].real * np.sin(np.radians(stacks.angle_deg)) / stacks.n[:, -1].real
    open_ = sine < 0.999  # not beyond the critical angle, where the way back does not exist
    assert open_.sum() > STACKS_PER_DEPTH / 3
    down = Stacks(*(array[open_] for array in stacks))
    up = down._replace(
        n=down.n[:, ::-1].copy(),
        d_nm=down.d_nm[:, ::-1].copy(),
        angle_deg=np.degrees(np.arcsin(sine[open_])),
    )
    # The angle back is rounded: near grazing its cosine has lost digits.
    slack = 1e-12 + 1e-15 / np.sqrt(1 - sine[open_] ** 2) ** 2
    assert (np.abs(solve(down, pol).T - solve(up, pol).T) <= slack).all()


@depths
@each
def test_splitting_a_layer_changes_nothing(layers, pol):
    stacks = draw(layers, absorbing=True)
    whole = solve(stacks, pol)
    at = layers // 2
    d = stacks.d_nm
    halves = [d[:, :at], 0.3 * d[:, at : at + 1], 0.7 * d[:, at : at + 1], d[:, at + 1 :]]
    split = stacks._replace(
        n=np.insert(stacks.n, at + 1, stacks.n[:, at + 1], axis=1),
        d_nm=np.concatenate(halves, axis=1),
    )
    agree(solve(split, pol), whole)


@depths
@each
def test_matched_layers_at_both_ends_change_nothing(layers, pol):
    """The substrate does not absorb here: light would be lost on the way through its layer."""
    stacks = draw(layers, absorbing=True)
    stacks.n[:, -1] = stacks.n[:, -1].real.clip(1.7)  # above every ambient: never evanescent
    embedded = stacks._replace(
        n=np.concatenate([stacks.n[:, :1], stacks.n, stacks.n[:, -1:]], axis=1),
        d_nm=np.pad(stacks.d_nm, [(0, 0), (1, 1)], constant_values=250.0),
    )
    agree(solve(embedded, pol), solve(stacks, pol))


@depths
@each
def test_at_grazing_incidence_everything_is_reflected(layers, pol):
    stacks = draw(layers, absorbing=True)
    # Media next to the ambient's index keep letting light in until very close to 90 degrees.
    stacks.n[:, 1:] += 0.5
    graze = stacks._replace(angle_deg=np.full_like(stacks.angle_deg, 90 - 1e-7))
    result = solve(graze, pol)
    assert result.R.min() > 1 - 1e-5
    assert result.T.max() < 1e-5


@depths
@each
def test_vanishing_layers_leave_the_bare_substrate(layers, pol):
    stacks = draw(layers, absorbing=True)
    bare = stacks._replace(n=stacks.n[:, [0, -1]], d_nm=stacks.d_nm[:, :0])
    expected = solve(bare, pol)
    agree(solve(stacks._replace(d_nm=np.zeros_like(stacks.d_nm)), pol), expected)
    # And the limit is reached smoothly: phases of 1e-7 nm change R by some 1e-9.
    thin = solve(stacks._replace(d_nm=np.full_like(stacks.d_nm, 1e-7)), pol)
    np.testing.assert_allclose(thin.R, expected.R, rtol=0, atol=1e-6)


@depths
@each
def test_an_opaque_layer_hides_what_is_below(layers, pol):
    stacks = draw(layers, absorbing=True)
    stacks.n[:, -2] = 0.2 + 3.4j
    stacks.d_nm[:, -1] = 1e5
    bulk = stacks._replace(n=stacks.n[:, :-1], d_nm=stacks.d_nm[:, :-1])
    opaque = solve(stacks, pol)
    np.testing.assert_allclose(opaque.R, solve(bulk, pol).R, rtol=0, atol=1e-12)
    assert (opaque.T == 0).all()


def agree(found: StackResult, expected: nacre.StackResult) -> None:
    np.testing.assert_allclose(found.R, expected.R, rtol=0, atol=2e-12)
    np.testing.assert_allclose(found.T, expected.T, rtol=0, atol=2e-12)
