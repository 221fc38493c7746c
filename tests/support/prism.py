# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a wedge of glass does with light of one wavelength: Snell's and Fresnel's laws."""

from __future__ import annotations

import json
import tomllib

import numpy as np

from .paths import TEMPLATES
from .tool import nacre

F_NM, D_NM, C_NM = 486.1327, 587.5618, 656.2725


def index(material: str, nm: float) -> float:
    """Of a glass of the library, by what its template states."""
    text = (TEMPLATES / f"{material}.toml").read_text("utf-8")
    glass = tomllib.loads(text)["glass"]
    if "medium" in glass:
        shown = json.loads(nacre("library", "show", glass["medium"], "--at", nm, "--json"))
        return shown["at"][0]["n"]
    squared = (nm / 1000) ** 2
    terms = zip(glass["sellmeier"]["b"], glass["sellmeier"]["c"], strict=True)
    return np.sqrt(1 + sum(b * squared / (squared - c) for b, c in terms))


def cauchy(n_d: float, v_d: float, nm: float) -> float:
    """Of two terms, through the index of the d line and with that Abbe number."""
    of, f, d, c = ((1000.0 / line) ** 2 for line in (nm, F_NM, D_NM, C_NM))
    return n_d + (n_d - 1.0) / v_d * (of - d) / (f - c)


def exit_angle(n: float, incidence: float, apex: float) -> float:
    """Of light that fell along −z, from −z towards −x: Snell's law at both faces."""
    return _angles(n, incidence, apex)[2] + incidence - apex


def passed(n: float, incidence: float, apex: float) -> float:
    """Of unpolarised light, through both faces."""
    first, second, last = _angles(n, incidence, apex)
    return np.mean(
        [
            (1.0 - _fresnel(1.0, n, incidence, first)[way])
            * (1.0 - _fresnel(n, 1.0, second, last)[way])
            for way in (0, 1)
        ]
    )


def _angles(n: float, incidence: float, apex: float) -> tuple[float, float, float]:
    """Behind the first face, before the second and behind it, each from the normal."""
    first = np.arcsin(np.sin(incidence) / n)
    second = apex - first
    return first, second, np.arcsin(n * np.sin(second))


def _fresnel(n: float, m: float, before: float, behind: float) -> tuple[float, float]:
    """Reflectance for s and p."""
    s = (n * np.cos(before) - m * np.cos(behind)) / (n * np.cos(before) + m * np.cos(behind))
    p = (m * np.cos(before) - n * np.cos(behind)) / (m * np.cos(before) + n * np.cos(behind))
    return s**2, p**2
