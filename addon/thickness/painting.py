# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Painting a thickness with Blender's own vertex brushes."""

from __future__ import annotations

import contextlib

import bpy

from ..blender.output import OutputError
from ..core.space import srgb

LAYER = "Film Thickness"
"""Colour attribute that is made for painting."""


def layer_of(obj: bpy.types.Object) -> str:
    """The mesh's colour attribute for painting, half-way up the range when it is new; its name."""
    _activate(obj, LAYER)
    return LAYER


def begin(
    context, obj: bpy.types.Object, attribute: bpy.types.ShaderNodeAttribute, value: float | None
) -> str:
    """Into vertex paint, on the attribute that the node reads, with a brush of a value from 0 to 1.
    Returns what the user has to do about it, if anything."""
    if obj.type != "MESH":
        raise OutputError(f"{obj.name} is no mesh: only meshes can be painted")
    attribute.attribute_name = attribute.attribute_name or LAYER
    if not _activate(obj, attribute.attribute_name):
        raise OutputError(
            f"The attribute {attribute.attribute_name!r} of {obj.name} is no colour: "
            "it cannot be painted"
        )
    if not is_on(obj):
        context.view_layer.objects.active = obj
        bpy.ops.object.mode_set(mode="VERTEX_PAINT")
    if context.tool_settings.vertex_paint.brush is None:
        _make_brush()
    if value is not None:
        _load_brush(context, value)
    if context.tool_settings.vertex_paint.brush is None:
        return "This Blender came without brushes: choose or make one in its tool settings"
    return ""


def is_on(obj: bpy.types.Object | None) -> bool:
    return obj is not None and obj.mode == "VERTEX_PAINT"


def places(obj: bpy.types.Object) -> int | None:
    """How many colours the object's mesh holds to paint with; None of what is no mesh."""
    return len(obj.data.vertices) if obj.type == "MESH" else None


def _make_brush() -> None:
    """One of this file, where Blender's own are not installed, as distributions leave them out."""
    brush = bpy.data.brushes.get(LAYER) or bpy.data.brushes.new(LAYER, mode="VERTEX_PAINT")
    brush.asset_mark()
    with contextlib.suppress(RuntimeError):  # it says in the console what it lacks
        bpy.ops.brush.asset_activate(
            asset_library_type="LOCAL", relative_asset_identifier=f"Brush/{brush.name}"
        )


def _activate(obj: bpy.types.Object, name: str) -> bool:
    """Makes the layer if there is nothing of this name. False where something else has it."""
    attributes = getattr(obj.data, "color_attributes", None)
    if attributes is None:
        return False
    layer = attributes.get(name)
    if layer is None:
        if name in obj.data.attributes:
            return False
        layer = attributes.new(name, "FLOAT_COLOR", "POINT")
        layer.data.foreach_set("color", [0.5, 0.5, 0.5, 1.0] * len(layer.data))
    attributes.active_color = layer
    return True


def _load_brush(context, value: float) -> None:
    settings = context.tool_settings
    paint = settings.vertex_paint
    unified = getattr(paint, "unified_paint_settings", None) or settings.unified_paint_settings
    holders = [unified, paint.brush] if paint.brush else [unified]
    for holder in holders:
        # Since 5.0 brushes are in scene-linear colours, as the layer is; before, in sRGB.
        is_srgb = holder.bl_rna.properties["color"].subtype == "COLOR_GAMMA"
        grey = srgb(value) if is_srgb else value
        holder.color = (grey, grey, grey)
