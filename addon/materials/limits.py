# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Values that make no sense are held to what does. Blender keeps a slider within its limits, but takes
any number that is typed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import bpy
from bpy.app.handlers import persistent

from . import group as groups
from .material import belongs_here, group_node

Limit = tuple[bpy.types.NodeSocket, float, float]

FURTHER: list[Callable[[bpy.types.Material], Iterable[Limit]]] = []
"""Of nodes that features put before a material's group."""

_held: dict[int, dict[str, str]] = {}  # by material's session_uid: socket's path, what was done


def hold(material: bpy.types.Material) -> None:
    """Every number of the material's group, and of what else feeds it."""
    said = _held.setdefault(material.session_uid, {})
    for socket, low, high in _limits(material):
        value = socket.default_value
        path = socket.path_from_id()
        if low <= value <= high:
            if value not in (low, high):
                said.pop(path, None)
            continue
        socket.default_value = high if value > high else low  # also what is no number
        most = "most" if value > high else "least"
        said[path] = f"{socket.name}: {socket.default_value:g} is the {most} that makes sense here"


def held(material: bpy.types.Material) -> list[str]:
    """What was typed and held, until it is changed again."""
    return list(_held.get(material.session_uid, {}).values())


def _limits(material: bpy.types.Material) -> Iterator[Limit]:
    yield from of_interface(group_node(material))
    for more in FURTHER:
        yield from more(material)


def of_interface(node: bpy.types.ShaderNodeGroup) -> Iterator[Limit]:
    """What a group says of its own inputs."""
    limits = {
        item.identifier: (item.min_value, item.max_value)
        for item in node.node_tree.interface.items_tree
        if getattr(item, "in_out", "") == "INPUT" and hasattr(item, "min_value")
    }
    for socket in node.inputs:
        if socket.type in ("VALUE", "INT") and socket.identifier in limits and not socket.is_linked:
            yield socket, *limits[socket.identifier]


@persistent
def _after_change(_scene, depsgraph) -> None:
    for update in depsgraph.updates:
        material = update.id.original
        is_ours = isinstance(material, bpy.types.Material) and groups.MATERIAL in material
        if is_ours and belongs_here(material) and group_node(material) is not None:
            hold(material)


def register() -> None:
    bpy.app.handlers.depsgraph_update_post.append(_after_change)


def unregister() -> None:
    bpy.app.handlers.depsgraph_update_post.remove(_after_change)
    _held.clear()
