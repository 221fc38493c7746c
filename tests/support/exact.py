# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours by `nacre eval` at 1 nm, for what the tool bakes and exports."""

from __future__ import annotations

import numpy as np

GRID = list(range(360, 831))


def colours_of_spectra(nacre, stacks, quantity="R", **options):
    """Linear Rec.709 of stacks without dispersion, each by its spectrum at 1 nm. All in one call:
    the tool takes longer to start than to compute."""
    records = [{**stack, "wavelength_nm": nm, "pol": "u"} for stack in stacks for nm in GRID]
    answers = nacre.evaluate("stack", records)
    values = np.reshape([answer[quantity] for answer in answers], (len(stacks), len(GRID)))
    spectra = [
        {"wavelength_nm": GRID, "values": row, "kind": "reflectance", **options}
        for row in values.tolist()
    ]
    return np.array([answer["rgb"] for answer in nacre.evaluate("spectrum", spectra)])


def exact_colour(nacre, n, d_nm, angle_deg, quantity="R", **options):
    """That of one stack."""
    stack = {"n": n, "d_nm": d_nm, "angle_deg": angle_deg}
    return colours_of_spectra(nacre, [stack], quantity, **options)[0]


def exact_colours(nacre, n, d_nm, angles):
    """Linear Rec.709 of what a stack reflects, one row an angle in degrees; summed at 1 nm."""
    records = [{"n": n, "d_nm": d_nm, "angle_deg": angle} for angle in angles]
    answers = nacre.evaluate("colour", records, "--sampling", "full")
    return np.array([answer["reflectance"]["rgb"] for answer in answers])
