# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Stacks by the textbook's characteristic matrices in 60 digits, where nothing overflows or cancels.

Macleod, Thin-Film Optical Filters, section 2: (B, C) = Π (cos δ, -i sin δ/η; -i η sin δ, cos δ) (1, η_f)
with the signs of exp(-iωt); r = (η_0 B - C)/(η_0 B + C), t = 2 η_0/(η_0 B + C).
"""

from __future__ import annotations

from typing import NamedTuple

import mpmath
from mpmath import mp, mpc, mpf

mp.dps = 60


class Exact(NamedTuple):
    R: mpf
    T: mpf
    r: mpc
    t: mpc


def _forward_root(square):
    q = mpmath.sqrt(square)
    return -q if q.imag < 0 or (q.imag == 0 and q.real < 0) else q


def exact_stack(n, d_nm, angle_deg, wavelength_nm, pol) -> Exact:
    media = [mpc(complex(value)) for value in n]
    sine = mpmath.sin(mpf(angle_deg) * mp.pi / 180)
    q = [_forward_root(medium**2 - (media[0] * sine) ** 2) for medium in media]
    eta = [
        normal if pol == "s" else normal / medium**2
        for normal, medium in zip(q, media, strict=True)
    ]
    b, c = mpc(1), eta[-1]
    for j in range(len(d_nm), 0, -1):
        delta = 2 * mp.pi * q[j] * mpf(d_nm[j - 1]) / mpf(wavelength_nm)
        cos, i_sin = mpmath.cos(delta), 1j * mpmath.sin(delta)
        b, c = b * cos - i_sin * c / eta[j], c * cos - i_sin * b * eta[j]
    r = (eta[0] * b - c) / (eta[0] * b + c)
    t = 2 * eta[0] / (eta[0] * b + c)
    transmittance = eta[-1].real / eta[0].real * abs(t) ** 2
    # The matrices carry H for p; E = H/n.
    return Exact(abs(r) ** 2, transmittance, r, t if pol == "s" else t * media[0] / media[-1])
