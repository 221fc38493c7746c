# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The film's thickness: a slider under which its colours lie, or the stack of what it follows."""

from __future__ import annotations

import bpy

from ..core.thickness import BELOW, ON, STRENGTH, Source
from ..nodes import film_colours, heat
from ..nodes.thickness import feed_of, ramp_of, sources_of, spec_of, thickness_socket
from . import swatch, wrapped

_UNITS = {"c": " (°C)", "k": " (K)", "m": " (m)", "s": " (s)"}


def draw(layout: bpy.types.UILayout, context) -> None:
    """Of the active object's active material, which is a wave material."""
    material = context.object.active_material
    socket = thickness_socket(material)
    if socket is None:
        return
    sources = sources_of(material)
    box = layout.box()
    if sources or socket.is_linked:
        said = "varies" if sources else "is fed by other nodes"
        box.label(text=f"{socket.name} {said}", icon="TEXTURE")
    else:
        column = box.column(align=True)
        column.use_property_split = False
        column.prop(socket, "default_value", text=socket.name, slider=True)
        _draw_chips(column, material)
    for index, node in enumerate(sources):
        _draw_source(box, context, index, node, len(sources))
    box.menu("NACRE_MT_thickness", text="Vary Thickness", icon="ADD")


def _draw_chips(layout, material) -> None:
    """The film's colours from the least to the largest thickness; a click takes one."""
    row = layout.row(align=True)
    for chip in film_colours.chips(material):
        icon = swatch.chip(chip.rgb)
        taken = row.operator("nacre.set_thickness", text="", icon_value=icon, emboss=False)
        taken.thickness = chip.thickness


def _draw_paints(layout, material, index: int, node) -> None:
    """The same between the source's minimum and maximum; a click loads the brush."""
    low, high = (node.inputs[name].default_value for name in ("Minimum", "Maximum"))
    row = layout.row(align=True)
    for chip in film_colours.chips(material):
        if not low <= chip.thickness <= high or low == high:
            continue
        icon = swatch.chip(chip.rgb)
        loaded = row.operator("nacre.paint_thickness", text="", icon_value=icon, emboss=False)
        loaded.index, loaded.colour = index, chip.name
        loaded.value = (chip.thickness - low) / (high - low)


def _draw_source(layout, context, index: int, node: bpy.types.ShaderNodeGroup, count: int) -> None:
    spec = spec_of(node)
    box = layout.box()
    row = box.row(align=True)
    row.use_property_split = False
    arrow = "DOWNARROW_HLT" if node.show_options else "RIGHTARROW"
    row.prop(node, "show_options", text="", icon=arrow, emboss=False)
    if ON in node.inputs:
        eye = "HIDE_OFF" if node.inputs[ON].default_value else "HIDE_ON"
        row.prop(node.inputs[ON], "default_value", text="", icon=eye, emboss=False)
    row.label(text=node.label or node.name)
    if count > 1 and STRENGTH in node.inputs:
        row.prop(node.inputs[STRENGTH], "default_value", text="", slider=True)
    if count > 1:
        for direction, icon in (("UP", "TRIA_UP"), ("DOWN", "TRIA_DOWN")):
            move = row.operator("nacre.move_thickness_source", text="", icon=icon)
            move.index, move.direction = index, direction
    row.operator("nacre.remove_thickness_source", text="", icon="X").index = index
    if node.show_options:
        _draw_inputs(box, context, index, node, spec, count)


def _draw_inputs(layout, context, index: int, node, spec: Source, count: int) -> None:
    if spec.id == "map":
        _draw_image(layout, index, node)
    elif spec.id.startswith("attribute"):
        _draw_painting(layout, context.object.active_material, index, node)
    _draw_followed(layout, context, node)
    column = layout.column()
    for item in spec.inputs:
        socket = node.inputs.get(item.name)
        if socket is None or socket.hide_value or socket.is_linked or item.is_switch:
            continue
        if item.name == BELOW or (item.name == STRENGTH and count > 1):
            continue
        unit = _UNITS.get(item.unit, "")
        column.prop(socket, "default_value", text=f"{item.name}{unit}")
    if "Time" in node.inputs:
        layout.operator("nacre.animate_thickness", text="Run with the Scene", icon="TIME")


def _draw_image(layout, index: int, node) -> None:
    texture = feed_of(node, "TEX_IMAGE")
    if texture is None:
        layout.label(text="Fed by other nodes", icon="LINKED")
        return
    layout.template_ID(texture, "image", open="nacre.open_thickness_image")
    image = texture.image
    if image is not None and not image.colorspace_settings.is_data:
        wrapped.label(layout, "This picture is read as colours, not as thicknesses", "INFO")
        layout.operator("nacre.read_as_data", text="Read as Data").index = index


def _draw_painting(layout, material, index: int, node) -> None:
    attribute = feed_of(node, "ATTRIBUTE")
    if attribute is None:
        layout.label(text="Fed by other nodes", icon="LINKED")
        return
    if spec_of(node).id == "attribute":
        start = layout.operator("nacre.paint_thickness", text="Start Painting", icon="BRUSH_DATA")
        start.index = index
        _draw_paints(layout, material, index, node)
    layout.prop(attribute, "attribute_name", text="Attribute")
    ramp = ramp_of(node)
    if ramp is not None:
        layout.template_color_ramp(ramp, "color_ramp")


def _draw_followed(layout, context, node) -> None:
    """The empty or the curve."""
    coordinates = feed_of(node, "TEX_COORD", "Vector")
    if coordinates is not None and spec_of(node).coordinates == "Point":
        layout.prop(coordinates, "object", text="Point")
    modifier = heat.modifier_of(context.object)
    if spec_of(node).coordinates == "Curve" and modifier is not None:
        holder, path = heat.curve_property(modifier)
        layout.prop(holder, path, text="Curve")
