# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The film's thickness: a slider under which its colours lie, or the stack of what it follows."""

from __future__ import annotations

import bpy

from ..blender import icons, wrapped
from ..films import colours as film_colours
from ..materials import limits
from ..materials.documented import explain
from ..materials.material import interface_item
from ..materials.subject import active_material, subject
from ..materials.thickness import thickness_socket
from . import heat, painting
from .nodes import covered, feed_of, ramp_of, sources_of, spec_of
from .sources import BELOW, CURVE, ON, POINT, STRENGTH, UPON, Input

_COARSE = 500  # vertices
_UNITS = {"c": " (°C)", "k": " (K)", "m": " (m)", "s": " (s)"}


def draw(layout: bpy.types.UILayout, context) -> None:
    """Of the active material, which is a wave material."""
    material = active_material(context)
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
        row = column.row(align=True)
        row.prop(socket, "default_value", text=socket.name, slider=True)
        explain(row, "thickness", interface_item(socket).description)
        _draw_chips(column, material)
    for said in limits.held(material):
        wrapped.label(box, said, "INFO")
    hidden = covered(sources)
    for index in range(len(sources)):
        _draw_source(box, context, sources, index, index in hidden)
    box.menu("NACRE_MT_thickness", text="Vary Thickness", icon="ADD")


def _draw_chips(layout, material) -> None:
    """The film's colours from the least to the largest thickness; a click takes one."""
    row = layout.row(align=True)
    for chip in film_colours.chips(material):
        icon = icons.chip(chip.rgb)
        taken = row.operator("nacre.set_thickness", text="", icon_value=icon, emboss=False)
        taken.thickness = chip.thickness


def _draw_paints(layout, material, index: int, node) -> None:
    """The same between the source's minimum and maximum; a click loads the brush."""
    low, high = (node.inputs[name].default_value for name in ("Minimum", "Maximum"))
    row = layout.row(align=True)
    for chip in film_colours.chips(material):
        if not low <= chip.thickness <= high or low == high:
            continue
        icon = icons.chip(chip.rgb)
        loaded = row.operator("nacre.paint_thickness", text="", icon_value=icon, emboss=False)
        loaded.index, loaded.colour = index, chip.name
        loaded.value = (chip.thickness - low) / (high - low)


def _draw_source(layout, context, sources: list, index: int, is_covered: bool) -> None:
    node, last = sources[index], len(sources) - 1
    is_on = ON not in node.inputs or bool(node.inputs[ON].default_value)
    box = layout.box()
    row = box.row(align=True)
    row.use_property_split = False
    arrow = "DOWNARROW_HLT" if node.show_options else "RIGHTARROW"
    row.prop(node, "show_options", text="", icon=arrow, emboss=False)
    if ON in node.inputs:
        eye = "HIDE_OFF" if is_on else "HIDE_ON"
        row.prop(node.inputs[ON], "default_value", text="", icon=eye, emboss=False)
    name = row.row(align=True)
    name.active = is_on and not is_covered
    name.label(text=node.label or node.name)
    if last:
        for direction, icon, end in (("UP", "TRIA_UP", 0), ("DOWN", "TRIA_DOWN", last)):
            moved = row.row(align=True)
            moved.enabled = index != end
            move = moved.operator("nacre.move_thickness_source", text="", icon=icon)
            move.index, move.direction = index, direction
    row.operator("nacre.remove_thickness_source", text="", icon="X").index = index
    if is_covered:
        wrapped.label(box, "Covered: nothing of it is seen", "INFO")
    if node.show_options:
        body = box.column()
        body.active = is_on and not is_covered
        apart = {BELOW, ON}
        if index == last:
            apart.add(UPON)  # there is nothing below
        if not last:
            apart.add(STRENGTH)
        _draw_inputs(body, context, index, node, apart)


def _draw_inputs(layout, context, index: int, node, apart: set[str]) -> None:
    spec = spec_of(node)
    if spec.id == "map":
        _draw_image(layout, index, node)
    elif spec.id.startswith("attribute"):
        _draw_painting(layout, context, index, node)
    _draw_followed(layout, context, node)
    column = layout.column()
    shown = [item for item in spec.inputs if item.name not in apart and _is_shown(node, item)]
    for item in shown:
        if not item.fine:
            _draw_input(column, node, item)
    fine = [item for item in shown if item.fine]
    row = layout.row()
    if fine:
        browser = context.window_manager.nacre
        arrow = "DOWNARROW_HLT" if browser.shows_fine else "RIGHTARROW"
        row.prop(browser, "shows_fine", text="More", icon=arrow, emboss=False)
    explain(row, "thickness", "\n".join([spec.description, *map(_explained, shown)]))
    if fine and browser.shows_fine:
        column = layout.column()
        for item in fine:
            _draw_input(column, node, item)
    if "Time" in node.inputs:
        layout.operator("nacre.animate_thickness", text="Run with the Scene", icon="TIME")


def _is_shown(node, item: Input) -> bool:
    socket = node.inputs.get(item.name)
    return socket is not None and not socket.hide_value and not socket.is_linked


def _draw_input(layout, node, item: Input) -> None:
    text = f"{item.name}{_UNITS.get(item.unit, '')}"
    layout.prop(node.inputs[item.name], "default_value", text=text)


def _explained(item: Input) -> str:
    return f"{item.name}: {item.description[0].lower()}{item.description[1:]}"


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


def _draw_painting(layout, context, index: int, node) -> None:
    attribute = feed_of(node, "ATTRIBUTE")
    if attribute is None:
        layout.label(text="Fed by other nodes", icon="LINKED")
        return
    if spec_of(node).id == "attribute":
        if painting.is_on(context.object):
            layout.operator(
                "nacre.stop_painting", text="Stop Painting", icon="CHECKMARK", depress=True
            )
        else:
            start = layout.operator(
                "nacre.paint_thickness", text="Start Painting", icon="BRUSH_DATA"
            )
            start.index = index
        _draw_paints(layout, active_material(context), index, node)
        count = painting.places(subject(context))
        if count is not None and count < _COARSE:
            text = f"The mesh has {count} vertices to paint on: subdivide it for finer strokes"
            wrapped.label(layout, text, "INFO")
    layout.prop(attribute, "attribute_name", text="Attribute")
    ramp = ramp_of(node)
    if ramp is not None:
        layout.template_color_ramp(ramp, "color_ramp")


def _draw_followed(layout, context, node) -> None:
    """The empty or the curve."""
    coordinates = feed_of(node, "TEX_COORD", "Vector")
    if coordinates is not None and spec_of(node).coordinates == POINT:
        layout.prop(coordinates, "object", text="Point")
    modifier = heat.modifier_of(subject(context))
    if spec_of(node).coordinates == CURVE and modifier is not None:
        holder, path = heat.curve_property(modifier)
        layout.prop(holder, path, text="Curve")
