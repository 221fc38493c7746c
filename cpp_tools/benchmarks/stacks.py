# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Unpolarised R and T of film stacks: Nacre's Python package against tmm and tmm_fast."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import version

import numpy as np
import tmm
import tmm_fast
from measure import Result, best_seconds

import nacre

AMBIENT, SUBSTRATE, HIGH, LOW = 1.0, 1.52, 2.4 + 1e-3j, 1.46
TMM_TARGET, TMM_FAST_TARGET = 5000.0, 100.0


@dataclass(frozen=True)
class Job:
    """Quarter-wave layers for 550 nm over a grid of angles and wavelengths."""

    layers: int
    angle_deg: np.ndarray
    wavelength_nm: np.ndarray

    @property
    def n(self) -> np.ndarray:
        film = [HIGH if i % 2 == 0 else LOW for i in range(self.layers)]
        return np.array([AMBIENT, *film, SUBSTRATE], dtype=complex)

    @property
    def d_nm(self) -> np.ndarray:
        return 550.0 / 4.0 / self.n[1:-1].real

    @property
    def steps(self) -> int:
        return self.layers * self.angle_deg.size * self.wavelength_nm.size


def with_nacre(job: Job) -> np.ndarray:
    done = nacre.stack(job.n, job.d_nm, job.angle_deg[:, None], job.wavelength_nm, pol="u")
    return np.array([done.R, done.T])


def with_tmm(job: Job) -> np.ndarray:
    d = [np.inf, *job.d_nm, np.inf]
    values = [
        [tmm.unpolarized_RT(job.n, d, angle, nm) for nm in job.wavelength_nm]
        for angle in np.radians(job.angle_deg)
    ]
    return np.array([[[point[key] for point in row] for row in values] for key in "RT"])


def with_tmm_fast(job: Job) -> np.ndarray:
    n = np.broadcast_to(job.n[:, None], (1, job.layers + 2, job.wavelength_nm.size)).copy()
    d = np.array([[np.inf, *(job.d_nm * 1e-9), np.inf]])
    grid = np.radians(job.angle_deg), job.wavelength_nm * 1e-9
    s, p = (tmm_fast.coh_tmm(polarisation, n, d, *grid) for polarisation in "sp")
    return np.array([(s[key][0] + p[key][0]) / 2 for key in "RT"])


def compare(peer, name: str, job: Job, target: float) -> Result:
    difference = np.abs(with_nacre(job) - peer(job)).max()
    if not difference < 1e-9:
        raise SystemExit(f"{name}: other R, T than ours, by {difference:.1e}: not one job")
    ours, theirs = best_seconds([lambda: with_nacre(job), lambda: peer(job)])
    return Result(
        id=f"stack-{job.layers}-{name}",
        what=f"unpolarised R and T, {job.layers} layers, ns per angle, wavelength and layer",
        ours=ours / job.steps * 1e9,
        peer=theirs / job.steps * 1e9,
        peer_version=f"{name} {version(name)}",
        target=target,
    )


def results() -> list[Result]:
    grid = np.linspace(0.0, 80.0, 33), np.arange(360.0, 831.0)
    # tmm takes its points one by one and needs fewer of them; Nacre is timed on the same few.
    coarse = np.linspace(0.0, 80.0, 5), np.linspace(360.0, 830.0, 95)
    return [
        result
        for layers in (1, 16)
        for result in (
            compare(with_tmm, "tmm", Job(layers, *coarse), TMM_TARGET),
            compare(with_tmm_fast, "tmm_fast", Job(layers, *grid), TMM_FAST_TARGET),
        )
    ]
