# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit the stack of the active material."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from ..blender.drops import OntoPanels
from ..core.computation import library_problem
from ..core.manifest import ManifestError
from ..core.whole_file import write_whole
from ..materials import group as groups
from ..materials import recipe as recipes
from ..materials.guard import allows_change, reports_errors
from ..materials.material import group_node
from ..materials.subject import active_material
from ..materials.traits import traits
from . import edited, live, properties
from .stack import MOST_LAYERS, Layer, Stack, read_stack

NEW_LAYER = Layer("SiO2/Malitson", 100.0)


class _FilmOperator(bpy.types.Operator):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        material = active_material(context)
        if group_node(material) is None or not traits(material).editable_stack:
            cls.poll_message_set("The active material is not a film")
            return False
        if not allows_change(cls, material):
            return False
        problem = library_problem()
        if problem:
            cls.poll_message_set(problem)
            return False
        return True


class _StackOperator(_FilmOperator):
    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        if not recipes.is_edited(active_material(context)):
            cls.poll_message_set("Start with Edit Stack")
            return False
        return True


class NACRE_OT_edit_stack(_FilmOperator):
    bl_idname = "nacre.edit_stack"
    bl_label = "Nacre: Edit Stack"
    bl_description = "Take this material's layers out of the library and edit them"

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        recipes.set_recipe(material, recipes.recipe(material))
        properties.fill(material)
        live.warm_up(material)
        tree = group_node(material).node_tree
        is_same = tree.get(groups.TEMPLATE_TEXT) == material[recipes.TEMPLATE]
        if is_same and tree.library is None:
            tree[groups.RECIPE] = recipes.recipe(material).digest
        return {"FINISHED"}


class NACRE_OT_revert_stack(_StackOperator):
    bl_idname = "nacre.revert_stack"
    bl_label = "Nacre: Revert Stack"
    bl_description = "Back to the material of the library; values and links are kept"

    @reports_errors
    def execute(self, context):
        recipes.revert(active_material(context))
        return {"FINISHED"}


class NACRE_OT_finish_stack(_StackOperator):
    bl_idname = "nacre.finish_stack"
    bl_label = "Nacre: Compile Now"
    bl_description = "Compile the edited material with its full precision, and wait for it"

    @reports_errors
    def execute(self, context):
        edited.finish(active_material(context))
        return {"FINISHED"}


class NACRE_OT_add_layer(_StackOperator):
    bl_idname = "nacre.add_layer"
    bl_label = "Nacre: Add Layer"
    bl_description = "Add a layer below the active one"

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        made = edited.stack_of(material)
        if len(made.layers) >= MOST_LAYERS:
            self.report({"ERROR"}, f"A stack has at most {MOST_LAYERS} layers")
            return {"CANCELLED"}
        place = min(material.nacre.active + 1, len(made.layers))
        made.layers.insert(place, Layer(NEW_LAYER.medium, NEW_LAYER.thickness_nm))
        if made.varying is not None and made.varying >= place:
            made.varying += 1
        _show(material, made, place)
        return {"FINISHED"}


class NACRE_OT_remove_layer(_StackOperator):
    bl_idname = "nacre.remove_layer"
    bl_label = "Nacre: Remove Layer"
    bl_description = "Remove the active layer"

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        made = edited.stack_of(material)
        place = material.nacre.active
        if not 0 <= place < len(made.layers):
            return {"CANCELLED"}
        del made.layers[place]
        if made.varying is not None:
            made.varying = None if made.varying == place else made.varying - (made.varying > place)
        _show(material, made, max(0, place - 1))
        return {"FINISHED"}


class NACRE_OT_move_layer(_StackOperator):
    bl_idname = "nacre.move_layer"
    bl_label = "Nacre: Move Layer"
    bl_description = "Move the active layer up or down"

    direction: EnumProperty(
        name="Direction",
        description="Where to",
        items=(
            ("UP", "Up", "Nearer to the ambient"),
            ("DOWN", "Down", "Nearer to the substrate"),
        ),
    )

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        made = edited.stack_of(material)
        place = material.nacre.active
        other = place + (-1 if self.direction == "UP" else 1)
        if not (0 <= place < len(made.layers) and 0 <= other < len(made.layers)):
            return {"CANCELLED"}
        made.layers[place], made.layers[other] = made.layers[other], made.layers[place]
        if made.varying in (place, other):
            made.varying = place + other - made.varying
        _show(material, made, other)
        return {"FINISHED"}


class NACRE_OT_vary_layer(_StackOperator):
    bl_idname = "nacre.vary_layer"
    bl_label = "Nacre: Vary This Layer"
    bl_description = "Make this layer's thickness the material's slider; again: no layer"

    index: IntProperty(name="Layer", description="Which of the layers, from 0 at the top")

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        made = edited.stack_of(material)
        if made.has_scale:
            self.report({"ERROR"}, "This material scales all of its layers together")
            return {"CANCELLED"}
        if not 0 <= self.index < len(made.layers):
            return {"CANCELLED"}
        if made.varying == self.index:
            made.varying = None
        else:
            thickness = made.layers[self.index].thickness_nm
            made.varying = self.index
            made.range_nm = (0.0, max(100.0, 2.0 * thickness))
        _show(material, made, self.index)
        return {"FINISHED"}


class NACRE_OT_save_template(_StackOperator):
    bl_idname = "nacre.save_template"
    bl_label = "Nacre: Save Template"
    bl_description = "Write the stack as a template that the command line compiles and renders"

    filepath: StringProperty(
        name="File", description="Where the template goes (.toml)", subtype="FILE_PATH"
    )
    filter_glob: StringProperty(default="*.toml", options={"HIDDEN"})

    def invoke(self, context, _event):
        self.filepath = f"{bpy.path.clean_name(active_material(context).name)}.toml"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        path = Path(bpy.path.ensure_ext(bpy.path.abspath(self.filepath), ".toml"))
        if path.name == ".toml":
            self.report({"ERROR"}, "The template needs the name of a file")
            return {"CANCELLED"}
        write_whole(path, active_material(context)[recipes.TEMPLATE])
        self.report({"INFO"}, f"{path} written")
        return {"FINISHED"}


class NACRE_OT_load_template(_FilmOperator):
    bl_idname = "nacre.load_template"
    bl_label = "Nacre: Load Template"
    bl_description = "Read a film's template into this material"

    filepath: StringProperty(
        name="File",
        description="Template to take the layers from (.toml)",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    filter_glob: StringProperty(default="*.toml", options={"HIDDEN"})

    def invoke(self, context, _event):
        if self.properties.is_property_set("filepath"):  # dropped
            return self.execute(context)
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        path = Path(bpy.path.abspath(self.filepath))
        try:
            text = path.read_text("utf-8")
        except UnicodeDecodeError as error:
            raise ManifestError(f"{path}: must be UTF-8 text") from error
        read_stack(text)  # a film, before anything is changed
        compiled = recipes.compile_recipe(recipes.Recipe(text), str(path))
        wanted = recipes.Recipe(text)
        recipes.set_recipe(material, wanted)
        edited.apply(material, compiled, wanted)
        properties.fill(material)
        return {"FINISHED"}


def _show(material: bpy.types.Material, made: Stack, active: int) -> None:
    edited.set_stack(material, made)
    properties.fill(material)
    material.nacre.active = active
    live.changed(material)


class NACRE_FH_template(OntoPanels, bpy.types.FileHandler):
    bl_idname = "NACRE_FH_template"
    bl_label = "Nacre: Film from Template"
    bl_import_operator = "nacre.load_template"
    bl_file_extensions = ".toml"


CLASSES = (
    NACRE_OT_edit_stack,
    NACRE_OT_revert_stack,
    NACRE_OT_finish_stack,
    NACRE_OT_add_layer,
    NACRE_OT_remove_layer,
    NACRE_OT_move_layer,
    NACRE_OT_vary_layer,
    NACRE_OT_save_template,
    NACRE_OT_load_template,
    NACRE_FH_template,
)
