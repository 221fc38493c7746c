# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Where a wedge of glass sends each wavelength, against Snell's law."""

from __future__ import annotations

import re

import numpy as np
import pytest

from support.paths import materials_folder
from support.prism import C_NM, D_NM, F_NM, exit_angle, index

LINES_NM = (F_NM, D_NM, C_NM)
GLASSES = ("n_bk7", "sf11", "water", "diamond")
APEX_DEG = 30.0
INCIDENCE_DEG = 45.0
# A twentieth of a pixel of a picture that is 4096 pixels and 40 degrees wide.
TOLERANCE = 0.05 * np.radians(40.0) / 4096

# Paths that crossed both faces by a wavelength within 0.5 nm of a line see the angle of their
# direction, 1, and the wavelength in µm, over what the glass has put on them. Others see black.
WORLD = """
shader world(
    float line_nm = 550.0,
    {arrays},
    output color value = 0.0
)
{{
    int reflections = 0;
    int transmissions = 0;
    getattribute("path:glossy_depth", reflections);
    getattribute("path:transmission_depth", transmissions);
    nacre_wavelength path = nacre_draw_wavelength(wavelength_edges, wavelength_weight,
                                                  nacre_path_random());
    if (reflections == 0 && transmissions == 2 && fabs(path.nm - line_nm) < 0.5)
        value = color(4.0 + I[0], 1.0, 1e-3 * path.nm) / path.weight;
}}
"""


def world(material: str) -> str:
    """With the functions and the wavelengths of the compiled glass itself."""
    text = (materials_folder() / material / f"{material}.osl").read_text("utf-8")
    head, _, body = text.partition(f"shader nacre_{material}\n")
    edges, weight = (
        re.search(rf"{kind} {name}\[\d+\] = {{[^}}]*}}", body)[0]
        for kind, name in (("float", "wavelength_edges"), ("color", "wavelength_weight"))
    )
    return head + WORLD.format(arrays=f"{edges},\n    {weight}")


@pytest.fixture(scope="module")
def rays(blender):
    """Exit angle and wavelength of what came through near a line."""

    def job(material: str, nm: float) -> dict:
        return {
            "material": material,
            "apex_deg": APEX_DEG,
            "incidence_deg": INCIDENCE_DEG,
            "line_nm": nm,
            "samples": 2048,
            "world": world(material),
        }

    pictures = blender.pictures("prism.render", job)

    def ray(material: str, nm: float) -> tuple[float, float]:
        sine, seen, um = pictures(material, nm).mean(axis=(0, 1))
        assert seen > 0
        return np.arcsin(sine / seen - 4.0), 1000 * um / seen

    return ray


@pytest.mark.parametrize("material", GLASSES)
def test_wedge_sends_each_wavelength_where_snell_s_law_does(blender, rays, material):
    incidence, apex = np.radians(INCIDENCE_DEG), np.radians(APEX_DEG)
    expected, errors = [], []
    for line in LINES_NM:
        angle, nm = rays(material, line)
        assert abs(nm - line) < 0.5
        expected.append(exit_angle(index(material, nm), incidence, apex))
        errors.append(angle - expected[-1])
    largest = np.abs(errors).max()
    print(f"{material}, Blender {blender.version}: largest error {largest:.1e} rad")
    assert np.ptp(expected) > 20 * TOLERANCE  # the dispersion that is seen
    assert largest <= TOLERANCE
