# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks of the user's own: saved, shared as one file, opened, and given to objects."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty

from ..assets import asset
from ..blender.output import OutputError
from ..materials import scene as scene_setup
from ..materials.guard import reports_errors
from ..materials.material import describe, group_node
from ..materials.subject import active_material
from ..materials.takers import named, put, takers
from ..thickness import nodes as thickness
from ..thickness import painting
from ..thickness.operators import around
from ..thickness.sources import CURVE, POINT
from . import file_names, look_file, my_looks


class _WaveMaterialOperator(bpy.types.Operator):
    @classmethod
    def poll(cls, context):
        if group_node(active_material(context)) is None:
            cls.poll_message_set("Select an object that has a wave material")
            return False
        return True


class NACRE_OT_save_look(_WaveMaterialOperator):
    bl_idname = "nacre.save_look"
    bl_label = "Nacre: Save Look"
    bl_description = (
        "Keep the active material, as it is now and with its picture, among your own looks"
    )

    name: StringProperty(
        name="Name", description="What the look is called", maxlen=file_names.LONGEST
    )
    words: StringProperty(
        name="Description", description="What the asset browser says of it; empty: the material's"
    )
    replace: BoolProperty(
        name="Replace",
        description="Put it in the place of the look that has this name already",
        default=False,
        options={"SKIP_SAVE"},
    )

    def invoke(self, context, _event):
        if not self.properties.is_property_set("name"):
            name = file_names.tidy(active_material(context).name)
            self.name = file_names.free(name, [look.name for look in my_looks.looks()])
        return context.window_manager.invoke_props_dialog(self)

    def draw(self, _context):
        column = self.layout.column()
        column.use_property_split = True
        column.prop(self, "name")
        column.prop(self, "words")
        # Always as high, so that the buttons below stay where the mouse is.
        row = column.row()
        is_taken = my_looks.has(self.name)
        row.enabled = is_taken
        row.prop(self, "replace", text="Replace the Look of This Name" if is_taken else "Replace")

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        saved = my_looks.save(
            material, self.name or material.name, self.words, replace=self.replace
        )
        self.report({"INFO"}, f"{saved.name} is among your looks")
        return {"FINISHED"}


class _LookOperator(bpy.types.Operator):
    look: StringProperty(name="Look", description="Name of a look that was saved")


class NACRE_OT_assign_look(_LookOperator):
    bl_idname = "nacre.assign_look"
    bl_label = "Nacre: Assign Look"
    bl_description = "Give the selected objects a look that you saved"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not takers(context):
            cls.poll_message_set("Select an object of this file that can have a material")
            return False
        return True

    @classmethod
    def description(cls, _context, properties):
        name = properties.look
        return f"Give the selected objects {name}." if name else cls.bl_description

    @reports_errors
    def execute(self, context):
        material = my_looks.material_of(my_looks.look(self.look))
        _assign(context, material)
        self.report({"INFO"}, f"{self.look} assigned to {named(takers(context))}")
        return {"FINISHED"}


class NACRE_OT_remove_look(_LookOperator):
    bl_idname = "nacre.remove_look"
    bl_label = "Nacre: Delete Look"
    bl_description = "Delete a look of yours and its picture; files that use it keep it"

    @classmethod
    def description(cls, _context, properties):
        name = properties.look
        return (
            f"Delete {name} and its picture; files that use it keep it."
            if name
            else cls.bl_description
        )

    def invoke(self, context, event):
        return context.window_manager.invoke_confirm(
            self,
            event,
            title=f"Delete {self.look}?",
            message="Files that use it keep it.",
            confirm_text="Delete",
        )

    @reports_errors
    def execute(self, _context):
        my_looks.remove(self.look)
        return {"FINISHED"}


class NACRE_OT_export_look(_WaveMaterialOperator):
    bl_idname = "nacre.export_look"
    bl_label = "Nacre: Share as One File"
    bl_description = "Write the active material with all that it needs to a file for others"

    filepath: StringProperty(
        name="File", description="Where the look goes (.blend)", subtype="FILE_PATH"
    )
    filter_glob: StringProperty(default="*.blend", options={"HIDDEN"})
    check_existing: BoolProperty(default=True, options={"HIDDEN"})

    def invoke(self, context, _event):
        name = file_names.tidy(active_material(context).name)
        self.filepath = f"{file_names.stem(name)}.blend"
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        path = Path(bpy.path.ensure_ext(bpy.path.abspath(self.filepath), ".blend"))
        if path.name == ".blend":
            raise OutputError("The look needs the name of a file")
        if bpy.data.filepath and path == Path(bpy.data.filepath):
            raise OutputError(f"{path}: is the file that is open; choose another name")
        material = active_material(context)
        look_file.write(material, file_names.tidy(material.name), path)
        self.report({"INFO"}, f"{path} written")
        return {"FINISHED"}


class NACRE_OT_import_look(bpy.types.Operator):
    bl_idname = "nacre.import_look"
    bl_label = "Nacre: Open Shared Look"
    bl_description = "Take the wave materials of a .blend file, such as a look that someone shared"
    bl_options = {"REGISTER", "UNDO"}

    filepath: StringProperty(
        name="File", description="File to take the look from (.blend)", subtype="FILE_PATH"
    )
    filter_glob: StringProperty(default="*.blend", options={"HIDDEN"})
    keep: BoolProperty(
        name="Keep among My Looks",
        description="Save what it has among your own looks, too",
        default=True,
    )

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        objects = takers(context)
        if not objects and not self.keep:
            raise OutputError("Select an object for the look, or keep it among your looks")
        before = asset.all_blocks()
        materials = look_file.append(Path(bpy.path.abspath(self.filepath)))
        first = next(iter(materials))
        names = [materials[first]]
        try:
            if self.keep:
                names = [_kept(material, name) for material, name in materials.items()]
        except Exception:
            look_file.sweep(before, set())
            raise
        look_file.sweep(before, {first} if objects else set())
        if objects:
            my_looks.adopt(first)
            _assign(context, first)
        said = f"{', '.join(names)}: {'among your looks' if self.keep else 'assigned'}"
        self.report({"INFO"}, said)
        return {"FINISHED"}


def _kept(material: bpy.types.Material, name: str) -> str:
    """Under its own name, or one with a number."""
    taken = [look.name for look in my_looks.looks()]
    words = material.asset_data.description if material.asset_data else ""
    name = file_names.free(name, taken)
    return my_looks.save(material, name, words, replace=False).name


def _assign(context, material: bpy.types.Material) -> None:
    """Puts it on, and gives it what it follows: an empty, a curve, a layer to paint."""
    scene = context.scene
    for target in takers(context):
        put(target, material, False)
    thickness.remove_unfollowed()
    state = describe(material)
    scene_setup.serve(scene, state.form, state.wavelength_per_path)
    my_looks.drive(material, scene)
    if context.object is None or context.object.active_material != material:
        return
    for node in thickness.sources_of(material):
        coordinates = thickness.feed_of(node, "TEX_COORD", "Vector")
        spec = thickness.spec_of(node)
        if spec.coordinates == POINT and coordinates is not None and coordinates.object is None:
            coordinates.object = around(context, POINT)
        elif spec.coordinates == CURVE:
            around(context, CURVE)
        attribute = thickness.feed_of(node, "ATTRIBUTE")
        if attribute is not None and attribute.attribute_name == painting.LAYER:
            painting.layer_of(context.object)


CLASSES = (
    NACRE_OT_save_look,
    NACRE_OT_assign_look,
    NACRE_OT_remove_look,
    NACRE_OT_export_look,
    NACRE_OT_import_look,
)
