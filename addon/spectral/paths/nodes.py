# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nodes that read a pass of bands read the wavelengths of their path instead."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import bpy
import numpy as np

from ...blender.formula import Formula
from ...materials.image import image_of_texels
from ...materials.script import fill_with_source
from .. import films
from ..attributes import PASS
from ..marks import BANDED, is_ours
from .draws import MASKS, Draws

_SOURCE = """
// A uniform number that is the same all along a path; see nacre_wavelength.h. Where things move, `folds` times
// as many parts of the shutter's time have all wavelengths each, so that what moves is not torn into colours.
shader nacre_path_number(int folds = 1, output float number = 0)
{
    float drawn = time == 0.5 ? (float)hashnoise(P) : (256.0 * time - 0.5) / 254.0;
    float folded = clamp(drawn, 0.0, 0.999999) * folds;
    number = folded - floor(folded);
}
"""
_FOLDS = 61
"""Of a shutter that is open."""


@contextlib.contextmanager
def in_place(scene: bpy.types.Scene, draws: Draws) -> Iterator[None]:
    """While this lasts a scene that is told that it is spectral renders X, Y and Z. Tables of films have to be
    in place."""
    rows = draws.rows()
    names = list(rows)
    image = image_of_texels(
        "Wavelengths of paths",
        np.stack([rows[name] for name in reversed(names)]).astype(np.float32),
    )
    image.use_half_precision = False
    folds = _FOLDS if scene.render.motion_blur_shutter > 0.0 else 1
    kept = []
    try:
        for tree in [group for group in bpy.data.node_groups if is_ours(group) and group.users]:
            kept.append((tree, set(tree.nodes), _links_of_passes(tree, names)))
            _relink(tree, kept[-1][2], names, image, folds)
        yield
    finally:
        for tree, before, links in kept:
            for node in [node for node in tree.nodes if node not in before]:
                tree.nodes.remove(node)
            for source, target in links:
                tree.links.new(source, target)
        bpy.data.images.remove(image)


Link = tuple[bpy.types.NodeSocket, bpy.types.NodeSocket]


def _links_of_passes(tree: bpy.types.NodeTree, names: list[str]) -> list[Link]:
    """From what is read of a pass to what takes it."""
    if BANDED in tree:
        return films.links_of_table(tree)
    return [
        (link.from_socket, link.to_socket)
        for node in tree.nodes
        if node.type == "ATTRIBUTE" and node.attribute_name in names
        for output in node.outputs
        for link in output.links
    ]


def _relink(
    tree: bpy.types.NodeTree,
    links: list[Link],
    names: list[str],
    image: bpy.types.Image,
    folds: int,
) -> None:
    if not links:
        return
    formula = Formula(tree)
    number = formula.node("ShaderNodeScript")
    fill_with_source(number, "nacre_path_number", _SOURCE)
    number.inputs[0].default_value = folds

    def row(name: str) -> bpy.types.NodeSocket:
        place = formula.node("ShaderNodeCombineXYZ")
        formula.put(number.outputs[0], place.inputs[0])
        place.inputs[1].default_value = (names.index(name) + 0.5) / len(names)
        texture = formula.node("ShaderNodeTexImage", interpolation="Closest", extension="EXTEND")
        texture.image = image
        formula.put(place.outputs[0], texture.inputs["Vector"])
        return texture.outputs["Color"]

    if BANDED in tree:
        parts = formula.node("ShaderNodeSeparateXYZ")
        formula.put(row(PASS), parts.inputs[0])
        found = films.read_by_channel(tree, parts.outputs, [row(name) for name in MASKS])
        for _, target in links:
            tree.links.new(found, target)
        return
    for source, target in links:
        tree.links.new(row(source.node.attribute_name), target)
