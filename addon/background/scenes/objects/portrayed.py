# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What an object is that poses for a picture, and how it is put before the camera."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import bpy
from mathutils import Euler, Matrix

EYE_AZIMUTH_DEG = -42.0
"""Where the camera stands, from +X towards +Y. Objects are made to be seen from -Y, then turned."""

FOR_CLEAR = "SOFTBOXES"
"""A clear film reflects what it does not let pass: between two like greys it cannot be seen, nor can
clear glass. It needs a dark room."""


@dataclass(frozen=True)
class Portrayed:
    objects: tuple[bpy.types.Object, ...]  # they take the material
    props: tuple[bpy.types.Object, ...] = ()  # they do not, but are in the picture
    elevation_deg: float = 22.0  # of the camera
    fill: float = 0.82  # how much of the picture's width or height it takes
    light: str = "STUDIO"
    light_turn_deg: float = 0.0
    has_ground: bool = False  # brings its own
    floats: bool = False


def pose(
    objects: Iterable[bpy.types.Object],
    *,
    lean_deg: float = 0.0,
    turn_deg: float = 0.0,
    roll_deg: float = 0.0,
    floats: bool = False,
) -> None:
    """Together: rolled around y, leant back around x, turned around z and put on the floor."""
    objects = list(objects)
    turn = 90.0 + EYE_AZIMUTH_DEG + turn_deg
    turned = Euler((math.radians(lean_deg), 0.0, math.radians(turn))).to_matrix()
    matrix = (turned @ Matrix.Rotation(math.radians(roll_deg), 3, "Y")).to_4x4()
    for obj in objects:
        obj.matrix_basis = matrix @ obj.matrix_basis
    if floats:
        return
    lowest = min(corner.z for obj in objects for corner in corners(obj))
    for obj in objects:
        obj.matrix_basis = Matrix.Translation((0.0, 0.0, -lowest)) @ obj.matrix_basis


def heated(obj: bpy.types.Object) -> bpy.types.Object:
    """The object as it stands, its own x the other way: heat begins at the end of +x."""
    half = Matrix.Rotation(math.pi, 4, "Z")
    obj.data.transform(half)
    obj.matrix_basis = obj.matrix_basis @ half
    return obj


def corners(obj: bpy.types.Object):
    """The mesh's vertices, in the scene."""
    return [obj.matrix_basis @ vertex.co for vertex in obj.data.vertices]
