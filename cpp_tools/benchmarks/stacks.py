# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Film stacks and film tables: Nacre's Python package against tmm, tmm_fast and tmm_faster."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import version

import numpy as np
import tmm
import tmm_fast
import tmm_faster
from measure import Result, best_seconds

import nacre

WAVELENGTHS_NM = np.arange(360.0, 831.0)
ANGLES_DEG = np.linspace(0.0, 89.0, 256)
LAYERS = (1, 4, 16, 40)
TARGETS = {"tmm": 5000.0, "tmm_fast": 100.0, "tmm_faster": 40.0}
TABLE = 256, 1024  # cosines, thicknesses
TABLE_TARGET = 300.0
DEPTH_TARGET = 1 / 1.2  # 16 layers cost at most 1.2 times what 1 layer costs


@dataclass(frozen=True)
class Job:
    """Layers that all differ, absorb and disperse, over a grid of angles and wavelengths."""

    layers: int
    angle_deg: np.ndarray
    wavelength_nm: np.ndarray

    @cached_property
    def n(self) -> np.ndarray:
        """Shape (wavelengths, media)."""
        inverse_square = (500.0 / self.wavelength_nm) ** 2
        bases = np.random.default_rng(550).uniform(1.3, 2.5, self.layers)
        films = [base + 0.04 * inverse_square + 1e-3j * inverse_square for base in bases]
        air = np.ones_like(self.wavelength_nm)
        return np.stack([air, *films, 1.5 + 0.02 * inverse_square], axis=-1).astype(complex)

    @cached_property
    def d_nm(self) -> np.ndarray:
        return np.random.default_rng(551).uniform(50.0, 200.0, self.layers)

    @property
    def steps(self) -> int:
        return self.layers * self.angle_deg.size * self.wavelength_nm.size


def with_nacre(job: Job) -> np.ndarray:
    done = nacre.stack(job.n, job.d_nm, job.angle_deg[:, None], job.wavelength_nm, pol="u")
    return np.array([done.R, done.T])


def with_tmm(job: Job) -> np.ndarray:
    d = [np.inf, *job.d_nm, np.inf]
    values = [
        [
            tmm.unpolarized_RT(n, d, angle, nm)
            for n, nm in zip(job.n, job.wavelength_nm, strict=True)
        ]
        for angle in np.radians(job.angle_deg)
    ]
    return np.array([[[point[key] for point in row] for row in values] for key in "RT"])


def with_tmm_fast(job: Job) -> np.ndarray:
    n = np.ascontiguousarray(job.n.T)[None]
    d = np.array([[np.inf, *(job.d_nm * 1e-9), np.inf]])
    grid = np.radians(job.angle_deg), job.wavelength_nm * 1e-9
    s, p = (tmm_fast.coh_tmm(polarisation, n, d, *grid) for polarisation in "sp")
    return np.array([(s[key][0] + p[key][0]) / 2 for key in "RT"])


def with_tmm_faster(job: Job) -> np.ndarray:
    d = [np.inf, *job.d_nm, np.inf]
    done = tmm_faster.calc_coherent(job.n, d, job.angle_deg, job.wavelength_nm)
    return np.array([done[key].T for key in ("R_avg", "T_avg")])


PEERS = {"tmm": with_tmm, "tmm_fast": with_tmm_fast, "tmm_faster": with_tmm_faster}


def compare(name: str, job: Job, ours: float | None = None) -> Result:
    """@param ours: ns that Nacre takes a step, where the peer cannot take Nacre's whole grid."""
    peer = PEERS[name]
    difference = np.abs(with_nacre(job) - peer(job)).max()
    if not difference < 1e-9:
        raise SystemExit(f"{name}: other R, T than ours, by {difference:.1e}: not one job")
    mine, theirs = best_seconds([lambda: with_nacre(job), lambda: peer(job)])
    return Result(
        id=f"stack-{job.layers}-{name}",
        what=f"unpolarised R and T, {job.layers} layers, ns per angle, wavelength and layer",
        ours=mine / job.steps * 1e9 if ours is None else ours,
        peer=theirs / job.steps * 1e9,
        peer_version=f"{name} {version(name)}",
        target=TARGETS[name],
    )


def stack_results(layers: int) -> list[Result]:
    job = Job(layers, ANGLES_DEG, WAVELENGTHS_NM)
    arrays = [compare(name, job) for name in ("tmm_fast", "tmm_faster")]
    # tmm takes its points one by one and gets fewer of them.
    few = Job(layers, ANGLES_DEG[::85], WAVELENGTHS_NM[::10])
    return [*arrays, compare("tmm", few, ours=min(result.ours for result in arrays))]


def bake_table(layers: int, precision: str = "double") -> nacre.FilmLut:
    job = Job(layers, ANGLES_DEG, WAVELENGTHS_NM)
    return nacre.film_lut(
        list(job.n.T),
        job.d_nm,
        varying=layers // 2,
        range_=(0.0, 1023.0),
        transmittance=True,
        tolerance=None,
        size=TABLE,
        precision=precision,
    )


def table_results() -> list[Result]:
    """tmm_fast gets every 64th thickness, eight in a call, times 64: the whole takes it minutes."""
    columns, rows = TABLE
    angles = np.arccos(np.linspace(0.0, 1.0, columns)[1:])
    job = Job(1, np.degrees(angles), WAVELENGTHS_NM)

    def peer() -> None:
        n = np.repeat(job.n.T[None], 8, axis=0)
        for thicknesses in np.arange(0.0, rows, 64.0).reshape(-1, 8):
            d = np.array([[np.inf, nm * 1e-9, np.inf] for nm in thicknesses])
            for polarisation in "sp":
                tmm_fast.coh_tmm(polarisation, n, d, angles, WAVELENGTHS_NM * 1e-9)

    single = [lambda: bake_table(1, "single"), lambda: bake_table(16, "single")]
    one_layer, deep, single_one, single_deep, theirs = best_seconds(
        [lambda: bake_table(1), lambda: bake_table(16), *single, peer], 3
    )
    what = f"table of {columns} x {rows} film colours from {WAVELENGTHS_NM.size} wavelengths, s"
    return [
        Result(
            id="table-1-tmm_fast",
            what=f"{what}, 1 layer",
            ours=one_layer,
            peer=theirs * 64,
            peer_version=f"tmm_fast {version('tmm_fast')}, 1/64 of the table",
            target=TABLE_TARGET,
        ),
        Result(
            id="table-16-1",
            what=f"{what}, 16 layers",
            ours=deep,
            peer=one_layer,
            peer_version="Nacre with 1 layer",
            target=DEPTH_TARGET,
        ),
        *(
            Result(
                id=f"table-{layers}-single",
                what=f"{what}, {layers} layers, single precision",
                ours=ours,
                peer=double,
                peer_version="Nacre in double precision",
                target=1.0,
            )
            for layers, ours, double in ((1, single_one, one_layer), (16, single_deep, deep))
        ),
    ]


def results() -> list[Result]:
    stacks = [result for layers in LAYERS for result in stack_results(layers)]
    return [*stacks, *table_results()]
