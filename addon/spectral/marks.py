# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What says in a file that it is spectral, for those who only look."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterator

import bpy

SPECTRUM = "nacre_spectrum"
"""Custom property of a group of one spectrum: what it is, as Described.text has it."""
KEEPS_RGB = "nacre_keeps_rgb"
"""And that in RGB it hands on what was there before."""
LUMINANCE, BEFORE = "Luminance", "Before"
"""Inputs of such a group."""
UPSAMPLING = "nacre_upsampling"
"""Custom property of a group that makes spectra of colours: which one it is."""
BANDED = "nacre_banded"
"""Custom property of a group that reads a film's table in bands: which table."""
BLOCK = "nacre_block"
"""Custom property of a group that forms for bands are built of: which one it is."""
MADE = "nacre_made_spectral"
"""Custom property of nodes that were put in, and of lamps: what they were before."""

OWN_COLOUR = "own_colour"
"""In what MADE says of a lamp: that its colour is still the lamp's own, for RGB and for engines that look at
nothing else; in bands its nodes have all of it."""

WORLD = "World"
"""What the scene's world is called among its lamps."""


def is_spectral() -> bool:
    """Whether colours of the file have spectra. Panels ask this at each redraw."""
    return any(is_ours(group) and group.users for group in bpy.data.node_groups)


def is_ours(group: bpy.types.NodeTree) -> bool:
    return any(mark in group for mark in (SPECTRUM, UPSAMPLING, BANDED, BLOCK))


def trees() -> Iterator[bpy.types.NodeTree]:
    """Of shaders of the file's own."""
    for owner in (*bpy.data.materials, *bpy.data.lights, *bpy.data.worlds):
        if owner.library is None and owner.node_tree is not None:
            yield owner.node_tree
    for group in bpy.data.node_groups:
        if group.bl_idname == "ShaderNodeTree" and group.library is None:
            yield group


def is_drawing(item: bpy.types.Object) -> bool:
    """Of Grease Pencil, which Blender draws over what engines render."""
    return item.type in ("GREASEPENCIL", "GPENCIL")  # from Blender 4.3 on, before


def made_group(name: str, **marks: str | bool) -> tuple[bpy.types.ShaderNodeTree, bool]:
    """The file's own group that has these marks, and whether it is new, and empty then."""
    for group in bpy.data.node_groups:
        if group.library is None and all(
            group.get(m, False) == value for m, value in marks.items()
        ):
            return group, False
    group = bpy.data.node_groups.new(name[:63], "ShaderNodeTree")
    for mark, value in marks.items():
        if value:
            group[mark] = value
    return group, True


def has_own_colour(light: bpy.types.Light) -> bool:
    return MADE in light and OWN_COLOUR in light[MADE]


def name_of(group: bpy.types.NodeTree) -> str:
    """Of a group of one spectrum: what the spectrum is called."""
    with contextlib.suppress(ValueError, KeyError, TypeError):
        return str(json.loads(group[SPECTRUM])["name"])
    return group.name


def lit_by(tree: bpy.types.NodeTree | None) -> str:
    """What a lamp's or a world's light is, or nothing where it has no spectrum of a name."""
    for node in tree.nodes if tree is not None else ():
        if node.type in ("EMISSION", "BACKGROUND"):
            for link in node.inputs["Color"].links:
                source = link.from_node
                group = source.node_tree if source.type == "GROUP" else None
                if group is not None and SPECTRUM in group:
                    return name_of(group)
    return ""
