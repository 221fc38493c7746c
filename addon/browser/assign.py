# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Give the selected objects a wave material."""

from __future__ import annotations

import bpy
from bpy.props import BoolProperty, EnumProperty

from ..core.form import AUTO, choose_form
from ..core.library import Library
from ..core.looks import variants
from ..materials import scene as scene_setup
from ..materials.guard import must_be_local, reports_errors
from ..materials.material import create_material, discard_material
from ..materials.properties import FORMS
from ..materials.takers import chosen_objects, named, put, takers, takes_materials
from ..thickness import nodes as thickness
from ..thickness.dress import dress
from . import chosen, thumbnails

# Blender keeps no reference to the texts of a computed list of items.
_items: list[tuple[str, str, str, str, int]] = []


def material_items(_self, _context):
    offered = variants(Library.default().entries()).values()
    fresh = [
        (
            item.key,
            item.name,
            item.entry.description,
            thumbnails.icon(item.key) or "MATERIAL",
            index,
        )
        for index, item in enumerate(offered)
    ]
    if fresh != _items:
        _items[:] = fresh
    return _items


class NACRE_OT_assign_material(bpy.types.Operator):
    bl_idname = "nacre.assign_material"
    bl_label = "Nacre: Assign Material"
    bl_description = "Give the selected objects a material whose colour comes from waves"
    bl_options = {"REGISTER", "UNDO"}
    bl_property = "material"

    material: EnumProperty(name="Material", description="Material to assign", items=material_items)
    form: EnumProperty(
        name="Form",
        description="Which form the material takes",
        items=FORMS,
        default=AUTO,
        options={"SKIP_SAVE"},
    )
    new_slot: BoolProperty(
        name="New Slot",
        description="Add a material slot instead of replacing the material of the active one",
        default=False,
    )

    @classmethod
    def poll(cls, context):
        if takers(context):
            return True
        linked = next((obj for obj in chosen_objects(context) if not takes_materials(obj)), None)
        if linked is None:
            cls.poll_message_set("Select an object that can have a material")
        else:
            library = linked.library or linked.data.library
            cls.poll_message_set(must_be_local(linked.name, library))
        return False

    def invoke(self, context, _event):
        self.form = context.scene.nacre.form
        if self.properties.is_property_set("material"):
            return self.execute(context)
        context.window_manager.invoke_search_popup(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        if not self.material:
            self.report({"ERROR"}, "There are no compiled materials; reinstall the extension")
            return {"CANCELLED"}
        library = Library.default()
        offered = variants(library.entries())
        variant = offered[self.material]
        compiled = library.load(variant.entry.id)
        requested = self.form if self.form != AUTO else context.scene.nacre.form
        form = choose_form(compiled, requested, scene_setup.renderer(context.scene))
        material = create_material(compiled, form)
        material.name = variant.name
        targets = takers(context)
        try:
            if not variant.is_even:
                dress(material, compiled)
            for target in targets:
                put(target, material, self.new_slot)
        except Exception:
            discard_material(material, compiled)
            raise
        thickness.remove_unfollowed()
        chosen.remember(variant.key)
        context.window_manager.nacre.number = list(offered).index(variant.key)
        said = [f"{variant.name} assigned to {named(targets)}."]
        said += scene_setup.serve(context.scene, form, compiled.wavelength_per_path)
        self.report({"INFO"}, " ".join([*said, *(f"{note}." for note in compiled.notes)]))
        return {"FINISHED"}


class NACRE_OT_favourite(bpy.types.Operator):
    bl_idname = "nacre.favourite"
    bl_label = "Nacre: Favourite"
    bl_description = "Keep this material among the favourites, or take it out of them"
    bl_property = "material"

    material: EnumProperty(name="Material", description="Which material", items=material_items)

    def invoke(self, context, _event):
        if self.properties.is_property_set("material"):
            return self.execute(context)
        context.window_manager.invoke_search_popup(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, _context):
        is_one = chosen.turn_favourite(self.material)
        name = variants(Library.default().entries())[self.material].name
        words = "is a favourite now" if is_one else "is no favourite any more"
        self.report({"INFO"}, f"{name} {words}.")
        return {"FINISHED"}


CLASSES = (NACRE_OT_assign_material, NACRE_OT_favourite)
