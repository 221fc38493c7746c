# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Shapes, types and memory layouts of the arrays of `nacre.stack`; threads."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import nacre

RANDOM = np.random.default_rng(550)
N = np.array([1, 2.1 + 0.02j, 1.46, 1.52])
D = np.array([80.0, 120.0])
WAVELENGTHS = np.linspace(360, 830, 95)
ANGLES = np.linspace(0, 85, 18)


def assert_same_bits(ours, expected):
    for mine, theirs in zip(ours, expected, strict=True):
        if theirs is None:
            assert mine is None
        else:
            np.testing.assert_array_equal(mine, theirs)


def one_by_one(n, d_nm, angle, wavelength, pol, shape):
    """Every element by a call of its own."""
    n, d_nm = (
        np.broadcast_to(n, (*shape, n.shape[-1])),
        np.broadcast_to(d_nm, (*shape, d_nm.shape[-1])),
    )
    angle, wavelength = np.broadcast_to(angle, shape), np.broadcast_to(wavelength, shape)
    results = np.empty((*shape, 3))
    for place in np.ndindex(shape):
        single = nacre.stack(n[place], d_nm[place], angle[place], wavelength[place], pol)
        results[place] = single.R, single.T, single.A
    return results


SHAPES = {
    "scalars": ((), (), (), (), ()),
    "wavelengths": ((), (), (), (95,), (95,)),
    "angles-by-wavelengths": ((), (), (18, 1), (95,), (18, 95)),
    "dispersion": ((95,), (), (18, 1), (95,), (18, 95)),
    "thicknesses": ((), (40,), (), (), (40,)),
    "thicknesses-by-angles": ((), (40, 1), (18,), (), (40, 18)),
    "all-axes": ((95,), (5, 1, 1), (6, 1), (95,), (5, 6, 95)),
    "leading-ones": ((1, 1), (1, 3), (4, 1), (1, 1), (4, 3)),
    "media-by-item": ((7,), (7,), (7,), (7,), (7,)),
    "33-items": ((33,), (), (), (), (33,)),
    "empty": ((), (), (0,), (), (0,)),
    "empty-in-the-middle": ((), (), (3, 0, 1), (2,), (3, 0, 2)),
}


@pytest.mark.parametrize("pol", ["s", "p", "u"])
@pytest.mark.parametrize("name", SHAPES)
def test_leading_shapes_broadcast(name, pol):
    n_shape, d_shape, angle_shape, wavelength_shape, shape = SHAPES[name]
    n = np.array([1, 2.1, 1.46, 1.52]) + RANDOM.uniform(0, 0.3, (*n_shape, 4))
    n = n + 1j * np.concatenate(
        [np.zeros((*n_shape, 1)), RANDOM.uniform(0, 0.2, (*n_shape, 3))], axis=-1
    )
    d_nm = RANDOM.uniform(0, 400, (*d_shape, 2))
    angle = RANDOM.uniform(0, 89, angle_shape)
    wavelength = RANDOM.uniform(360, 830, wavelength_shape)
    ours = nacre.stack(n, d_nm, angle, wavelength, pol)
    assert ours.R.shape == ours.T.shape == ours.A.shape == shape
    assert (ours.r is None) == (pol == "u")
    if pol != "u":
        assert ours.r.shape == ours.t.shape == shape
        assert ours.r.dtype == ours.t.dtype == np.complex128
    # A call by itself takes the same path for its only item: the same bits.
    np.testing.assert_array_equal(
        np.stack(ours[:3], axis=-1), one_by_one(n, d_nm, angle, wavelength, pol, shape)
    )


def test_no_layers():
    result = nacre.stack([1, 1.5], [], [0, 0], 550, "s")
    assert result.R == pytest.approx([0.04, 0.04], abs=1e-15)


DTYPES = {
    "float32": np.float32,
    "float16": np.float16,
    "int": np.int64,
    "uint8": np.uint8,
    "longdouble": np.longdouble,
    "big-endian": np.dtype(">f8"),
}


@pytest.mark.parametrize("name", DTYPES)
def test_other_types_count_as_the_numbers_they_hold(name):
    dtype = DTYPES[name]
    n, d_nm = np.array([1, 2, 3], dtype), np.array([80], dtype)
    angle, wavelength = np.array([0, 30, 77], dtype), np.array(250, dtype)
    ours = nacre.stack(n, d_nm, angle, wavelength, "p")
    assert ours.R.dtype == np.float64
    assert_same_bits(
        ours,
        nacre.stack([1.0, 2.0, 3.0], [80.0], [0.0, 30.0, 77.0], 250.0, "p"),
    )


def test_complex64_counts_as_the_numbers_it_holds():
    n = np.array([1, 2.1 + 0.02j, 1.52], np.complex64)
    assert_same_bits(
        nacre.stack(n, [80], 30, 550, "s"),
        nacre.stack(n.astype(np.complex128), [80], 30, 550, "s"),
    )


def test_lists_and_tuples_and_arrays_are_the_same():
    expected = nacre.stack(N, D, ANGLES[:, None], WAVELENGTHS, "s")
    ours = nacre.stack(
        N.tolist(), tuple(D.tolist()), ANGLES[:, None].tolist(), WAVELENGTHS.tolist(), "s"
    )
    assert_same_bits(ours, expected)


def test_memory_layout_does_not_count():
    shape = (18, 95)
    n = np.broadcast_to(N, (*shape, 4)) + RANDOM.uniform(0, 0.1, (*shape, 1)) * [0, 1, 1, 1]
    d_nm = D + RANDOM.uniform(0, 50, (*shape, 1))
    angle, wavelength = np.broadcast_arrays(ANGLES[:, None], WAVELENGTHS)
    expected = nacre.stack(n.copy(), d_nm.copy(), angle.copy(), wavelength.copy(), "p")

    every_other = np.zeros((*shape, 8), complex)
    every_other[..., ::2] = n
    layouts = {
        "fortran": [np.asfortranarray(array) for array in (n, d_nm, angle, wavelength)],
        "strided": [every_other[..., ::2], d_nm, angle, wavelength],
        "reversed": [n[::-1].copy()[::-1], d_nm[:, ::-1].copy()[:, ::-1], angle, wavelength],
        "broadcast": [n, d_nm, angle, wavelength],  # views with strides of 0
    }
    for arrays in layouts.values():
        assert_same_bits(nacre.stack(*arrays, "p"), expected)


def test_inputs_are_read_only_and_stay_as_they_are():
    arrays = [N.copy(), D.copy(), ANGLES[:, None].copy(), WAVELENGTHS.copy()]
    for array in arrays:
        array.setflags(write=False)
    before = [array.copy() for array in arrays]
    result = nacre.stack(*arrays, "s")
    for array, copy in zip(arrays, before, strict=True):
        np.testing.assert_array_equal(array, copy)
    result.R[...] = 0  # results belong to the caller
    assert result.T.max() > 0


def test_threads_get_the_same_bits():
    def job(_):
        return nacre.stack(N, D, ANGLES[:, None], WAVELENGTHS, "s")

    expected = job(None)
    with ThreadPoolExecutor(4) as pool:
        for result in pool.map(job, range(24)):
            assert_same_bits(result, expected)


def test_threads_get_their_own_errors():
    def job(i):
        with pytest.raises(nacre.NacreError) as caught:
            nacre.stack([1, 1.3, 1.5], [-1.0 - i], 0, 550)
        return str(caught.value)

    with ThreadPoolExecutor(4) as pool:
        for i, message in enumerate(pool.map(job, range(200))):
            assert message == f"d_nm[0]: must be finite and ≥ 0 (got {-1 - i}) (item 0)"
