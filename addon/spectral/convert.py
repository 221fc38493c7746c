# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""*Make Spectral*: every colour of a file gets a spectrum, by a node in front of the socket that takes it.

Nothing else is touched: what was linked or set stays where it was, so that taking the nodes away again
is an exact undo, and without bands the nodes hand on the colour that comes in. All of the file is
converted, whatever scene uses it: what is not rendered in bands looks as before.
"""

from __future__ import annotations

from collections.abc import Iterable

import bpy

from ..blender import animation
from . import films, forms
from .described import EMISSION
from .groups import LIGHT_OF_COLOUR
from .marks import MADE, OWN_COLOUR, UPSAMPLING, is_drawing, is_ours, trees
from .report import LINKED, Remark, Report
from .sockets.arrivals import Spectra
from .sockets.insert import is_constant, put_in, take_out
from .sockets.roles import is_grey, is_needed, roles

_OF_RGB = {
    "TEX_SKY": "Blender's sky is RGB; its colours are taken for daylight through filters",
    "WAVELENGTH": "Blender's wavelength is RGB; its colours are taken for daylight through filters",
}
"""What is computed in RGB and looks like a spectrum, by type of node."""
_STAYS = {
    "Thin Film Thickness": "its thin film is Blender's, of three wavelengths; assign a film of Nacre",
    "Dispersion": "its dispersion is Blender's, whose wavelength is not that of bands; assign Custom Glass",
}
"""What has no part in bands, by the name of the socket that has it above 0."""


def make_spectral() -> Report:
    """Everything of the file that is its own; what is spectral already stays as it is."""
    report = Report()
    _convert_ours(trees(), report)
    spectra = Spectra()
    for light in bpy.data.lights:
        convert_lamp(light, report)
    for kind, owners in (("world", bpy.data.worlds), ("material", bpy.data.materials)):
        for owner in owners:
            if owner.library is not None:
                report.remarks.append(Remark(kind, owner.name, LINKED))
            elif owner.use_nodes and owner.node_tree is not None:
                _convert_tree(owner.node_tree, kind, owner.name, report, spectra)
    laid_by = forms.formers()
    for group in bpy.data.node_groups:
        if group.bl_idname == "ShaderNodeTree" and not is_ours(group) and group not in laid_by:
            if group.library is not None:
                report.remarks.append(Remark("node group", group.name, LINKED))
            else:
                _convert_tree(group, "node group", group.name, report, spectra)
    for item in bpy.data.objects:
        if is_drawing(item):
            text = "is a drawing, which no engine renders; left out of bands"
            report.remarks.append(Remark("object", item.name, text))
    return report


def follow(material: bpy.types.Material) -> None:
    """One that was just assigned or rebuilt, where colours have spectra already."""
    if material.library is not None:
        return
    forms.forget_former(material)
    _convert_ours([material.node_tree], Report())
    renew(material.node_tree)


def renew(tree: bpy.types.NodeTree) -> None:
    """What has no spectrum in it gets one of its colour."""
    _convert_tree(tree, "", "", Report(), Spectra())


def make_rgb() -> int:
    """All that `make_spectral` put in is taken out again. Returns how many spectra that were."""
    count = 0
    for tree in trees():
        for node in [node for node in tree.nodes if MADE in node]:
            take_out(tree, node)
            count += 1
    for light in bpy.data.lights:
        if MADE in light:
            own_again(light)
    for tree in trees():
        count += forms.use_former(tree)
    for group in [group for group in bpy.data.node_groups if is_ours(group)]:
        if group.users == 0:
            bpy.data.node_groups.remove(group)
    return count


def convert_lamp(light: bpy.types.Light, report: Report) -> None:
    """In bands all of its colour is in its nodes; its own, which would multiply a spectrum by RGB, is white
    then."""
    if light.library is not None:
        report.remarks.append(Remark("lamp", light.name, LINKED))
        return
    if MADE in light:
        return
    before = {"color": list(light.color), "use_nodes": light.use_nodes}
    light.use_nodes = True
    emissions = [node for node in light.node_tree.nodes if node.type == "EMISSION"]
    changes = animation.is_property_animated(light, "color")
    plain = len(emissions) == 1 and is_constant(emissions[0].inputs["Color"]) and not changes
    if plain:
        socket = emissions[0].inputs["Color"]
        product = [a * b for a, b in zip(light.color, socket.default_value, strict=False)]
        in_nodes = tuple(socket.default_value)
        node = put_in(light.node_tree, socket, EMISSION, (*product, 1.0))
        if node.node_tree.get(UPSAMPLING) == LIGHT_OF_COLOUR:
            node.inputs["Color"].default_value = in_nodes
            before[OWN_COLOUR] = True
        else:
            light.color = (1.0, 1.0, 1.0)
        report.spectra += 1
    else:
        if changes or not is_grey(light.color):
            report.remarks.append(
                Remark("lamp", light.name, "its own colour, on top of its nodes, stays RGB")
            )
        _convert_tree(light.node_tree, "lamp", light.name, report, Spectra())
    light[MADE] = before


def own_again(light: bpy.types.Light) -> None:
    """A lamp has its own colour, as it was before `convert_lamp`."""
    light.color = tuple(light[MADE]["color"])
    light.use_nodes = bool(light[MADE]["use_nodes"])
    del light[MADE]


def _convert_ours(users: Iterable[bpy.types.NodeTree], report: Report) -> None:
    """Before what they are used in, since colours of films then meet tables in bands."""
    for tree in users:
        forms.use_bands(tree, report)
        for node in tree.nodes:
            group = node.node_tree if node.type == "GROUP" else None
            if group is not None and group.library is None and films.has_tables(group):
                films.convert(group, report)


def _convert_tree(
    tree: bpy.types.NodeTree, kind: str, owner: str, report: Report, spectra: Spectra
) -> None:
    if films.is_banded(tree):
        return
    for node in list(tree.nodes):
        for name, what in _STAYS.items():
            stays = node.inputs.get(name)
            if node.type == "GROUP" or stays is None:
                continue
            if stays.is_linked or stays.default_value > 0.0:
                report.remarks.append(Remark(kind, owner, f"{node.name}: {what}"))
        if node.type == "SCRIPT" and any(output.type == "SHADER" for output in node.outputs):
            report.remarks.append(Remark(kind, owner, f"{node.name}: a shader in OSL; stays RGB"))
        spectra.join_group(tree, node, report)
        for name, role in roles(node).items():
            socket = node.inputs.get(name)
            if socket is None or not is_needed(node, socket, role):
                continue
            if spectra.arrive(tree, socket):
                spectra.join(tree, socket, role, report, Remark(kind, owner, ""))
                continue
            if socket.is_linked and socket.links[0].from_node.type in _OF_RGB:
                what = _OF_RGB[socket.links[0].from_node.type]
                report.remarks.append(Remark(kind, owner, f"{node.name}: {name}: {what}"))
            if socket.is_linked and socket.links[0].is_muted:
                report.remarks.append(
                    Remark(kind, owner, f"{node.name}: {name}: its link is muted; stays RGB")
                )
                continue
            if not is_constant(socket) and not socket.is_linked and animation.is_shared(tree):
                text = f"{node.name}: {name}: shares its keyframes with other data; stays RGB"
                report.remarks.append(Remark(kind, owner, text))
                continue
            put_in(tree, socket, role, None)
            report.spectra += 1
