# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels in Properties > Material and in the shader editor's sidebar."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import bpy

from ..blender import wrapped
from ..core.computation import library_problem
from ..core.form import NODES, OSL
from . import group as groups
from . import scene as scene_setup
from .documented import Documented
from .material import describe, group_node, input_socket, missing_tables, notes
from .problems import find_problems
from .subject import active_material, subject
from .traits import traits

_FINE = 200  # faces
_EXACT_ROUGH = "exact_rough"  # by its manifest name


@dataclass(frozen=True)
class Section:
    """What a feature draws before the inputs of a wave material, and the input that is in it."""

    draw: Callable[[bpy.types.UILayout, bpy.types.Context], None]
    shown: Callable[[bpy.types.Material], bpy.types.NodeSocket | None]


SECTIONS: list[Section] = []
ABOVE: list[Callable[[bpy.types.UILayout, bpy.types.Context], None]] = []
"""What features draw before all that is about the material itself."""


class _WaveOptics(Documented):
    """What both panels show of the active object's active material."""

    bl_label = "Nacre"

    @classmethod
    def poll(cls, context):
        return context.object is not None and hasattr(context.object.data, "materials")

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = True
        material = active_material(context)
        node = group_node(material)
        row = layout.row(align=True)
        row.operator_context = "INVOKE_DEFAULT"
        label = "Assign Wave Material…" if node is None else "Replace by Another…"
        row.operator("nacre.assign_material", text=label, icon="SHADING_RENDERED")
        if node is not None:
            for draw in ABOVE:
                draw(layout, context)
            draw_material(layout, context)


class _Advanced(Documented):
    """Choices that most never make."""

    bl_label = "Advanced"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 10
    manual_page = "rough"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(context.scene.nacre, "form", text="New Materials As")
        material = active_material(context)
        node = group_node(material)
        if node is None:
            return
        exact = input_socket(material, _EXACT_ROUGH)
        if exact is not None and exact.identifier in _used_inputs(node.node_tree):
            layout.prop(exact, "default_value", text=exact.name)
        _draw_form(layout, node)


class NACRE_PT_material(_WaveOptics, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


class NACRE_PT_material_advanced(_Advanced, bpy.types.Panel):
    bl_parent_id = "NACRE_PT_material"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


class NACRE_PT_shader_editor(_WaveOptics, bpy.types.Panel):
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"

    @classmethod
    def poll(cls, context):
        space = context.space_data
        shows_materials = space.tree_type == "ShaderNodeTree" and space.shader_type == "OBJECT"
        return shows_materials and super().poll(context)


class NACRE_PT_shader_editor_advanced(_Advanced, bpy.types.Panel):
    bl_parent_id = "NACRE_PT_shader_editor"
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Nacre"


def draw_material(layout, context) -> None:
    """Of the active material, which is a wave material."""
    material = active_material(context)
    node = group_node(material)
    _draw_problems(layout, context, material)
    _draw_notes(layout, material)
    if _is_round_but_flat(subject(context)):
        box = layout.box()
        wrapped.label(box, "Its faces are flat: each mirrors one spot of the world", "INFO")
        box.operator("object.shade_smooth", text="Shade Smooth")
    _draw_sockets(layout, context, material, node)


def _draw_problems(layout, context, material) -> None:
    missing = library_problem()
    if missing and traits(material).editable_stack:
        wrapped.label(layout.box(), missing, "ERROR")
    state = scene_setup.state(context.scene, missing_tables(material))
    for problem in find_problems(describe(material), state):
        box = layout.box()
        wrapped.label(box, problem.text, "ERROR")
        if problem.operator:
            box.operator(problem.operator, text=problem.action)


def _is_round_but_flat(obj: bpy.types.Object) -> bool:
    """A fine mesh all of whose faces are shaded flat, as new spheres are; what is cut, as gems are, has
    fewer. Looked at in three places, as this is asked at each redraw."""
    if obj.type != "MESH" or len(obj.data.polygons) < _FINE:
        return False
    faces = obj.data.polygons
    return not any(faces[i].use_smooth for i in (0, len(faces) // 2, len(faces) - 1))


def _draw_notes(layout, material) -> None:
    for note in notes(material):
        wrapped.label(layout.box(), note, "INFO")


def _draw_sockets(layout, context, material, node) -> None:
    for section in SECTIONS:
        section.draw(layout, context)
    column = layout.column()
    used = _used_inputs(node.node_tree)
    apart = (input_socket(material, _EXACT_ROUGH), *(s.shown(material) for s in SECTIONS))
    for socket in node.inputs:
        if socket.hide_value or socket.identifier not in used or socket in apart:
            continue
        row = column.row(align=True)
        if socket.is_linked:
            row.label(text=socket.name)
            row.label(text="Linked", icon="LINKED")
        else:
            row.prop(socket, "default_value", text=socket.name)


def _used_inputs(tree: bpy.types.NodeTree) -> set[str]:
    """Identifiers of inputs that lead to something; one that only the other form has does not."""
    outputs = (out for node in tree.nodes if node.type == "GROUP_INPUT" for out in node.outputs)
    return {out.identifier for out in outputs if out.is_linked}


def _draw_form(layout, node) -> None:
    tree = node.node_tree
    form = tree.get(groups.FORM)
    row = layout.row(align=True)
    names = {OSL: "Open Shading Language", NODES: "Nodes"}
    said = "Nodes while it is spectral" if groups.FORMER in node else names.get(form, form)
    row.label(text=f"{node.label or tree.name}, as {said}", icon="NODETREE")
    if groups.FORMER in node:
        return
    if form == NODES and scene_setup.has_osl():
        row.operator("nacre.rebuild_material", text="Use OSL").form = OSL
    elif form == OSL and not tree.get(groups.WAVELENGTHS, False):
        row.operator("nacre.rebuild_material", text="Use Nodes").form = NODES


CLASSES = (
    NACRE_PT_material,
    NACRE_PT_material_advanced,
    NACRE_PT_shader_editor,
    NACRE_PT_shader_editor_advanced,
)
