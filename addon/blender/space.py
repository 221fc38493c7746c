# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which linear RGB space colours are in: that of the file, and what groups and images of ours say.

A file's scene-linear space is Rec.709 as it comes, Rec.2020 or ACEScg from Blender 5 on, and whatever an
OpenColorIO configuration says in any version.
"""

from __future__ import annotations

import bpy
from mathutils import Color

from ..core.space import REC709, Matrix, SpaceError, conversion, converted, parse, relative_to, text

SPACE = "nacre_space"
"""Custom property of groups and images: the nine numbers of the matrix to XYZ. Without it: Rec.709."""

_PRIMARIES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def of_file() -> Matrix:
    """By way of Rec.709, which Blender 4.5 knows to five digits; to XYZ it errs by 2e-4."""
    columns = [Color(primary).from_rec709_linear_to_scene_linear() for primary in _PRIMARIES]
    return relative_to(REC709, tuple(tuple(column[i] for column in columns) for i in range(3)))


def of_block(block: bpy.types.ID) -> Matrix:
    try:
        return parse(block[SPACE]) if SPACE in block else REC709
    except SpaceError:
        return REC709


def is_right(block: bpy.types.ID) -> bool:
    """Whether its colours are in the file's space."""
    return to_file(of_block(block)) is None


def to_file(source: Matrix = REC709) -> Matrix | None:
    """From colours of a space to those of the file; None where they are the same."""
    return conversion(source, of_file())


def here(colour: tuple[float, float, float]) -> tuple[float, float, float]:
    """A colour of Rec.709 in the file's space, for what takes none below 0."""
    return tuple(max(0.0, channel) for channel in converted(to_file(), colour))


def state(block: bpy.types.ID) -> None:
    """Says that the block's colours are in the file's space."""
    block[SPACE] = text(of_file())
