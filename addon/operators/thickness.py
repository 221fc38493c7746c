# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Let the thickness of the active material vary over its surface."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, StringProperty

from ..core.thickness import SOURCES
from ..nodes import thickness
from ..output import OutputError
from .guard import allows_change, reports_errors

PAINTED = "Film Thickness"
"""Colour attribute that is made for painting."""


def _material(context) -> bpy.types.Material | None:
    return context.object.active_material if context.object else None


class _ThicknessOperator(bpy.types.Operator):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        material = _material(context)
        if material is None or thickness.thickness_socket(material) is None:
            cls.poll_message_set("The active material has no thickness that could vary")
            return False
        return allows_change(cls, material)


class NACRE_OT_add_thickness(_ThicknessOperator):
    bl_idname = "nacre.add_thickness"
    bl_label = "Nacre: Vary Thickness"
    bl_description = "Let the film's thickness vary over the surface"
    bl_property = "source"

    source: EnumProperty(
        name="Source",
        description="What the thickness follows",
        items=[(item.id, item.name, item.description, index) for index, item in enumerate(SOURCES)],
    )
    filepath: StringProperty(
        name="Image", description="Picture of the thickness", subtype="FILE_PATH"
    )
    attribute: StringProperty(
        name="Attribute",
        description=f"Name of the attribute; without one, {PAINTED!r} is made for painting",
    )

    @classmethod
    def description(cls, _context, properties):
        return next(item.description for item in SOURCES if item.id == properties.source) + "."

    @reports_errors
    def execute(self, context):
        material = _material(context)
        image = None
        if self.source == "map" and self.filepath:
            image = _picture(bpy.path.abspath(self.filepath))  # before anything is changed
        before = [node.label or node.name for node in thickness.sources_of(material)]
        added = thickness.add_source(material, self.source)
        if before and len(thickness.sources_of(material)) == 1:
            self.report({"INFO"}, f"{added.label} takes the place of {', '.join(before)}.")
        if image is not None:
            thickness.link_image(material, image)
        if self.source.startswith("attribute"):
            name = self.attribute or _paintable(context.object)
            thickness.link_attribute(material, name, ramp=self.source == "attribute")
        return {"FINISHED"}


def _picture(path: str) -> bpy.types.Image:
    before = set(bpy.data.images)
    image = bpy.data.images.load(path, check_existing=True)
    if 0 in image.size:
        if image not in before:
            bpy.data.images.remove(image)
        raise OutputError(f"{path}: is not a picture")
    return image


def _paintable(obj: bpy.types.Object) -> str:
    """The mesh's colour attribute for painting, half-way up the range when it is new."""
    attributes = getattr(obj.data, "color_attributes", None)
    if attributes is None:
        return PAINTED
    layer = attributes.get(PAINTED)
    if layer is None:
        layer = attributes.new(PAINTED, "FLOAT_COLOR", "POINT")
        layer.data.foreach_set("color", [0.5, 0.5, 0.5, 1.0] * len(layer.data))
    attributes.active_color = layer
    return PAINTED


class NACRE_OT_remove_thickness(_ThicknessOperator):
    bl_idname = "nacre.remove_thickness"
    bl_label = "Nacre: One Thickness"
    bl_description = "Take the sources away; the film has one thickness again"

    @reports_errors
    def execute(self, context):
        thickness.remove_sources(_material(context))
        return {"FINISHED"}


class NACRE_OT_animate_thickness(_ThicknessOperator):
    bl_idname = "nacre.animate_thickness"
    bl_label = "Nacre: Run with the Scene"
    bl_description = "Let the scene's frames run the swirl's time"

    @reports_errors
    def execute(self, context):
        timed = [n for n in thickness.sources_of(_material(context)) if "Time" in n.inputs]
        if not timed:
            self.report({"ERROR"}, "No source of the thickness has a time; add Swirl or Drainage")
            return {"CANCELLED"}
        for node in timed:
            thickness.animate(node)
        return {"FINISHED"}


class NACRE_MT_thickness(bpy.types.Menu):
    bl_idname = "NACRE_MT_thickness"
    bl_label = "Vary Thickness"

    def draw(self, _context):
        for item in SOURCES:
            self.layout.operator("nacre.add_thickness", text=item.name).source = item.id
        self.layout.separator()
        self.layout.operator("nacre.remove_thickness", text="One Thickness", icon="X")


CLASSES = (
    NACRE_OT_add_thickness,
    NACRE_OT_remove_thickness,
    NACRE_OT_animate_thickness,
    NACRE_MT_thickness,
)
