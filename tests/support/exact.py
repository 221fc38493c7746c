# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours by `nacre eval` at 1 nm, for what the tool bakes and exports."""

from __future__ import annotations

import numpy as np

GRID = list(range(360, 831))


def exact_colour(nacre, n, d_nm, angle_deg, quantity="R", **options):
    """Linear Rec.709 of a stack without dispersion, from its spectrum at 1 nm."""
    records = [
        {"n": n, "d_nm": d_nm, "angle_deg": angle_deg, "wavelength_nm": nm, "pol": "u"}
        for nm in GRID
    ]
    values = [answer[quantity] for answer in nacre.evaluate("stack", records)]
    record = {"wavelength_nm": GRID, "values": values, "kind": "reflectance", **options}
    return nacre.evaluate("spectrum", record)["rgb"]


def exact_colours(nacre, n, d_nm, angles):
    """Linear Rec.709 of what a stack reflects, one row an angle in degrees; summed at 1 nm."""
    records = [{"n": n, "d_nm": d_nm, "angle_deg": angle} for angle in angles]
    answers = nacre.evaluate("colour", records, "--sampling", "full")
    return np.array([answer["reflectance"]["rgb"] for answer in answers])
