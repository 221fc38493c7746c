# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Node groups that give a colour where RGB is rendered, and a spectrum's values where bands are."""

from __future__ import annotations

import bpy

from ..blender.formula import Formula, Operand
from ..blender.space import of_file, state
from ..core.space import REC709, Matrix, conversion, conversion_from_xyz, converted
from . import attributes
from .described import CONSTANT, DAYLIGHT, EMISSION, RGB_NM, Described, SpectrumError
from .marks import BEFORE, KEEPS_RGB, LUMINANCE, SPECTRUM, UPSAMPLING, made_group

REFLECTANCE_OF_COLOUR = "Colour as Spectrum"
REFLECTANCE_OF_MIXTURE = "Mixed Colour as Spectrum"
LIGHT_OF_COLOUR = "Light of a Colour"
LIGHT_OF_MIXTURE = "Mixed Light"
VALUES_OF_CHANNELS = "Values of Channels"


def spectrum_group(spectrum: Described, *, keeps_rgb: bool = False) -> bpy.types.NodeTree:
    """*Color*; of a light as bright as its *Luminance*. *Before* holds what was where the group is now; in
    RGB the colour is that of the spectrum, or as *Before* has it. The group that is there, or a new one."""
    marks = {SPECTRUM: spectrum.text, KEEPS_RGB: keeps_rgb}
    group, is_new = made_group(f"Spectrum: {spectrum.name}", **marks)
    if not is_new:
        return group
    state(group)
    sockets = group.interface
    if spectrum.kind == EMISSION:
        luminance = sockets.new_socket(LUMINANCE, in_out="INPUT", socket_type="NodeSocketFloat")
        luminance.default_value = 1.0
    before = sockets.new_socket(BEFORE, in_out="INPUT", socket_type="NodeSocketColor")
    before.hide_value = True
    sockets.new_socket("Color", in_out="OUTPUT", socket_type="NodeSocketColor")
    formula = Formula(group)
    inputs = formula.node("NodeGroupInput").outputs
    banded = attributes.triple(formula, spectrum.attribute)
    rgb: Operand = inputs[BEFORE] if keeps_rgb else (*rgb_of(spectrum), 1.0)
    if LUMINANCE in inputs:
        banded = formula.scaled(banded, inputs[LUMINANCE])
        if not keeps_rgb:
            rgb = formula.scaled(rgb_of(spectrum), inputs[LUMINANCE])
    end(formula, choice(formula, rgb, banded))
    return group


def upsampling_group(name: str) -> bpy.types.NodeTree:
    """*Color* in RGB; a spectrum in bands. Of a colour that is known, by *Coefficients* that were
    computed for it; of one that nodes compute, by three spectra of which it is a mixture. A light is
    D65 through a filter, of a colour through one of the colour over *Scale*. What is no colour, as the
    index of a metal in three channels, goes from channel to channel along the same three spectra, whose
    sum is 1."""
    group, is_new = made_group(name, **{UPSAMPLING: name})
    if not is_new:
        return group
    state(group)
    kind = "NodeSocketVector" if name == VALUES_OF_CHANNELS else "NodeSocketColor"
    group.interface.new_socket("Color", in_out="INPUT", socket_type=kind)
    if name in (REFLECTANCE_OF_COLOUR, LIGHT_OF_COLOUR):
        group.interface.new_socket("Coefficients", in_out="INPUT", socket_type="NodeSocketVector")
    if name == LIGHT_OF_COLOUR:
        group.interface.new_socket("Scale", in_out="INPUT", socket_type="NodeSocketFloat")
    group.interface.new_socket("Color", in_out="OUTPUT", socket_type=kind)
    formula = Formula(group)
    inputs = formula.node("NodeGroupInput").outputs
    if "Coefficients" in inputs:
        banded = _sigmoid(formula, inputs["Coefficients"])
    else:
        matrix = None if name == VALUES_OF_CHANNELS else conversion(of_file(), REC709)
        banded = _mixture(formula, inputs["Color"], matrix)
    if name in (LIGHT_OF_COLOUR, LIGHT_OF_MIXTURE):
        daylight = attributes.triple(formula, DAYLIGHT.attribute)
        banded = formula.vector("MULTIPLY", banded, daylight)
    if "Scale" in inputs:
        banded = formula.scaled(banded, inputs["Scale"])
    end(formula, choice(formula, inputs["Color"], banded))
    return group


def _sigmoid(formula: Formula, coefficients: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """½ + x / (2 √(1 + x²)), x = (c0 t + c1) t + c2 (W. Jakob, J. Hanika 2019)."""
    parts = formula.node("ShaderNodeSeparateXYZ")
    formula.put(coefficients, parts.inputs[0])
    t = attributes.triple(formula, attributes.WAVELENGTHS)
    inner = formula.vector("MULTIPLY_ADD", t, parts.outputs[0], parts.outputs[1])
    x = formula.vector("MULTIPLY_ADD", inner, t, parts.outputs[2])
    square = formula.vector("MULTIPLY_ADD", x, x, (1.0, 1.0, 1.0))
    root = _each(formula, "INVERSE_SQRT", square)  # Vector Math has no power before Blender 4.5
    half = formula.vector("MULTIPLY", x, root)
    return formula.vector("MULTIPLY_ADD", half, (0.5, 0.5, 0.5), (0.5, 0.5, 0.5))


def _each(formula: Formula, operation: str, vector: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """Of each component."""
    parts = formula.node("ShaderNodeSeparateXYZ")
    formula.put(vector, parts.inputs[0])
    together = formula.node("ShaderNodeCombineXYZ")
    for part, socket in zip(parts.outputs, together.inputs, strict=True):
        formula.put(formula.number(operation, part), socket)
    return together.outputs[0]


def _mixture(
    formula: Formula, colour: bpy.types.NodeSocket, matrix: Matrix | None
) -> bpy.types.NodeSocket:
    """r R(λ) + g G(λ) + b B(λ) (I. Mallett, C. Yuksel 2019), of Rec.709, which `matrix` leads to."""
    if matrix is None:
        parts = formula.node("ShaderNodeSeparateXYZ")
        formula.put(colour, parts.inputs[0])
        channels = list(parts.outputs)
    else:
        channels = [formula.vector("DOT_PRODUCT", colour, row) for row in matrix]
    total: object = (0.0, 0.0, 0.0)
    for channel, name in zip(channels, attributes.BASIS, strict=True):
        total = formula.vector("MULTIPLY_ADD", attributes.triple(formula, name), channel, total)
    return total


def choice(formula: Formula, rgb: Operand, banded: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """One where RGB is rendered, the other where bands are."""
    mix = formula.node("ShaderNodeMix", data_type="RGBA")
    factor, a, b = (socket for socket in mix.inputs if socket.enabled)
    formula.put(attributes.number(formula, attributes.IS_SPECTRAL), factor)
    formula.put(rgb, a)
    formula.put(banded, b)
    return next(socket for socket in mix.outputs if socket.enabled)


def end(formula: Formula, result: bpy.types.NodeSocket) -> None:
    formula.put(result, formula.node("NodeGroupOutput").inputs["Color"])


def found_spectra() -> dict[str, Described]:
    """All of the file, by the names of their properties. Raises SpectrumError that names the group."""
    found = {}
    for group in bpy.data.node_groups:
        if group.get(UPSAMPLING) in (LIGHT_OF_COLOUR, LIGHT_OF_MIXTURE):
            found[DAYLIGHT.attribute] = DAYLIGHT
        if SPECTRUM not in group:
            continue
        try:
            spectrum = Described.parse(group[SPECTRUM])
        except SpectrumError as error:
            raise SpectrumError(f"the node group {group.name!r} {error}") from error
        found[spectrum.attribute] = spectrum
    return found


def rgb_of(spectrum: Described) -> tuple[float, float, float]:
    """In the file's space: a reflectance under D65, a light with Y = 1. Optical constants by channel."""
    import nacre

    if spectrum.kind == CONSTANT:
        return tuple(float(value) for value in spectrum.at(RGB_NM))
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
