# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Materials of hand-written shaders, as an artist assigns them."""

from __future__ import annotations

import bpy

from . import extension


def inputs(material: str, preset: str = "") -> dict[str, float | list[float]]:
    """Values of a new material's inputs by their manifest names, after a preset if one is named."""
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    extension.load().register()
    try:
        bpy.ops.nacre.assign_material(material=material)
        if preset:
            bpy.ops.nacre.apply_preset(preset=preset)
        assigned = bpy.context.object.active_material
        of_materials = extension.module("materials.material")
        group = of_materials.group_node(assigned).node_tree
        names = extension.module("materials.group").socket_identifiers(group)
        return {name: _plain(of_materials.input_socket(assigned, name)) for name in names}
    finally:
        extension.load().unregister()


def _plain(socket: bpy.types.NodeSocket) -> float | list[float]:
    value = socket.default_value
    return value if isinstance(value, (int, float)) else list(value)
