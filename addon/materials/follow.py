# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets materials follow the file's scene-linear space.

Tables and the arrays of shaders are data to Blender: they stay as they are when a file's space changes, or when
a material comes from a file of another. Values of sockets are colours to it, which it converts itself where it
is asked to.
"""

from __future__ import annotations

import bpy
from bpy.app.handlers import persistent

from ..blender import space
from ..core.space import Matrix
from . import group as groups
from . import schema
from .image import TABLE, convert_pixels, is_missing
from .script import convert_script

_followed: list[Matrix] = []  # the space that everything is in; one at most


def put_right() -> list[str]:
    """Takes every group of ours into the file's space; returns the names of those that were not."""
    _followed[:] = [space.of_file()]
    return [
        tree.name
        for tree in bpy.data.node_groups
        if groups.MATERIAL in tree and not schema.refusal(tree) and _convert(tree)
    ]


def _convert(tree: bpy.types.NodeTree) -> bool:
    wrong = False
    for image in {node.image for node in tree.nodes if node.type == "TEX_IMAGE"} - {None}:
        if TABLE not in image or is_missing(image):
            continue
        matrix = space.to_file(space.of_block(image))
        if matrix is not None:
            convert_pixels(image, matrix)
            image.pack()
            space.state(image)
            wrong = True
    matrix = space.to_file(space.of_block(tree))
    if matrix is not None:
        for node in tree.nodes:
            if node.type == "SCRIPT":
                convert_script(node, matrix)
        space.state(tree)
        wrong = True
    return wrong


@persistent
def _after_load(*_arguments) -> None:
    for name in put_right():
        print(f"nacre: {name}: taken into the colour space of this file")


@persistent
def _after_change(*_arguments) -> None:
    """Blender does not tell that a file's space has changed, but that something has."""
    if _followed != [space.of_file()]:
        put_right()


@persistent
def _after_undo(*_arguments) -> None:
    """Packed tables are part of a step, the texels read from them are not."""
    if _followed == [space.of_file()]:
        return
    for image in bpy.data.images:
        if TABLE in image:
            image.buffers_free()
    put_right()


_HANDLERS = (
    *((name, _after_load) for name in schema.HANDLERS),
    ("depsgraph_update_post", _after_change),
    ("undo_post", _after_undo),
    ("redo_post", _after_undo),
)


def register() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    _followed.clear()
