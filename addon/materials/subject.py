# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels show and operators change: the active object, or the one whose material follows it."""

from __future__ import annotations

from collections.abc import Callable

import bpy

from .material import group_node

StandIn = Callable[[bpy.types.Context, bpy.types.Object], bpy.types.Object | None]

STAND_INS: list[StandIn] = []
"""What an object without a wave material stands for, by the features that make such objects."""


def subject(context) -> bpy.types.Object | None:
    """What a material follows, such as an empty, stands for what has it, so that the material's sliders stay
    in view while it is moved."""
    obj = context.object
    if obj is None or group_node(obj.active_material) is not None:
        return obj
    found = (stand_in(context, obj) for stand_in in STAND_INS)
    return next(filter(None, found), obj)


def active_material(context) -> bpy.types.Material | None:
    found = subject(context)
    return found.active_material if found else None
