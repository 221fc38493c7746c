# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a thickness follows stands for what has it: an empty, or a curve beside which it was heated."""

from __future__ import annotations

import bpy

from ..materials.material import group_node
from . import heat, nodes


def follower(context, obj: bpy.types.Object) -> bpy.types.Object | None:
    around: set[bpy.types.Material] = set()
    if obj.type in ("EMPTY", "CURVE"):
        around = set(nodes.followers(obj))
    is_followed = obj.type == "CURVE" and heat.is_used()
    if not around and not is_followed:
        return None
    for other in context.scene.objects:
        material = other.active_material
        if group_node(material) is None:
            continue
        if material in around or (is_followed and heat.curve_of(other) == obj):
            return other
    return None
