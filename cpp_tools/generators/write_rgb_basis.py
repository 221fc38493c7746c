# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write cpp_tools/data/cmf/rgb_basis_rec709.csv.

    pip install numpy scipy
    python write_rgb_basis.py

Reflectances of red, green and blue whose sum is 1 everywhere, so that r R(λ) + g G(λ) + b B(λ) has the
colour (r, g, b) of Rec.709 under D65 (CIE 1931, white adapted by Bradford) and stays within 0 and 1
where the colour does: the smoothest ones, by their second differences. The idea is that of I. Mallett,
C. Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance", Eurographics Symposium
on Rendering 2019; computed here, nothing is taken from their data.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import lsq_linear
from write_rgb_coefficients import DATA, colour_weights

STEP_NM = 5
EXACT = 1e4  # weight of what has to hold, against roughness
# What the eye hardly sees decides nothing but has to lie somewhere: flat.


def node_weights() -> tuple[np.ndarray, np.ndarray]:
    """Wavelengths of the nodes, and RGB of hats around them (3, nodes)."""
    wavelengths, weights, _ = colour_weights()
    nodes = np.arange(wavelengths[0], wavelengths[-1] + 1, STEP_NM)
    hats = np.stack([np.interp(wavelengths, nodes, row) for row in np.eye(len(nodes))])
    return nodes, weights @ hats.T


def solve() -> tuple[np.ndarray, np.ndarray]:
    """Wavelengths, and values of the three (nodes, 3)."""
    nodes, weights = node_weights()
    count = len(nodes)
    second = np.diff(np.eye(count), 2, axis=0)
    rows = [np.kron(np.eye(3), second)]
    targets = [np.zeros(3 * len(second))]
    rows.append(EXACT * np.kron(np.eye(3), weights))
    targets.append(EXACT * np.eye(3).ravel())
    rows.append(EXACT * np.kron(np.ones((1, 3)), np.eye(count)))
    targets.append(EXACT * np.ones(count))
    found = lsq_linear(
        np.concatenate(rows), np.concatenate(targets), bounds=(0.0, 1.0), method="bvls", tol=1e-14
    )
    return nodes, found.x.reshape(3, count).T


def main() -> None:
    nodes, values = solve()
    _, weights = node_weights()
    print(f"largest error left in linear RGB: {np.abs(weights @ values - np.eye(3)).max():.2g}")
    header = [
        "Reflectances of red, green and blue of Rec.709 whose sum is 1, under D65 and the CIE 1931 "
        "observer.",
        "Method: I. Mallett, C. Yuksel, Eurographics Symposium on Rendering 2019, "
        "https://doi.org/10.2312/sr.20191216",
        "Written by generators/write_rgb_basis.py; linear between the wavelengths.",
        "Licence: Apache-2.0",
    ]
    lines = [f"# {line}" for line in header] + ["wavelength_nm,red,green,blue"]
    for nm, row in zip(nodes, values, strict=True):
        red, green, _ = (float(f"{value:.7f}") for value in row)
        lines.append(f"{nm:.0f},{red:.7g},{green:.7g},{1.0 - red - green:.7g}")
    path = DATA / "cmf" / "rgb_basis_rec709.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
