# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stack editor: layers, what lies over and under them, the light, and the colours that come of it."""

from __future__ import annotations

import bpy

from ..blender import wrapped
from ..core.light import AS_COMPILED, USUAL, Conditions, menu_item
from ..materials import recipe as recipes
from ..materials.documented import Documented
from ..materials.material import group_node
from ..materials.subject import active_material
from ..materials.thickness import thickness_socket
from ..materials.traits import traits
from . import edited, live, swatch
from .messages import spoken


class NACRE_UL_layers(bpy.types.UIList):
    def draw_item(self, _context, layout, data, item, _icon, _active, _name, index):
        row = layout.row(align=True)
        row.label(text=edited.medium_name(item.medium))
        sub = row.row(align=True)
        sub.ui_units_x = 3.2
        # A label, as a number field that is too narrow leaves the last digits out.
        varies = index == data.varying
        sub.label(text="varies" if varies else f"{item.thickness_nm:.6g}")
        icon = "DECORATE_DRIVER" if varies else "DECORATE"
        row.operator("nacre.vary_layer", text="", icon=icon, emboss=False).index = index
        row.prop(
            item, "coherent", text="", emboss=False, icon="MOD_WAVE" if item.coherent else "REMOVE"
        )


def draw_progress(layout, material) -> None:
    """While what is seen are quick tables, and the exact ones are on their way."""
    done = live.progress(material)
    if done is not None:
        layout.progress(factor=done, text="Compiling exact colours")


class _StackEditor(Documented):
    manual_page = "stacks"
    bl_label = "Stack"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        material = active_material(context)
        return group_node(material) is not None and traits(material).editable_stack

    def draw(self, context):
        layout = self.layout
        material = active_material(context)
        if not recipes.is_edited(material):
            layout.operator("nacre.edit_stack", text="Edit Stack", icon="MOD_WAVE")
            return
        if edited.damage(material):
            layout.label(text="The stored stack cannot be read", icon="ERROR")
            layout.operator("nacre.revert_stack", text="Revert Stack", icon="LOOP_BACK")
            return
        shown = material.nacre
        draw_progress(layout, material)
        _draw_layers(layout, shown)
        if live.problem(material):
            box = layout.box()
            for text in spoken(live.problem(material)):
                wrapped.label(box, text, "ERROR")
        _draw_colours(layout, material, shown)
        row = layout.row(align=True)
        row.operator("nacre.save_template", text="Save…", icon="FILE_TICK")
        row.operator("nacre.load_template", text="Load…", icon="FILE_FOLDER")
        row.operator("nacre.revert_stack", text="", icon="LOOP_BACK")


def _draw_layers(layout, shown) -> None:
    layout.prop(shown, "ambient", icon="TRIA_DOWN_BAR")
    row = layout.row()
    row.template_list("NACRE_UL_layers", "", shown, "layers", shown, "active", rows=4)
    column = row.column(align=True)
    column.operator("nacre.add_layer", text="", icon="ADD")
    column.operator("nacre.remove_layer", text="", icon="REMOVE")
    column.separator()
    column.operator("nacre.move_layer", text="", icon="TRIA_UP").direction = "UP"
    column.operator("nacre.move_layer", text="", icon="TRIA_DOWN").direction = "DOWN"
    if 0 <= shown.active < len(shown.layers):
        fields = layout.column(align=True)
        layer = shown.layers[shown.active]
        fields.prop(layer, "medium", text=f"Layer {shown.active + 1}")
        if shown.active == shown.varying:
            fields.prop(shown, "low_nm")
            fields.prop(shown, "high_nm")
        else:
            fields.prop(layer, "thickness_nm")
    layout.prop(shown, "substrate", icon="TRIA_UP_BAR")


class _Advanced(Documented):
    """Choices that most never make."""

    manual_page = "models"

    bl_label = "Computation"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        material = active_material(context)
        return recipes.is_edited(material) and not edited.damage(material)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        material = active_material(context)
        layout.prop(material.nacre, "technique")
        layout.prop(material.nacre, "illuminant")
        layout.prop(material.nacre, "observer")
        unusual = _unusual_light(recipes.recipe(material).conditions)
        if unusual:
            layout.label(text=unusual, icon="LIGHT")


def _unusual_light(conditions: Conditions) -> str:
    """What the menus do not say."""
    words = []
    if menu_item(conditions.illuminant) == AS_COMPILED:
        words.append(conditions.illuminant)
    if conditions.adaptation == "none":
        words.append("its colour is in the tables")
    elif conditions.adaptation != USUAL.adaptation:
        words.append(f"adapted by {conditions.adaptation.upper()}")
    return ", ".join(words)


def _draw_colours(layout, material, shown) -> None:
    socket = thickness_socket(material)
    value = socket.default_value if socket is not None else 1.0
    row = layout.row()
    column = row.column(align=True)
    column.label(text="Thicker ↑   grazing →")
    column.template_icon(icon_value=swatch.swatch(material), scale=6.0)
    column = row.column(align=True)
    column.label(text="380 → 780 nm")
    column.template_icon(
        icon_value=swatch.spectrum(material, value, shown.plot_angle_deg), scale=6.0
    )
    layout.prop(shown, "plot_angle_deg", slider=True)


class NACRE_PT_stack(_StackEditor, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "NACRE_PT_material"


class NACRE_PT_shader_editor_stack(_StackEditor, bpy.types.Panel):
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_parent_id = "NACRE_PT_shader_editor"


class NACRE_PT_stack_advanced(_Advanced, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "NACRE_PT_stack"


class NACRE_PT_shader_editor_stack_advanced(_Advanced, bpy.types.Panel):
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"
    bl_parent_id = "NACRE_PT_shader_editor_stack"


CLASSES = (
    NACRE_UL_layers,
    NACRE_PT_stack,
    NACRE_PT_stack_advanced,
    NACRE_PT_shader_editor_stack,
    NACRE_PT_shader_editor_stack_advanced,
)
