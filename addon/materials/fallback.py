# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a material shows whose table is gone: flat grey, half of the light, and never magenta.

Runs when a file was opened or appended from. The panel names the tables, and Rebuild Material brings them back.
"""

from __future__ import annotations

import bpy
from bpy.app.handlers import persistent

from . import group as groups
from . import schema
from .image import FALLBACK, TABLE_CONTENT, is_missing, mend_spaces

_GREY, _NOTHING = 0.5, 0.0
_SUMS = ("further", "powers")  # what is added to others: nothing


def put_in_place() -> list[str]:
    """Fills the gaps of every group of ours that belongs to this file; returns the groups' names."""
    mended = []
    for group in bpy.data.node_groups:
        if groups.MATERIAL not in group or group.library is not None or schema.refusal(group):
            continue
        gaps = [n for n in group.nodes if n.type == "TEX_IMAGE" and is_missing(n.image)]
        for node in gaps:
            value = _NOTHING if node.get(TABLE_CONTENT) in _SUMS else _GREY
            node.image = _flat(value)
            group[groups.DIGEST] = ""  # not to be found as a sound one
        if gaps:
            mended.append(group.name)
    return mended


def _flat(value: float) -> bpy.types.Image:
    name = f"nacre_missing_{value:g}"
    image = bpy.data.images.get((name, None))  # of this file, not of a linked one
    if image is not None and image.get(FALLBACK):
        return image
    image = bpy.data.images.new(name, 2, 2, float_buffer=True, is_data=True)
    image.pixels = [value, value, value, 1.0] * 4
    image.update()
    image.pack()
    image[FALLBACK] = True
    return image


@persistent
def _after_load(*_arguments) -> None:
    for name in mend_spaces():
        print(f"nacre: {name}: was given a colour space by another colour config; it is data again")
    for name in put_in_place():
        print(f"nacre: {name}: tables are missing; it is shown flat until it is rebuilt")


def register() -> None:
    for name in schema.HANDLERS:
        getattr(bpy.app.handlers, name).append(_after_load)


def unregister() -> None:
    for name in schema.HANDLERS:
        getattr(bpy.app.handlers, name).remove(_after_load)
