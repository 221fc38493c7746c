# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a rough film reflects in a white furnace, by light that walks from facet to facet.

The random walk of Heitz et al. 2016 (Smith model, GGX, uniform heights) for many paths at once, apart
from the tool's own; each path multiplies the spectra of the facets that it meets.
"""

from __future__ import annotations

import numpy as np

import nacre
from support.truth import WAVELENGTHS, spectra

NODES = np.linspace(0.0, 1.0, 513)
MOST_BOUNCES = 12


def facet_spectra(template: dict, value: float | None, spread_nm: float) -> np.ndarray:
    """R of shape (513, 471) over the facet's cosine; grazing facets mirror."""
    others = spectra(template, value, NODES[1:], spread_nm=spread_nm).R
    return np.concatenate([np.ones((1, len(WAVELENGTHS))), others])


def smith_lambda(w: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """Λ of directions of shape (n, 3); -1 - Λ(-w) where they point down."""
    slope = ((alpha * w[:, :2]) ** 2).sum(axis=1) / np.maximum(w[:, 2] ** 2, 1e-18)
    return 0.5 * (np.copysign(np.sqrt(1 + slope), w[:, 2]) - 1)


def visible_normals(view: np.ndarray, alpha: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Facets as they are seen along `view`, by the sampling of Dupuy and Benyoub 2023."""
    stretched = np.concatenate([alpha * view[:, :2], view[:, 2:]], axis=1)
    stretched /= np.linalg.norm(stretched, axis=1, keepdims=True)
    azimuth = 2 * np.pi * random.random(len(view))
    z = (1 - random.random(len(view))) * (1 + stretched[:, 2]) - stretched[:, 2]
    across = np.sqrt(np.clip(1 - z * z, 0, 1))
    half = stretched + np.stack([across * np.cos(azimuth), across * np.sin(azimuth), z], axis=1)
    facet = np.concatenate([alpha * half[:, :2], np.maximum(half[:, 2:], 1e-12)], axis=1)
    return facet / np.linalg.norm(facet, axis=1, keepdims=True)


def walk(cosine: float, alpha: tuple[float, float], paths: int, azimuth: float = 0.0):
    """Arrays of facet cosines, of shape (paths that left, bounces), one for each number of bounces."""
    random = np.random.default_rng(550)
    alpha = np.array(alpha)
    sine = np.sqrt(1 - cosine**2)
    w = np.tile([-sine * np.cos(azimuth), -sine * np.sin(azimuth), -cosine], (paths, 1))
    height = np.ones(paths)
    met = np.empty((paths, 0))
    for _ in range(MOST_BOUNCES + 1):
        u, passed = random.random(len(w)), smith_lambda(w, alpha)
        leaves = (w[:, 2] > 0) & (u >= 1 - height ** np.maximum(passed, 0))
        if met.shape[1]:
            yield met[leaves]
        w, height, met, u, passed = (a[~leaves] for a in (w, height, met, u, passed))
        height = np.clip(height * (1 - u) ** (-1 / passed), 0, 1)
        facet = visible_normals(-w, alpha, random)
        cosines = np.clip(-(w * facet).sum(axis=1), 0, 1)
        w = w + 2 * cosines[:, None] * facet
        met = np.concatenate([met, cosines[:, None]], axis=1)


def furnace_colours(
    template: dict,
    value: float | None,
    cosines: np.ndarray,
    alpha: tuple[float, float],
    azimuths: np.ndarray | None = None,
    paths: int = 80_000,
    spread_nm: float = 0.0,
) -> np.ndarray:
    """Linear Rec. 709 of the light that a rough film reflects under D65 from everywhere, all bounces;
    shape (len(cosines), 3). Azimuths are those of the views, from the direction of alpha[0]."""
    of_facets = facet_spectra(template, value, spread_nm)
    last = len(NODES) - 1
    albedos = np.zeros((len(cosines), len(WAVELENGTHS)))
    for i, cosine in enumerate(cosines):
        azimuth = 0.0 if azimuths is None else azimuths[i]
        for met in walk(cosine, alpha, paths, azimuth):
            if met.shape[1] == 1:  # a mean over facets, through weights
                weights = np.bincount(np.rint(met[:, 0] * last).astype(int), minlength=last + 1)
                albedos[i] += weights @ of_facets / paths
            elif len(met):
                nearest = np.rint(met * last).astype(int)
                albedos[i] += np.prod(of_facets[nearest], axis=1).sum(axis=0) / paths
    return nacre.spectrum_to_colour(WAVELENGTHS, albedos).rgb
