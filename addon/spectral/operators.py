# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectra for all colours of a file, and back."""

from __future__ import annotations

import bpy
from bpy.props import StringProperty

from ..core.computation import library_problem
from ..materials.guard import reports_errors
from . import marks, outlook

_remarks: list = []
"""What the last *Make Spectral* left as RGB."""


def remarks() -> list:
    return _remarks


def forget() -> None:
    _remarks.clear()


class NeedsLibrary(bpy.types.Operator):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        problem = library_problem()
        if problem:
            cls.poll_message_set(problem)
        return not problem


class NACRE_OT_make_spectral(NeedsLibrary):
    bl_idname = "nacre.make_spectral"
    bl_label = "Nacre: Make Spectral"
    bl_description = (
        "Give every colour of the file a spectrum, by a node in front of each: Render Spectral then "
        "renders wavelengths. Anything else shows what it did before, and Back to RGB is an exact undo"
    )

    @reports_errors
    def execute(self, context):
        from . import convert

        report = convert.make_spectral()
        _remarks[:] = report.remarks
        outlook.look(context.scene)
        left = f"; {len(_remarks)} stay RGB, see the panel" if _remarks else ""
        self.report({"INFO"}, f"{report.spectra} colours got a spectrum{left}.")
        return {"FINISHED"}


class NACRE_OT_make_rgb(bpy.types.Operator):
    bl_idname = "nacre.make_rgb"
    bl_label = "Nacre: Back to RGB"
    bl_description = (
        "Take all spectra out again: the file is as it was before Make Spectral, but for what was "
        "changed since"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        if not marks.is_spectral():
            cls.poll_message_set("No colour of the file has a spectrum")
            return False
        return True

    @reports_errors
    def execute(self, _context):
        from . import convert

        count = convert.make_rgb()
        forget()
        outlook.forget()
        self.report({"INFO"}, f"{count} spectra were taken out.")
        return {"FINISHED"}


class NACRE_OT_look_at_bands(NeedsLibrary):
    bl_idname = "nacre.look_at_bands"
    bl_label = "Nacre: How Many Bands"
    bl_description = (
        "How many wavelengths this scene's lamps, films and glass need, and how near they come"
    )
    bl_options = {"REGISTER"}

    @reports_errors
    def execute(self, context):
        outlook.look(context.scene)
        self.report({"INFO"}, "; ".join(outlook.lines()))
        return {"FINISHED"}


class NACRE_OT_show_rgb(bpy.types.Operator):
    bl_idname = "nacre.show_rgb"
    bl_label = "Nacre: Show What Stays RGB"
    bl_description = "Select the objects that have it"
    bl_options = {"REGISTER", "UNDO"}

    kind: StringProperty(name="Kind", description="Of the block of data")
    name: StringProperty(name="Name", description="Its name")

    @reports_errors
    def execute(self, context):
        users = [item for item in context.view_layer.objects if _has(item, self.kind, self.name)]
        if not users:
            self.report(
                {"WARNING"}, f"No object of this view layer has the {self.kind} {self.name}"
            )
            return {"CANCELLED"}
        for item in context.view_layer.objects:
            item.select_set(item in users)
        context.view_layer.objects.active = users[0]
        return {"FINISHED"}


def _has(item: bpy.types.Object, kind: str, name: str) -> bool:
    if kind == "object":
        return item.name == name
    if kind == "lamp":
        return item.type == "LIGHT" and item.data.name == name
    materials = [slot.material for slot in item.material_slots if slot.material is not None]
    if kind == "material":
        return name in {material.name for material in materials}
    group = bpy.data.node_groups.get(name)
    return any(
        node.type == "GROUP" and node.node_tree == group
        for material in materials
        if material.node_tree is not None
        for node in material.node_tree.nodes
    )


CLASSES = (
    NACRE_OT_make_spectral,
    NACRE_OT_make_rgb,
    NACRE_OT_look_at_bands,
    NACRE_OT_show_rgb,
)
