# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How thick a material is, where that can vary."""

from __future__ import annotations

import bpy

from ..core.manifest import THICKNESSES
from .material import group_node, input_socket, interface_item


def thickness_socket(material: bpy.types.Material) -> bpy.types.NodeSocket | None:
    """The input, or None where the material has one thickness."""
    if group_node(material) is None:
        return None
    found = (input_socket(material, name) for name in THICKNESSES)
    return next((socket for socket in found if socket is not None), None)


def thickness_range(socket: bpy.types.NodeSocket) -> tuple[float, float]:
    """What the material's tables cover; beyond it they hold their edge."""
    item = interface_item(socket)
    return item.min_value, item.max_value
