# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The index that a compiled glass uses in Cycles, against its template's own formula."""

from __future__ import annotations

import re
import tomllib

import numpy as np
import pytest

from support.paths import ROOT, TEMPLATES, materials_folder

# Lines of hydrogen and helium that define n_d and the Abbe number, and what a spectrum spans.
LINES_NM = [486.1327, 587.5618, 656.2725]
WITHIN_NM = [365.0, 400.0, 434.6, 501.57, 546.07, 700.0, 768.2, 825.0]
GLASSES = ["n_bk7", "sf11", "water", "diamond"]


def sellmeier(b: list[float], c: list[float], nm: np.ndarray) -> np.ndarray:
    """n² = 1 + Σ b λ² / (λ² − c), λ in µm, c in µm²."""
    squared = (nm / 1000) ** 2
    return np.sqrt(1 + sum(b_i * squared / (squared - c_i) for b_i, c_i in zip(b, c, strict=True)))


def template_index(material: str, nm: np.ndarray) -> np.ndarray:
    """From the template and, for a medium of the library, the published file: both glasses of the
    library are given by refractiveindex.info's formula 2, n² = 1 + c₁ + Σ c₂ᵢ λ² / (λ² − c₂ᵢ₊₁)."""
    text = (TEMPLATES / f"{material}.toml").read_text("utf-8")
    glass = tomllib.loads(text)["glass"]
    if "sellmeier" in glass:
        return sellmeier(glass["sellmeier"]["b"], glass["sellmeier"]["c"], nm)
    file = ROOT / "cpp_tools" / "data" / "optical_constants" / f"{glass['medium']}.yml"
    (coefficients,) = re.findall(
        r"type: formula 2\n.*\n\s*coefficients: (.+)", file.read_text("utf-8")
    )
    first, *pairs = map(float, coefficients.split())
    assert first == 0.0
    return sellmeier(pairs[0::2], pairs[1::2], nm)


def probe(material: str, nm: list[float]) -> str:
    """The compiled shader as it is, but for its two ends: column i draws wavelength i, and what
    reaches the lobe as the path's index is shown."""
    text = (materials_folder() / material / f"{material}.osl").read_text("utf-8")
    shader = f"shader nacre_{material}\n"
    assert text.count(shader) == 1
    body = text.partition(shader)[2]
    assert body.count("nacre_draw_wavelength(") == body.count("nacre_glass_lobe(") == 1
    choices = " : ".join(f"i == {i} ? {value}" for i, value in enumerate(nm))
    ends = (
        "nacre_wavelength probe_wavelength()\n{\n    int i = (int)floor(P[0]);\n"
        f"    nacre_wavelength drawn = {{ {choices} : 0.0, color(1.0) }};\n    return drawn;\n}}\n"
        "#define nacre_draw_wavelength(edges, weight, u) probe_wavelength()\n"
        "#define nacre_glass_lobe(n, roughness, index, index_rgb, weight) (color(index) * emission())\n"
    )
    return text.replace(shader, ends + shader)


@pytest.mark.parametrize("material", GLASSES)
def test_index_in_use_is_the_template_s(blender, material):
    nm = LINES_NM + WITHIN_NM
    used = blender.run(probe(material, nm), len(nm))[:, 0].astype(np.float64)
    expected = template_index(material, np.array(nm))
    error = np.abs(used / expected - 1)
    print(f"{material}, Blender {blender.version}: largest at F, d, C {error[:3].max():.1e}, "
          f"elsewhere {error[3:].max():.1e}")  # fmt: skip
    assert error[:3].max() <= 1e-6
    assert error[3:].max() <= 2e-6


def test_every_glass_is_checked():
    glasses = {
        file.stem
        for file in TEMPLATES.glob("*.toml")
        if "glass" in tomllib.loads(file.read_text("utf-8"))
    }
    assert glasses == set(GLASSES)
