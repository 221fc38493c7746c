# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups that the forms of dispersive materials are built of, where bands are rendered.

Of the three bands of a pass one is live: it goes through dispersive glass at its own index, three times as
bright, the others not at all, and in three passes each has its turn. A path is tinted where it is refracted
first, and not where it is reflected, so that what a glass mirrors is as smooth as without dispersion.
"""

from __future__ import annotations

import bpy

from ..blender.formula import Formula
from . import attributes
from .marks import BLOCK, made_group

_LINE_D_NM = 587.5618


def wavelength() -> bpy.types.ShaderNodeTree:
    """*Wavelength* of the live band; that of the d line where no bands are rendered."""
    group, is_new = made_group("Live Wavelength", **{BLOCK: "wavelength"})
    if not is_new:
        return group
    group.interface.new_socket("Wavelength", in_out="OUTPUT", socket_type="NodeSocketFloat")
    formula = Formula(group)
    is_spectral = attributes.number(formula, attributes.IS_SPECTRAL)
    live = attributes.number(formula, attributes.LIVE_NM)
    end = formula.node("NodeGroupOutput")
    formula.put(formula.mix(is_spectral, _LINE_D_NM, live), end.inputs["Wavelength"])
    return group


def dispersive_glass() -> bpy.types.ShaderNodeTree:
    """Of *Index* at the d line and *Live Index* at `wavelength`: *IOR*, the index where a path has been
    refracted already, and everywhere without bands; *BSDF* at its first refraction, where *Factor* is 1."""
    group, is_new = made_group("Dispersive Glass in Bands", **{BLOCK: "dispersive_glass"})
    if not is_new:
        return group
    sockets = group.interface
    for name, default in (("Index", 1.5), ("Live Index", 1.5), ("Dispersion", 1.0)):
        socket = sockets.new_socket(name, in_out="INPUT", socket_type="NodeSocketFloat")
        socket.default_value = default
    sockets.new_socket("Roughness", in_out="INPUT", socket_type="NodeSocketFloat")
    sockets.new_socket("Normal", in_out="INPUT", socket_type="NodeSocketVector").hide_value = True
    for name, kind in (("IOR", "Float"), ("Factor", "Float"), ("BSDF", "Shader")):
        sockets.new_socket(name, in_out="OUTPUT", socket_type=f"NodeSocket{kind}")
    formula = Formula(group)
    inputs = formula.node("NodeGroupInput").outputs
    amount = formula.number(
        "MULTIPLY", attributes.number(formula, attributes.IS_SPECTRAL), inputs["Dispersion"]
    )
    ior = formula.mix(amount, inputs["Index"], inputs["Live Index"])
    refractions = formula.node("ShaderNodeLightPath").outputs["Transmission Depth"]
    first = formula.number("LESS_THAN", refractions, 0.5)
    factor = formula.number("MULTIPLY", first, formula.number("GREATER_THAN", amount, 0.0))
    surface = {"Roughness": inputs["Roughness"], "Normal": inputs["Normal"]}
    reflected = formula.node("ShaderNodeBsdfAnisotropic", distribution="GGX")
    passed = formula.node("ShaderNodeBsdfRefraction", distribution="GGX")
    share = formula.node("ShaderNodeFresnel")
    of_reflected, of_passed = _gains(formula, inputs["Roughness"], inputs["Normal"])
    live = attributes.triple(formula, attributes.LIVE)
    for node, given in (
        (reflected, {**surface, "Color": of_reflected}),
        (passed, {**surface, "Color": formula.scaled(live, of_passed), "IOR": ior}),
        (share, {"Normal": inputs["Normal"], "IOR": ior}),
    ):
        for name, value in given.items():
            formula.put(value, node.inputs[name])
    both = formula.node("ShaderNodeMixShader")
    for at, source in enumerate((share, passed, reflected)):
        formula.put(source.outputs[0], both.inputs[at])
    end = formula.node("NodeGroupOutput").inputs
    for name, socket in (("IOR", ior), ("Factor", factor), ("BSDF", both.outputs[0])):
        formula.put(socket, end[name])
    return group


# 1 + alpha squared times a polynomial of the cosine + alpha cubed times another: least squares to the inverse
# mean over visible normals of GGX, of light that is refracted into indices 1.33 to 2.4 (within 0.4 % to a
# roughness of 0.3, 3 % to 0.6, 7 % to 1), and of light that is reflected (3 % rms; at grazing angles up to 14).
# Blender's own multiple scattering does not do: with OSL it depends on how much of a lobe there is.
_LOST_OF_PASSED = ((0.8281, -0.9013, -0.9693, 1.0708), (-0.6546, 2.3676, -2.2002, 0.5252))
_LOST_OF_REFLECTED = ((0.4449, 13.9172, -24.4192, 11.4203), (-0.4292, -12.8101, 27.12, -12.95))


def _gains(
    formula: Formula, roughness: bpy.types.NodeSocket, normal: bpy.types.NodeSocket
) -> list[bpy.types.NodeSocket]:
    """What makes up for light that facets in front of others take away after one bounce, of what is
    reflected and of what passes."""
    incoming = formula.node("ShaderNodeNewGeometry").outputs["Incoming"]
    cosine = formula.number("ABSOLUTE", formula.vector("DOT_PRODUCT", incoming, normal))
    alpha = formula.number("MULTIPLY", roughness, roughness)
    squared = formula.number("MULTIPLY", alpha, alpha)
    gains = []
    for lost in (_LOST_OF_REFLECTED, _LOST_OF_PASSED):
        square, cube = (_polynomial(formula, cosine, row) for row in lost)
        both = formula.number("MULTIPLY_ADD", cube, alpha, square)
        gains.append(formula.number("MULTIPLY_ADD", both, squared, 1.0))
    return gains


def _polynomial(
    formula: Formula, x: bpy.types.NodeSocket, coefficients: tuple[float, ...]
) -> bpy.types.NodeSocket:
    total: object = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = formula.number("MULTIPLY_ADD", total, x, coefficient)
    return total


OF_TYPE = {"nacre.wavelength": wavelength, "nacre.dispersive_glass": dispersive_glass}
"""By the type that graphs of manifests have."""
