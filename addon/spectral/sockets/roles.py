# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the colours of shaders are to light, and which of them need a spectrum."""

from __future__ import annotations

import bpy

from ...blender import animation
from .. import films
from ..described import EMISSION, REFLECTANCE
from ..marks import is_ours

CHANNELS = "values of channels"
"""No colour: what a shader takes by channel."""
ROLES: dict[str, dict[str, str]] = {
    "BSDF_PRINCIPLED": {
        "Base Color": REFLECTANCE,
        "Specular Tint": REFLECTANCE,
        "Coat Tint": REFLECTANCE,
        "Sheen Tint": REFLECTANCE,
        "Emission Color": EMISSION,
        "Subsurface Radius": CHANNELS,
    },
    "BSDF_DIFFUSE": {"Color": REFLECTANCE},
    "BSDF_GLOSSY": {"Color": REFLECTANCE},
    "BSDF_ANISOTROPIC": {"Color": REFLECTANCE},
    "BSDF_METALLIC": {
        "Base Color": REFLECTANCE,
        "Edge Tint": REFLECTANCE,
        "IOR": CHANNELS,
        "Extinction": CHANNELS,
    },
    "BSDF_GLASS": {"Color": REFLECTANCE},
    "BSDF_REFRACTION": {"Color": REFLECTANCE},
    "BSDF_TRANSPARENT": {"Color": REFLECTANCE},
    "BSDF_TRANSLUCENT": {"Color": REFLECTANCE},
    "BSDF_SHEEN": {"Color": REFLECTANCE},
    "BSDF_VELVET": {"Color": REFLECTANCE},
    "BSDF_TOON": {"Color": REFLECTANCE},
    "BSDF_HAIR": {"Color": REFLECTANCE},
    "BSDF_HAIR_PRINCIPLED": {"Color": REFLECTANCE, "Absorption Coefficient": CHANNELS},
    "BSDF_RAY_PORTAL": {"Color": REFLECTANCE},
    "SUBSURFACE_SCATTERING": {"Color": REFLECTANCE, "Radius": CHANNELS},
    "EEVEE_SPECULAR": {
        "Base Color": REFLECTANCE,
        "Specular": REFLECTANCE,
        "Emissive Color": EMISSION,
    },
    "VOLUME_ABSORPTION": {"Color": REFLECTANCE},
    "VOLUME_SCATTER": {"Color": REFLECTANCE},
    "PRINCIPLED_VOLUME": {
        "Color": REFLECTANCE,
        "Absorption Color": REFLECTANCE,
        "Emission Color": EMISSION,
        "Blackbody Tint": REFLECTANCE,
    },
    "VOLUME_COEFFICIENTS": {
        "Absorption Coefficients": CHANNELS,
        "Scatter Coefficients": CHANNELS,
        "Emission Coefficients": EMISSION,
    },
    "EMISSION": {"Color": EMISSION},
    "BACKGROUND": {"Color": EMISSION},
}
"""Colours that light meets or is made of, by type of node and name of socket."""

_STRENGTH = {"Emission Color": "Emission Strength", "Subsurface Radius": "Subsurface Weight"}
_GREY = 1e-6


def roles(node: bpy.types.Node) -> dict[str, str]:
    """Colours of a film's own, of a matt base under it, meet light as tables have it."""
    if node.type == "GROUP" and node.node_tree is not None and films.is_banded(node.node_tree):
        return {socket.name: REFLECTANCE for socket in node.inputs if socket.type == "RGBA"}
    return ROLES.get(node.type, {})


def is_needed(node: bpy.types.Node, socket: bpy.types.NodeSocket, role: str) -> bool:
    """Not where there is a spectrum already, no light, or a grey, which is one everywhere."""
    if socket.is_linked:
        source = socket.links[0].from_node
        group = source.node_tree if source.type == "GROUP" else None
        return group is None or not is_ours(group)
    if animation.is_animated(socket):
        return True
    colour = socket.default_value[:3]
    if role == REFLECTANCE:
        return not is_grey(colour)
    strength = node.inputs.get(_STRENGTH.get(socket.name, "Strength"))
    dark = strength is not None and not strength.is_linked and strength.default_value == 0.0
    if role == CHANNELS:
        return socket.enabled and not dark and not is_grey(colour)
    return any(colour) and not dark


def is_grey(colour) -> bool:
    return max(colour) - min(colour) <= _GREY * max(1.0, *colour)
