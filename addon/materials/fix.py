# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mends for what the material panel finds wrong."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty

from ..core.form import choose_form
from ..core.library import Library
from . import group as groups
from . import recipe as recipes
from . import scene as scene_setup
from .guard import allows_change, reports_errors
from .material import asked_form, group_node
from .subject import active_material


class NACRE_OT_use_cycles(bpy.types.Operator):
    bl_idname = "nacre.use_cycles"
    bl_label = "Nacre: Use Cycles"
    bl_description = "Render this scene with Cycles"
    bl_options = {"REGISTER", "UNDO"}

    @reports_errors
    def execute(self, context):
        context.scene.render.engine = "CYCLES"
        return {"FINISHED"}


class NACRE_OT_use_cpu(bpy.types.Operator):
    bl_idname = "nacre.use_cpu"
    bl_label = "Nacre: Render on the CPU"
    bl_description = "Render this scene on the CPU, where Open Shading Language always runs"
    bl_options = {"REGISTER", "UNDO"}

    @reports_errors
    def execute(self, context):
        context.scene.cycles.device = "CPU"
        return {"FINISHED"}


class NACRE_OT_use_osl(bpy.types.Operator):
    bl_idname = "nacre.use_osl"
    bl_label = "Nacre: Turn On Open Shading Language"
    bl_description = "Render this scene with Cycles and Open Shading Language"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        if not scene_setup.has_osl():
            cls.poll_message_set("This Blender was built without Open Shading Language")
            return False
        return True

    @reports_errors
    def execute(self, context):
        scene_setup.use_osl(context.scene)
        return {"FINISHED"}


class NACRE_OT_use_wavelengths(bpy.types.Operator):
    bl_idname = "nacre.use_wavelengths"
    bl_label = "Nacre: Turn On Wavelengths"
    bl_description = (
        "Turn on motion blur with a flat shutter curve, which gives each path a wavelength. "
        "With a shutter of 0 nothing blurs"
    )
    bl_options = {"REGISTER", "UNDO"}

    @reports_errors
    def execute(self, context):
        scene_setup.use_wavelengths(context.scene)
        return {"FINISHED"}


class NACRE_OT_rebuild_material(bpy.types.Operator):
    bl_idname = "nacre.rebuild_material"
    bl_label = "Nacre: Rebuild Material"
    bl_description = "Make the material's nodes and tables again; values and links are kept"
    bl_options = {"REGISTER", "UNDO"}

    form: EnumProperty(
        name="Form",
        description="Which form the material has afterwards",
        items=(
            ("same", "Same", "The form that the material has", 0),
            ("osl", "Open Shading Language", "Exact colours; Cycles on the CPU or with OptiX", 1),
            ("nodes", "Nodes", "Works in EEVEE and on every GPU", 2),
        ),
        default="same",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context):
        material = active_material(context)
        if group_node(material) is None:
            cls.poll_message_set("Select an object with a wave material")
            return False
        return allows_change(cls, material)

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        tree = group_node(material).node_tree
        if recipes.is_edited(material):
            made_from = recipes.recipe(material)
            compiled = recipes.compile_recipe(made_from, material.name)
        else:
            made_from, compiled = None, Library.default().load(tree[groups.MATERIAL])
        wanted = asked_form(material) if self.form == "same" else self.form
        form = choose_form(compiled, wanted, scene_setup.renderer(context.scene))
        recipes.put_in_place(material, compiled, made_from, form)
        scene_setup.serve(context.scene, form, compiled.wavelength_per_path)
        return {"FINISHED"}


CLASSES = (
    NACRE_OT_use_cycles,
    NACRE_OT_use_cpu,
    NACRE_OT_use_osl,
    NACRE_OT_use_wavelengths,
    NACRE_OT_rebuild_material,
)
