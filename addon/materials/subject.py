# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels show and operators change: the active object, or the one whose material follows it."""

from __future__ import annotations

import bpy

from ..thickness import heat
from ..thickness import nodes as thickness
from .material import group_node


def subject(context) -> bpy.types.Object | None:
    """An empty or a curve that a film follows stands for what it heats, so that the film's sliders stay in
    view while it is moved."""
    obj = context.object
    if obj is None or group_node(obj.active_material) is not None:
        return obj
    return _follower(context, obj) or obj


def active_material(context) -> bpy.types.Material | None:
    found = subject(context)
    return found.active_material if found else None


def _follower(context, obj: bpy.types.Object) -> bpy.types.Object | None:
    around: set[bpy.types.Material] = set()
    if obj.type in ("EMPTY", "CURVE"):
        around = set(thickness.followers(obj))
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
