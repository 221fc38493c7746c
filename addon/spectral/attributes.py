# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of a scene or view layer that nodes read: what a pass of bands is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import bpy

from ..blender.formula import Formula

PREFIX = "nacre_s_"
"""Of the name of each spectrum's property: its values in the three bands of a pass."""
IS_SPECTRAL = "nacre_spectral"
"""1 while bands are rendered; without it colours are RGB."""
PASS = "nacre_pass"
"""The number of a pass, from 0."""
CENTRE_NM, HALF_WIDTH_NM = 595.0, 235.0
"""The variable of polynomials of upsampled colours is −1 at 360 nm and 1 at 830 nm."""
WAVELENGTHS = "nacre_wavelengths"
"""That variable of the three bands."""
LIVE = "nacre_live"
"""Of the three bands: how bright it comes through dispersive glass in a pass, of two of them 0."""
LIVE_NM = "nacre_live_nm"
"""Its wavelength."""

BASIS = ("nacre_basis_red", "nacre_basis_green", "nacre_basis_blue")
"""Reflectances of the primaries of Rec.709 in the three bands."""

Owner = bpy.types.Scene | bpy.types.ViewLayer
Values = Mapping[str, float | Sequence[float]]


def polynomial_variable(nm: float) -> float:
    return (nm - CENTRE_NM) / HALF_WIDTH_NM


def put(owner: Owner, values: Values) -> None:
    for name, value in values.items():
        owner[name] = value


def take_away(owner: Owner) -> None:
    """All of them: colours are RGB again."""
    for name in [name for name in owner.keys() if _is_ours(name)]:  # noqa: SIM118 of an ID
        del owner[name]


def _is_ours(name: str) -> bool:
    return name in (IS_SPECTRAL, PASS, WAVELENGTHS, LIVE, LIVE_NM, *BASIS) or name.startswith(
        PREFIX
    )


def triple(formula: Formula, name: str) -> bpy.types.NodeSocket:
    """A property of three numbers as a colour; black where there is none."""
    return _attribute(formula, name).outputs["Color"]


def number(formula: Formula, name: str) -> bpy.types.NodeSocket:
    """A property of one number; 0 where there is none."""
    return _attribute(formula, name).outputs["Fac"]


def _attribute(formula: Formula, name: str) -> bpy.types.Node:
    return formula.node("ShaderNodeAttribute", attribute_type="VIEW_LAYER", attribute_name=name)
