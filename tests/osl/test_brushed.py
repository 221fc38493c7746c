# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A brushed surface sends on to other facets what one bounce loses, by the fit that materials carry."""

from __future__ import annotations

import re
from itertools import product

import numpy as np
import pytest

from support.osl import osl_array
from support.paths import materials_folder
from support.rough_truth import smith_lambda, visible_normals

BRUSHED = "tempered_stainless_steel"
CASES = tuple(product((0.0, 0.5, 0.8), (0.35, 0.65), (0, 45, 90), (0.2, 0.5, 0.9)))


def fit() -> str:
    """The coefficients as a compiled material declares them."""
    text = (materials_folder() / BRUSHED / f"{BRUSHED}.osl").read_text(encoding="utf-8")
    found = re.search(r"float lost\[12\] = \{[^}]*\};", text)
    assert found
    return found.group()


class Lattice:
    """Stands for a generator of random numbers: the two of each facet lie on an even lattice."""

    size = 256**2

    def __init__(self):
        steps = (np.arange(256) + 0.5) / 256
        self._axes = iter(np.meshgrid(steps, steps))

    def random(self, count: int) -> np.ndarray:
        assert count == self.size
        return next(self._axes).ravel()


def albedo(cosine: float, azimuth: float, alpha: tuple[float, float]) -> float:
    """What perfect mirrors send back in one bounce, masking correlated in height."""
    sine = np.sqrt(1 - cosine**2)
    view = np.array([[sine * np.cos(azimuth), sine * np.sin(azimuth), cosine]])
    alpha = np.array(alpha)
    facet = visible_normals(np.repeat(view, Lattice.size, axis=0), alpha, Lattice())
    out = 2 * (facet @ view[0])[:, None] * facet - view
    leaves = out[:, 2] > 0
    above = smith_lambda(view, alpha)
    share = (1 + above) / (1 + above + smith_lambda(out[leaves], alpha))
    return share.sum() / len(out)


@pytest.fixture
def stand_in(blender) -> np.ndarray:
    """Roughness, scale and cosine of the surface that further bounces are looked up on."""
    names = ("anisotropy", "roughness", "azimuth", "cosine")
    columns = zip(names, np.array(CASES).T, strict=True)
    body = "".join(osl_array(name, values) for name, values in columns) + fit()
    # The picture is seen from above: the normal leans away from the view, which is along z.
    body += """
    float c = cosine[i], s = sqrt(1.0 - c * c), turn = radians(azimuth[i]);
    vector along = vector(-c, 0.0, s) * cos(turn) + vector(0.0, 1.0, 0.0) * sin(turn);
    nacre_facets facets = nacre_brushed_facets(normal(s, 0.0, c), along, c, roughness[i],
                                               anisotropy[i], 0.0, lost, 0.03, 0.05);
    value = color(facets.further, facets.further_scale, facets.seen_cosine);"""
    return blender.values(["nacre_rough.h"], body, len(CASES))


def test_white_facets_stay_white(stand_in):
    """Dark where a very rough surface is seen flat along its grooves, nowhere brighter than the fit."""
    sent = []
    for (anisotropy, roughness, azimuth, cosine), (further, scale, seen) in zip(
        CASES, stand_in, strict=True
    ):
        alpha = (roughness**2 * (1 - anisotropy), roughness**2 / (1 - anisotropy))
        alpha = tuple(np.minimum(1, alpha))
        once = albedo(cosine, np.radians(azimuth), alpha)
        here = albedo(seen, 0.0, (further**2, further**2))
        sent.append(once * (1 + scale * (1 - here) / here))
    print(f"{min(sent):.4f} to {max(sent):.4f} of the light")
    assert max(sent) <= 1.025
    assert min(sent) >= 0.9


def test_a_surface_without_a_direction_stands_for_itself(stand_in):
    for (anisotropy, roughness, _, cosine), values in zip(CASES, stand_in, strict=True):
        if anisotropy == 0.0:
            np.testing.assert_allclose(values, [roughness, 1.0, cosine], rtol=1e-5)
