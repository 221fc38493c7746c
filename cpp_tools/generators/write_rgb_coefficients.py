# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write cpp_tools/data/cmf/rgb_coefficients_rec709.csv.

    pip install numpy
    python write_rgb_coefficients.py

The table of W. Jakob, J. Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling",
Computer Graphics Forum 38(2), 2019, section 3: coefficients of reflectances
1/2 + x / (2 sqrt(1 + x^2)), x = c0 t^2 + c1 t + c2, t = (wavelength / nm - 595) / 235, whose colour under
D65 (CIE 1931, white adapted by Bradford) is an RGB of Rec.709. Computed here, with damped Gauss-Newton steps
on linear RGB from the grey of the same luminance; nothing is taken from the authors' program.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

DATA = Path(__file__).resolve().parents[1] / "data"
NODES = 16
# Grey 1 would need an infinite coefficient.
BRIGHTEST = 0.9999

BRADFORD = np.array(
    [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]]
)


def read_table(path: Path) -> np.ndarray:
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return np.array([line.split(",") for line in lines[1:]], dtype=float)


def chromaticity(x: float, y: float) -> np.ndarray:
    return np.array([x / y, 1.0, (1.0 - x - y) / y])


def colour_weights() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Wavelengths, RGB of unit reflectance at each of them (3, 471), luminance of the channels."""
    observer = read_table(DATA / "cmf" / "cie_1931_2deg_1nm.csv")
    light = read_table(DATA / "spd" / "cie_d65.csv")
    wavelengths = observer[:, 0]
    power = np.interp(wavelengths, light[:, 0], light[:, 1])
    weights = observer[:, 1:].T * power
    weights /= weights[1].sum()
    d65 = chromaticity(0.3127, 0.3290)
    primaries = np.stack(
        [chromaticity(0.64, 0.33), chromaticity(0.30, 0.60), chromaticity(0.15, 0.06)], axis=1
    )
    to_xyz = primaries * np.linalg.solve(primaries, d65)
    gains = (BRADFORD @ d65) / (BRADFORD @ weights.sum(axis=1))
    adapt = np.linalg.inv(BRADFORD) @ (gains[:, None] * BRADFORD)
    return wavelengths, np.linalg.inv(to_xyz) @ adapt @ weights, to_xyz[1]


def reflectances(coefficients: np.ndarray, powers: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Reflectances and their derivatives by x."""
    x = coefficients @ powers
    root = np.sqrt(1.0 + x * x)
    return 0.5 + 0.5 * x / root, 0.5 / root**3


def solve(colours: np.ndarray, steps: int = 100) -> tuple[np.ndarray, np.ndarray]:
    """Coefficients (count, 3) and what is left of the RGB error (count,)."""
    wavelengths, weights, luminance = colour_weights()
    t = (wavelengths - 595.0) / 235.0
    powers = np.stack([t * t, t, np.ones_like(t)])
    grey = np.clip(colours @ luminance, 1e-6, 1.0 - 1e-6)
    c = np.zeros_like(colours)
    c[:, 2] = (grey - 0.5) / np.sqrt(grey * (1.0 - grey))
    damping = np.full(len(colours), 1e-6)

    values, slopes = reflectances(c, powers)
    residual = values @ weights.T - colours
    for _ in range(steps):
        jacobian = np.einsum("nl,al,bl->nab", slopes, weights, powers, optimize=True)
        gradient = np.einsum("nab,na->nb", jacobian, residual)
        normal = np.einsum("nab,nac->nbc", jacobian, jacobian)
        diagonal = np.einsum("nii->ni", normal)
        index = np.arange(3)
        normal[:, index, index] += damping[:, None] * diagonal + 1e-300
        trial = c - np.linalg.solve(normal, gradient[..., None])[..., 0]
        trial_values, trial_slopes = reflectances(trial, powers)
        trial_residual = trial_values @ weights.T - colours
        better = (trial_residual**2).sum(axis=1) < (residual**2).sum(axis=1)
        c[better], slopes[better] = trial[better], trial_slopes[better]
        residual[better] = trial_residual[better]
        damping = np.where(better, 0.2 * damping, 8.0 * damping + 1e-12)
    return c, np.abs(residual).max(axis=1)


def smoothstep(x: np.ndarray) -> np.ndarray:
    return x * x * (3.0 - 2.0 * x)


def node_colours() -> np.ndarray:
    """Shape (3 * (NODES - 1) * NODES * NODES, 3): by the largest channel, its value, the next
    channel over it, the one after that over it."""
    inner = smoothstep(smoothstep(np.arange(1, NODES) / (NODES - 1)))
    largest = np.minimum(inner, BRIGHTEST)
    ratio = np.arange(NODES) / (NODES - 1)
    z, y, x = np.meshgrid(largest, ratio, ratio, indexing="ij")
    colours = []
    for channel in range(3):
        rgb = np.empty((*z.shape, 3))
        rgb[..., channel] = z
        rgb[..., (channel + 1) % 3] = z * x
        rgb[..., (channel + 2) % 3] = z * y
        colours.append(rgb.reshape(-1, 3))
    return np.concatenate(colours)


def main() -> None:
    coefficients, errors = solve(node_colours())
    print(f"largest error left in linear RGB: {errors.max():.2g}")
    header = [
        "Coefficients of smooth reflectances by Rec.709 colour, under D65 and the CIE 1931 observer.",
        "Method: W. Jakob, J. Hanika, Computer Graphics Forum 38(2), 2019, "
        "https://doi.org/10.1111/cgf.13626",
        "Written by generators/write_rgb_coefficients.py, which states the function and its variable.",
        f"Rows: largest channel R, G, B; its value at {NODES - 1} nodes s(s(i / {NODES - 1})), i > 0,",
        f"s(x) = x^2 (3 - 2x), {BRIGHTEST} for 1; second channel after it over it, then first, each at",
        f"{NODES} equal steps from 0 to 1; the last runs fastest.",
        "Licence: Apache-2.0",
    ]
    lines = [f"# {line}" for line in header] + ["c0,c1,c2"]
    lines += [",".join(f"{value:.6g}" for value in row) for row in coefficients]
    path = DATA / "cmf" / "rgb_coefficients_rec709.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
