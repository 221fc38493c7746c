# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""*Make Spectral*: every colour of a file gets a spectrum, by a node in front of the socket that takes it.

Nothing else is touched: what was linked or set stays where it was, so that taking the nodes away again
is an exact undo, and without bands the nodes hand on the colour that comes in. All of the file is
converted, whatever scene uses it: what is not rendered in bands looks as before.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import bpy

from ..blender import animation
from ..blender.space import of_file
from ..core.space import REC709, conversion, converted
from . import films, forms
from .attributes import CENTRE_NM, HALF_WIDTH_NM
from .described import EMISSION, REFLECTANCE, Described
from .groups import (
    LIGHT_OF_COLOUR,
    LIGHT_OF_MIXTURE,
    REFLECTANCE_OF_COLOUR,
    REFLECTANCE_OF_MIXTURE,
    spectrum_group,
    upsampling_group,
)
from .marks import (
    BEFORE,
    LUMINANCE,
    MADE,
    OWN_COLOUR,
    UPSAMPLING,
    is_drawing,
    is_ours,
    trees,
)
from .report import LINKED, Remark, Report

ROLES: dict[str, dict[str, str]] = {
    "BSDF_PRINCIPLED": {
        "Base Color": REFLECTANCE,
        "Specular Tint": REFLECTANCE,
        "Coat Tint": REFLECTANCE,
        "Sheen Tint": REFLECTANCE,
        "Emission Color": EMISSION,
    },
    "BSDF_DIFFUSE": {"Color": REFLECTANCE},
    "BSDF_GLOSSY": {"Color": REFLECTANCE},
    "BSDF_ANISOTROPIC": {"Color": REFLECTANCE},
    "BSDF_METALLIC": {"Base Color": REFLECTANCE, "Edge Tint": REFLECTANCE},
    "BSDF_GLASS": {"Color": REFLECTANCE},
    "BSDF_REFRACTION": {"Color": REFLECTANCE},
    "BSDF_TRANSPARENT": {"Color": REFLECTANCE},
    "BSDF_TRANSLUCENT": {"Color": REFLECTANCE},
    "BSDF_SHEEN": {"Color": REFLECTANCE},
    "BSDF_VELVET": {"Color": REFLECTANCE},
    "BSDF_TOON": {"Color": REFLECTANCE},
    "BSDF_HAIR": {"Color": REFLECTANCE},
    "BSDF_HAIR_PRINCIPLED": {"Color": REFLECTANCE},
    "BSDF_RAY_PORTAL": {"Color": REFLECTANCE},
    "SUBSURFACE_SCATTERING": {"Color": REFLECTANCE},
    "EEVEE_SPECULAR": {
        "Base Color": REFLECTANCE,
        "Specular": REFLECTANCE,
        "Emissive Color": EMISSION,
    },
    "VOLUME_ABSORPTION": {"Color": REFLECTANCE},
    "VOLUME_SCATTER": {"Color": REFLECTANCE},
    "PRINCIPLED_VOLUME": {
        "Color": REFLECTANCE,
        "Absorption Color": REFLECTANCE,
        "Emission Color": EMISSION,
    },
    "EMISSION": {"Color": EMISSION},
    "BACKGROUND": {"Color": EMISSION},
}
"""Colours that light meets or is made of, by type of node and name of socket."""

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

_COLOURS = ("RGBA", "VECTOR")
"""Types of sockets that bands go through."""
_MIX_CHANNELS = ("HUE", "SATURATION", "VALUE", "COLOR")
_VECTOR_BY_CHANNEL = (
    "ADD", "SUBTRACT", "MULTIPLY", "DIVIDE", "MULTIPLY_ADD", "SCALE", "MINIMUM", "MAXIMUM",
)  # fmt: skip
_FACTORS = ("MULTIPLY", "DIVIDE")
"""What they multiply a light by is a reflectance."""

_OF_COLOUR = {REFLECTANCE: REFLECTANCE_OF_COLOUR, EMISSION: LIGHT_OF_COLOUR}
_OF_MIXTURE = {REFLECTANCE: REFLECTANCE_OF_MIXTURE, EMISSION: LIGHT_OF_MIXTURE}
_STRENGTH = {"Emission Color": "Emission Strength"}
_GREY = 1e-6
_COOLEST_K = 800.0
"""Below it Blender's black body has the colour of that."""


def make_spectral() -> Report:
    """Everything of the file that is its own; what is spectral already stays as it is."""
    report = Report()
    _convert_ours(trees(), report)
    spectra = _Spectra()
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
    _convert_tree(tree, "", "", Report(), _Spectra())


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
    plain = len(emissions) == 1 and _is_constant(emissions[0].inputs["Color"]) and not changes
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
        if changes or not _is_grey(light.color):
            report.remarks.append(
                Remark("lamp", light.name, "its own colour, on top of its nodes, stays RGB")
            )
        _convert_tree(light.node_tree, "lamp", light.name, report, _Spectra())
    light[MADE] = before


def own_again(light: bpy.types.Light) -> None:
    """A lamp has its own colour, as it was before `convert_lamp`."""
    light.color = tuple(light[MADE]["color"])
    light.use_nodes = bool(light[MADE]["use_nodes"])
    del light[MADE]


def _is_constant(socket: bpy.types.NodeSocket) -> bool:
    return not socket.is_linked and not animation.is_animated(socket)


def _convert_ours(users: Iterable[bpy.types.NodeTree], report: Report) -> None:
    """Before what they are used in, since colours of films then meet tables in bands."""
    for tree in users:
        forms.use_bands(tree, report)
        for node in tree.nodes:
            group = node.node_tree if node.type == "GROUP" else None
            if group is not None and group.library is None and films.has_tables(group):
                films.convert(group, report)


def _convert_tree(
    tree: bpy.types.NodeTree, kind: str, owner: str, report: Report, spectra: _Spectra
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
            if socket is None or not _is_needed(node, socket, role):
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
            if not _is_constant(socket) and not socket.is_linked and animation.is_shared(tree):
                text = f"{node.name}: {name}: shares its keyframes with other data; stays RGB"
                report.remarks.append(Remark(kind, owner, text))
                continue
            put_in(tree, socket, role, None)
            report.spectra += 1


class _Spectra:
    """Where spectra go in the nodes of a file, in and out of groups of somebody's own. What meets one gets one
    too, as far as nodes work by channel."""

    def __init__(self) -> None:
        self._known: dict[tuple, bool] = {}
        self._fed: set[tuple[bpy.types.NodeTree, str]] = set()
        """Inputs of groups that a spectrum comes in by, wherever the group is used."""
        while self._feed():
            self._known.clear()

    def _feed(self) -> bool:
        """Whether there are more of them than was known."""
        before = len(self._fed)
        for tree in trees():
            for node in tree.nodes:
                group = _own_group(node)
                for socket in node.inputs if group is not None else ():
                    if socket.type == "RGBA" and self.arrive(tree, socket):
                        self._fed.add((group, socket.identifier))
        return len(self._fed) > before

    def arrive(self, tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket) -> bool:
        """Whether one is among what nodes compute for a socket."""
        key = (tree, socket.node.name, socket.identifier)
        if key not in self._known:
            self._known[key] = any(self._come_by(tree, link) for link in socket.links)
        return self._known[key]

    def _come_by(self, tree: bpy.types.NodeTree, link: bpy.types.NodeLink) -> bool:
        node, name = link.from_node, link.from_socket.identifier
        if _is_our_node(node):
            return True
        if node.type == "GROUP_INPUT":
            return (tree, name) in self._fed
        group = _own_group(node)
        if group is not None:
            inner = _end_of(group, name)
            return inner is not None and self.arrive(group, inner)
        return any(self.arrive(tree, each) for each in node.inputs if each.type in _COLOURS)

    def join(
        self, tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, role: str, report: Report,
        remark: Remark,
    ) -> None:  # fmt: skip
        for link in list(socket.links):
            node, group = link.from_node, _own_group(link.from_node)
            if group is not None:
                inner = _end_of(group, link.from_socket.identifier)
                self.join(
                    group, inner, role, report, replace(remark, kind="node group", name=group.name)
                )
            elif not _is_our_node(node) and node.type != "GROUP_INPUT":
                self._join_at(tree, node, role, report, remark)

    def _join_at(
        self, tree: bpy.types.NodeTree, node: bpy.types.Node, role: str, report: Report, remark: Remark
    ) -> None:  # fmt: skip
        if not _works_by_channel(node):
            text = f"{node.name}: takes the spectrum that comes in for RGB"
            report.remarks.append(replace(remark, text=text))
            return
        factor = getattr(node, "blend_type", getattr(node, "operation", "")) in _FACTORS
        meets = REFLECTANCE if factor else role
        for each in [each for each in node.inputs if each.enabled and each.type in _COLOURS]:
            if self.arrive(tree, each):
                self.join(tree, each, meets, report, remark)
            elif _is_needed(node, each, meets):
                put_in(tree, each, meets, None)
                report.spectra += 1

    def join_group(self, tree: bpy.types.NodeTree, node: bpy.types.Node, report: Report) -> None:
        """A group that takes a spectrum somewhere else takes one here."""
        group = _own_group(node)
        for socket in node.inputs if group is not None else ():
            is_fed = (group, socket.identifier) in self._fed and not self.arrive(tree, socket)
            if is_fed and _is_needed(node, socket, REFLECTANCE):
                put_in(tree, socket, REFLECTANCE, None)
                report.spectra += 1


def _is_our_node(node: bpy.types.Node) -> bool:
    return node.type == "GROUP" and node.node_tree is not None and is_ours(node.node_tree)


def _own_group(node: bpy.types.Node) -> bpy.types.NodeTree | None:
    """Of somebody's own, that can be changed."""
    group = node.node_tree if node.type == "GROUP" else None
    is_own = group is not None and not is_ours(group) and group.library is None
    return group if is_own and not forms.is_material(group) else None


def _end_of(group: bpy.types.NodeTree, identifier: str) -> bpy.types.NodeSocket | None:
    """The socket that an output of the group has its value from."""
    for node in group.nodes:
        if node.type == "GROUP_OUTPUT" and node.is_active_output:
            return next((each for each in node.inputs if each.identifier == identifier), None)
    return None


def _works_by_channel(node: bpy.types.Node) -> bool:
    if node.type in ("MIX", "MIX_RGB"):
        return node.blend_type not in _MIX_CHANNELS
    if node.type == "VECT_MATH":
        return node.operation in _VECTOR_BY_CHANNEL
    return node.type in ("REROUTE", "GAMMA", "INVERT", "BRIGHTCONTRAST")


def roles(node: bpy.types.Node) -> dict[str, str]:
    """Colours of a film's own, of a matt base under it, meet light as tables have it."""
    if node.type == "GROUP" and node.node_tree is not None and films.is_banded(node.node_tree):
        return {socket.name: REFLECTANCE for socket in node.inputs if socket.type == "RGBA"}
    return ROLES.get(node.type, {})


def _is_needed(node: bpy.types.Node, socket: bpy.types.NodeSocket, role: str) -> bool:
    """Not where there is a spectrum already, no light, or a grey, which is one everywhere."""
    if socket.is_linked:
        source = socket.links[0].from_node
        group = source.node_tree if source.type == "GROUP" else None
        return group is None or not is_ours(group)
    if animation.is_animated(socket):
        return True
    colour = socket.default_value[:3]
    if role == REFLECTANCE:
        return not _is_grey(colour)
    strength = node.inputs.get(_STRENGTH.get(socket.name, "Strength"))
    dark = strength is not None and not strength.is_linked and strength.default_value == 0.0
    return any(colour) and not dark


def _is_grey(colour) -> bool:
    return max(colour) - min(colour) <= _GREY * max(1.0, *colour)


def put_in(
    tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, role: str, colour: tuple | None
) -> bpy.types.ShaderNodeGroup:
    """A group between the socket and what it had; `colour` in place of the socket's own."""
    node = new_node(tree, socket)
    kelvin = _temperature(socket) if role == EMISSION else None
    if kelvin is not None:
        glow = Described.named(f"blackbody:{kelvin:g}")
        node.node_tree = spectrum_group(glow, keeps_rgb=True)
        node.inputs[LUMINANCE].default_value = 1.0  # as Blender has it
        tree.links.new(socket.links[0].from_socket, node.inputs[BEFORE])
    elif socket.is_linked:
        node.node_tree = upsampling_group(_OF_MIXTURE[role])
        tree.links.new(socket.links[0].from_socket, node.inputs["Color"])
    elif animation.is_animated(socket):
        node.node_tree = upsampling_group(_OF_MIXTURE[role])
        node.inputs["Color"].default_value = socket.default_value
        animation.move(socket, node.inputs["Color"])
    else:
        given = tuple(socket.default_value) if colour is None else colour
        given = (*given[:3], 1.0)
        _fill(node, role, given)
        node.inputs["Color"].default_value = given
    tree.links.new(node.outputs[0], socket)
    return node


def _temperature(socket: bpy.types.NodeSocket) -> float | None:
    """Of Blender's own black body, where nothing changes it."""
    source = socket.links[0].from_node if socket.is_linked else None
    if source is None or source.type != "BLACKBODY" or not _is_constant(source.inputs[0]):
        return None
    kelvin = source.inputs[0].default_value
    return kelvin if kelvin >= _COOLEST_K else None


def new_node(tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket) -> bpy.types.ShaderNodeGroup:
    node = tree.nodes.new("ShaderNodeGroup")
    node[MADE] = True
    node.location = (socket.node.location.x - 180.0, socket.node.location.y - 40.0)
    node.hide = True
    return node


def _fill(node: bpy.types.ShaderNodeGroup, role: str, colour: tuple) -> None:
    """With the coefficients of a colour; as a mixture, where no smooth spectrum has it."""
    import nacre

    rgb = converted(conversion(of_file(), REC709), colour[:3])
    largest = max(rgb)
    # A light is D65 through a filter of its colour at half strength, so that even a bright
    # saturated one gets a smooth spectrum.
    scale = 1.0 if role == REFLECTANCE else 2.0 * largest
    try:
        found = nacre.rgb_to_spectrum([channel / scale for channel in rgb]).coefficients
    except nacre.NacreError:
        node.node_tree = upsampling_group(_OF_MIXTURE[role])
        return
    node.node_tree = upsampling_group(_OF_COLOUR[role])
    node.inputs["Coefficients"].default_value = polynomial(found)
    if role == EMISSION:
        node.inputs["Scale"].default_value = scale


def polynomial(by_nanometre) -> tuple[float, float, float]:
    """Of attributes.polynomial_variable(), from one of λ/nm; both highest power first."""
    a, b, c = (float(value) for value in by_nanometre)
    return (
        HALF_WIDTH_NM**2 * a,
        HALF_WIDTH_NM * (2.0 * CENTRE_NM * a + b),
        (CENTRE_NM * a + b) * CENTRE_NM + c,
    )


def take_out(tree: bpy.types.NodeTree, node: bpy.types.Node) -> None:
    source = node.inputs.get(BEFORE) or node.inputs["Color"]
    if source.is_linked:
        for link in list(node.outputs[0].links):
            tree.links.new(source.links[0].from_socket, link.to_socket)
    else:
        for link in node.outputs[0].links:
            animation.move(source, link.to_socket)
    tree.nodes.remove(node)
