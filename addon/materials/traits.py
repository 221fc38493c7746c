# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What may be asked of a material of a file, of whatever kind it is."""

from __future__ import annotations

import bpy

from ..core.library import Library
from ..core.traits import UNSAID, Traits, assumed, read
from . import group as groups
from .material import group_node


def traits(material: bpy.types.Material | None) -> Traits:
    """As its group says, or as far as can be told of one that older versions made. Panels ask this at each
    redraw."""
    node = group_node(material)
    if node is None:
        return UNSAID
    stated = node.node_tree.get(groups.TRAITS)
    return (read(stated) if isinstance(stated, str) else None) or _assumed(node.node_tree)


def _assumed(tree: bpy.types.NodeTree) -> Traits:
    """By the template that it carries, else by the library's material of this id."""
    template = tree.get(groups.TEMPLATE_TEXT)
    if isinstance(template, str) and template:
        outputs = (
            i.name for i in tree.interface.items_tree if getattr(i, "in_out", "") == "OUTPUT"
        )
        return assumed(template, tuple(outputs))
    known = Library.default().entries().get(str(tree[groups.MATERIAL]))
    return known.traits if known is not None else UNSAID
