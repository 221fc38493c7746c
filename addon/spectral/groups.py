# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Node groups that give a colour where RGB is rendered, and a spectrum's values where bands are."""

from __future__ import annotations

import bpy

import nacre

from ..blender.formula import Formula
from ..blender.space import of_file, state
from ..core.space import conversion_from_xyz, converted
from . import attributes
from .described import EMISSION, Described, SpectrumError

SPECTRUM = "nacre_spectrum"
"""Custom property of a group of one spectrum: what it is, as Described.text has it."""
COLOUR = "nacre_colour_spectrum"
"""Custom property of the group that makes spectra of colours by their coefficients."""


def spectrum_group(spectrum: Described) -> bpy.types.NodeTree:
    """One output, *Color*: of a light it has Y = 1. The group that is there, or a new one."""
    for group in bpy.data.node_groups:
        if group.get(SPECTRUM) == spectrum.text:
            return group
    group = bpy.data.node_groups.new(f"Spectrum: {spectrum.name}"[:63], "ShaderNodeTree")
    group[SPECTRUM] = spectrum.text
    state(group)
    group.interface.new_socket("Color", in_out="OUTPUT", socket_type="NodeSocketColor")
    formula = Formula(group)
    banded = attributes.triple(formula, spectrum.attribute)
    _give(formula, (*rgb_of(spectrum), 1.0), banded)
    return group


def colour_group() -> bpy.types.NodeTree:
    """*Color* in RGB; in bands the spectrum R = ½ + x / (2 √(1 + x²)), x = (c0 t + c1) t + c2, of the
    *Coefficients* c (Jakob and Hanika 2019)."""
    for group in bpy.data.node_groups:
        if COLOUR in group:
            return group
    group = bpy.data.node_groups.new("Colour as Spectrum", "ShaderNodeTree")
    group[COLOUR] = True
    sockets = group.interface
    sockets.new_socket("Color", in_out="INPUT", socket_type="NodeSocketColor")
    sockets.new_socket("Coefficients", in_out="INPUT", socket_type="NodeSocketVector")
    sockets.new_socket("Color", in_out="OUTPUT", socket_type="NodeSocketColor")
    formula = Formula(group)
    inputs = formula.node("NodeGroupInput")
    parts = formula.node("ShaderNodeSeparateXYZ")
    formula.put(inputs.outputs["Coefficients"], parts.inputs[0])
    t = attributes.triple(formula, attributes.WAVELENGTHS)
    inner = formula.vector("MULTIPLY_ADD", t, parts.outputs[0], parts.outputs[1])
    x = formula.vector("MULTIPLY_ADD", inner, t, parts.outputs[2])
    square = formula.vector("MULTIPLY_ADD", x, x, (1.0, 1.0, 1.0))
    root = formula.vector("POWER", square, (-0.5, -0.5, -0.5))
    half = formula.vector("MULTIPLY", x, root)
    banded = formula.vector("MULTIPLY_ADD", half, (0.5, 0.5, 0.5), (0.5, 0.5, 0.5))
    _give(formula, inputs.outputs["Color"], banded)
    return group


def _give(formula: Formula, rgb: object, banded: bpy.types.NodeSocket) -> None:
    """To the output: one or the other."""
    choice = formula.node("ShaderNodeMix", data_type="RGBA")
    factor, a, b = (socket for socket in choice.inputs if socket.enabled)
    formula.put(attributes.number(formula, attributes.IS_SPECTRAL), factor)
    formula.put(rgb, a)
    formula.put(banded, b)
    result = next(socket for socket in choice.outputs if socket.enabled)
    output = formula.node("NodeGroupOutput")
    formula.put(result, output.inputs["Color"])


def found_spectra() -> dict[str, Described]:
    """All of the file, by the names of their properties. Raises SpectrumError that names the group."""
    found = {}
    for group in bpy.data.node_groups:
        if SPECTRUM not in group:
            continue
        try:
            spectrum = Described.parse(group[SPECTRUM])
        except SpectrumError as error:
            raise SpectrumError(f"the node group {group.name!r} {error}") from error
        found[spectrum.attribute] = spectrum
    return found


def rgb_of(spectrum: Described) -> tuple[float, float, float]:
    """In the file's space: a reflectance under D65, a light with Y = 1."""
    if spectrum.kind == EMISSION:
        power = (
            nacre.illuminant(spectrum.light)
            if spectrum.light
            else nacre.shapes.total(nacre.shapes.Scaled(spectrum.as_spectrum), _GRID)
        )
        xyz = nacre.spectrum_to_colour(_GRID, power, "emission", space="xyz_d65").XYZ
        xyz = xyz / xyz[1]
    else:
        xyz = nacre.spectrum_to_colour(
            spectrum.wavelength_nm, spectrum.values, space="xyz_d65"
        ).rgb  # relative to D65, as spaces are
    return converted(conversion_from_xyz(of_file()), xyz)


_GRID = [float(nm) for nm in range(360, 831)]
