# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What one bounce leaves of light on rough glass, against the lobes of Walter et al. 2007."""

from __future__ import annotations

from itertools import product

import numpy as np

from support.osl import osl_array

CASES = tuple(product((0.1, 0.36, 1.0), (0.2, 0.5, 0.9), (1.33, 1.5, 2.4)))
POLAR, AZIMUTHS = 600, 400


def smith(cosine, alpha: float):
    return 0.5 * (np.sqrt(1 + alpha**2 * (1 - cosine**2) / cosine**2) - 1)


def fresnel(cosine, index: float):
    inside = np.sqrt(1 - (1 - cosine**2) / index**2)
    s = (cosine - index * inside) / (cosine + index * inside)
    p = (index * cosine - inside) / (index * cosine + inside)
    return (s**2 + p**2) / 2


def ggx(up, alpha: float):
    return alpha**2 / (np.pi * (up**2 * (alpha**2 - 1) + 1) ** 2)


def kept(alpha: float, mu: float, index: float) -> float:
    """Equations 20 and 21, summed over outgoing directions, with masking correlated in height; light
    comes from outside."""
    z = (np.arange(POLAR) + 0.5)[:, None] / POLAR
    azimuth = np.pi * (np.arange(AZIMUTHS) + 0.5) / AZIMUTHS
    across, sine = np.sqrt(1 - z**2), np.sqrt(1 - mu**2)
    x, y = across * np.cos(azimuth), across * np.sin(azimuth)
    masked = 1 / (1 + smith(mu, alpha) + smith(z, alpha))

    length = np.sqrt((x + sine) ** 2 + y**2 + (z + mu) ** 2)
    cosine = (x * sine + z * mu + 1) / length
    mirrored = fresnel(cosine, index) * ggx((z + mu) / length, alpha) * masked / (4 * mu)

    # Out is (x, y, -z), the facet along -(in + index out), turned up.
    h = np.stack([-(sine + index * x), -index * y, -(mu - index * z) + 0 * x])
    h *= np.sign(h[2]) / np.sqrt((h**2).sum(axis=0))
    towards, away = h[0] * sine + h[2] * mu, h[0] * x + h[1] * y - h[2] * z
    meets = (towards > 0) & (away < 0)
    towards, away = np.where(meets, towards, 1.0), np.where(meets, away, -1.0)
    spread = -towards * away * index**2 / (mu * (towards + index * away) ** 2)
    refracted = meets * (1 - fresnel(towards, index)) * spread * ggx(h[2], alpha) * masked
    return float((mirrored + refracted).sum() * 2 * np.pi / (POLAR * AZIMUTHS))


def test_one_bounce_keeps_what_its_lobes_send(blender):
    columns = zip(("alpha", "mu", "index"), np.array(CASES).T, strict=True)
    body = "".join(osl_array(name, values) for name, values in columns)
    body += "value = color(nacre_kept_light(mu[i], alpha[i], index[i]));"
    found = blender.values(["nacre_glass.h"], body, len(CASES))[:, 0]
    expected = np.array([kept(*case) for case in CASES])
    error = found / expected - 1
    print(f"off by up to {np.abs(error).max():.4f}, {error.mean():+.4f} on average")
    np.testing.assert_allclose(found, expected, rtol=6e-3)
    assert expected.min() < 0.75  # there is something to find
