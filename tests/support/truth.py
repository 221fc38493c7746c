# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a pixel of the furnace sphere must be: `nacre.stack`, 471 wavelengths, no table.

The stack is read from the template here, apart from the library's own reader, and each index comes
from `nacre library show`; reflectances become colours by `nacre.spectrum_to_colour`.
"""

from __future__ import annotations

import json
import tomllib
from functools import lru_cache

import numpy as np

import nacre
from support.paths import TEMPLATES
from support.tool import nacre as run_nacre

WAVELENGTHS = list(range(360, 831))


@lru_cache
def library_index(key: str) -> tuple[complex, ...]:
    if key == "air":
        return (1.0 + 0.0j,) * len(WAVELENGTHS)
    at = [option for nm in WAVELENGTHS for option in ("--at", nm)]
    shown = json.loads(run_nacre("library", "show", key, *at, "--json"))
    return tuple(complex(row["n"], row["k"]) for row in shown["at"])


def index(medium: dict) -> np.ndarray:
    """n + ik on the grid of a medium as a template writes it."""
    if "medium" in medium:
        return np.array(library_index(medium["medium"]))
    if "cauchy" in medium:
        um = np.array(WAVELENGTHS) / 1000
        n = sum(c / um ** (2 * i) for i, c in enumerate(medium["cauchy"]))
        return n + 1j * medium.get("k", 0.0)
    if "abbe" in medium:
        return cauchy_from_abbe(**medium["abbe"])
    return np.full(len(WAVELENGTHS), complex(medium["n"], medium.get("k", 0.0)))


def cauchy_from_abbe(n_d: float, v_d: float) -> np.ndarray:
    """a + b/λ² with n(587.56 nm) = n_d and (n_d − 1)/(n(486.13 nm) − n(656.27 nm)) = V_d."""
    b = (n_d - 1) / v_d / (0.48613**-2 - 0.65627**-2)
    um = np.array(WAVELENGTHS) / 1000
    return n_d + b * (um**-2 - 0.58756**-2) + 0j


def layers_of(template: dict) -> list[dict]:
    layers = []
    for layer in template["layer"]:
        layers += layer["group"] * layer["repeat"] if "group" in layer else [layer]
    return layers


def material_template(material: str) -> dict:
    """The template of a material of the library."""
    return tomllib.loads((TEMPLATES / f"{material}.toml").read_text("utf-8"))


def template_names() -> list[str]:
    """Materials of the library, by the names of their templates."""
    return sorted(file.stem for file in TEMPLATES.glob("*.toml"))


def varied(template: dict) -> dict | None:
    """{default, min, max} of what is the second axis of the tables: one thickness, or the scale."""
    if "scale" in template.get("stack", {}):
        return template["stack"]["scale"]
    given = [layer["thickness_nm"] for layer in layers_of(template)]
    return next((nm for nm in given if isinstance(nm, dict) and nm.get("varies")), None)


def thicknesses(template: dict, value: float | None) -> list[float]:
    """nm of each layer with `value` for what varies: one thickness, or the scale of all coherent
    layers."""
    scale = value if "scale" in template.get("stack", {}) else 1.0
    result = []
    for layer in layers_of(template):
        nm = layer["thickness_nm"]
        if isinstance(nm, dict):
            nm = value if nm.get("varies") else nm["default"]
        result.append(nm * (scale if layer.get("coherent", True) else 1.0))
    return result


def spectra(
    template: dict,
    value: float | None,
    cosines: np.ndarray,
    from_below: bool = False,
    spread_nm: float = 0.0,
):
    """R and T of the film, each of shape (len(cosines), 471); cosines in the medium that the light
    comes from. `spread_nm`: standard deviation of the thickness that varies."""
    layers = layers_of(template)
    media = [index(m) for m in (template["ambient"], *layers, template["substrate"])]
    nm = thicknesses(template, value)
    coherent = [layer.get("coherent", True) for layer in layers]
    varies = [isinstance(layer["thickness_nm"], dict) for layer in layers]
    spread = [spread_nm if layer_varies else 0.0 for layer_varies in varies]
    turned = slice(None, None, -1 if from_below else 1)
    return nacre.stack(
        np.stack(media[turned], axis=-1),
        nm[turned],
        np.degrees(np.arccos(cosines))[:, None],
        WAVELENGTHS,
        coherent=coherent[turned],
        spread_nm=spread[turned],
    )


def colour(spectrum: np.ndarray) -> np.ndarray:
    """Linear Rec. 709 under D65."""
    return nacre.spectrum_to_colour(WAVELENGTHS, spectrum).rgb


def exact_colours(
    template: dict, value: float | None, cosines: np.ndarray, spread_nm: float = 0.0
) -> dict[str, np.ndarray]:
    """Linear Rec. 709 of R and T under D65, each of shape (len(cosines), 3)."""
    answer = spectra(template, value, cosines, spread_nm=spread_nm)
    return {"R": colour(answer.R), "T": colour(answer.T)}


def colours_over_base(
    template: dict, value: float | None, cosines: np.ndarray, base: np.ndarray
) -> np.ndarray:
    """R + T · base · T_inner/(1 − base · R_inner), each a colour: film over a matt base. The inner
    ones are means over the hemisphere below, ∫ 2c f(c) dc by 200 Gauss points either side of the
    angle where the least index on the way begins to reflect totally."""
    outside = np.real(index(template["ambient"])).max()
    inside = np.real(index(template["substrate"])).max()
    edge = np.sqrt(max(0.0, 1.0 - (outside / inside) ** 2))
    points, weights = np.polynomial.legendre.leggauss(200)
    ends = ((0.0, edge), (edge, 1.0)) if edge > 0.0 else ((0.0, 1.0),)
    c = np.concatenate([(b - a) / 2 * points + (a + b) / 2 for a, b in ends])
    w = np.concatenate([(b - a) / 2 * weights for a, b in ends]) * 2 * c
    inner = spectra(template, value, c, from_below=True)
    returned, leaving = colour(w @ inner.R), colour(w @ inner.T)
    outer = exact_colours(template, value, cosines)
    return outer["R"] + outer["T"] * base * leaving / (1 - base * returned)


def pixel_places(size: int, quarter: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Where the pixel centres of the furnace are on a sphere of radius 1, rightwards and upwards;
    `quarter`: of the upper right quarter, which has all that the other three have."""
    centre = (np.arange(size) + 0.5) / size * 2 - 1
    right, up = np.meshgrid(centre, -centre)
    return (
        (right[: size // 2, size // 2 :], up[: size // 2, size // 2 :]) if quarter else (right, up)
    )


def pixel_cosines(
    size: int, edge: float = 0.0, quarter: bool = False
) -> tuple[np.ndarray, np.ndarray]:
    """Cosines at the pixel centres of the furnace, and which pixels count: those whose centre lies on
    the sphere, or further inside than `edge`, a share of the radius."""
    right, up = pixel_places(size, quarter)
    squared = right**2 + up**2
    return np.sqrt(np.clip(1 - squared, 0, 1)), squared < (1 - edge) ** 2
