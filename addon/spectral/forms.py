# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of ours that have another form where bands are rendered: films in OSL that of nodes, what
disperses light one of its own. The sockets are the same; the form before comes back with RGB."""

from __future__ import annotations

import contextlib

import bpy

from ..core.form import NODES
from ..core.library import Library
from ..core.manifest import BANDS, CompiledMaterial, ManifestError
from ..materials import group as groups
from ..materials.image import tables_of
from ..materials.material import group_node
from ..materials.recipe import RecipeError, compile_recipe, recipe_of_group
from . import blocks
from .marks import trees
from .report import Remark, Report


def use_bands(tree: bpy.types.NodeTree, report: Report) -> None:
    """All groups that a tree uses get their form for bands; what was there is kept for `use_former`."""
    for node in tree.nodes:
        group = node.node_tree if node.type == "GROUP" else None
        if group is None or groups.MATERIAL not in group or group.library is not None:
            continue  # make_spectral() says what stays
        form = NODES if reads_tables(group) else BANDS
        if group.get(groups.FORM, NODES) == form:
            continue
        try:
            compiled = _compiled(group)
            if compiled.graphs.get(form) is None:
                continue
            in_bands = groups.material_group(compiled, form, blocks.OF_TYPE)
        except (RecipeError, ManifestError) as error:
            report.remarks.append(Remark("node group", group.name, f"{error}; stays RGB"))
            continue
        if groups.socket_identifiers(in_bands) != groups.socket_identifiers(group):
            text = "its inputs were changed; stays RGB"
            report.remarks.append(Remark("node group", group.name, text))
            continue
        node[groups.FORMER] = group
        node.node_tree = in_bands
        report.spectra += form == BANDS


def reads_tables(group: bpy.types.NodeTree) -> bool:
    return any(tables_of(group))


def _compiled(group: bpy.types.NodeTree) -> CompiledMaterial:
    """From the library, where that is what the group was made of. Raises RecipeError, ManifestError."""
    with contextlib.suppress(ManifestError):
        known = Library.default().load(group[groups.MATERIAL])
        if known.digest == group.get(groups.DIGEST):
            return known
    return compile_recipe(recipe_of_group(group, group.name), group.name)


def use_former(tree: bpy.types.NodeTree) -> int:
    """Returns how many that disperse light were among them."""
    count = 0
    for node in tree.nodes:
        former = node.get(groups.FORMER)
        if former is None:
            continue
        in_bands, node.node_tree = node.node_tree, former
        del node[groups.FORMER]
        count += is_dispersive(in_bands)
        if in_bands.users == 0:
            groups.remove(in_bands)
    return count


def formers() -> set[bpy.types.NodeTree]:
    """Groups that wait for `use_former` and are in use nowhere."""
    nodes = [node for tree in trees() for node in tree.nodes if node.type == "GROUP"]
    waiting = {node[groups.FORMER] for node in nodes if groups.FORMER in node}
    return waiting - {node.node_tree for node in nodes}


def forget_former(material: bpy.types.Material) -> None:
    """Of a material that has become another one."""
    node = group_node(material)
    if node is not None and groups.FORMER in node:
        del node[groups.FORMER]


def is_material(group: bpy.types.NodeTree) -> bool:
    """Whether it is one of our materials."""
    return groups.MATERIAL in group


def is_dispersive(group: bpy.types.NodeTree) -> bool:
    """Whether one wavelength at a time goes through it."""
    return group.get(groups.FORM) == BANDS
