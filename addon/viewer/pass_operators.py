# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Give a render passes of normals, thickness and the like, and take them away again."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty

from ..materials import scene
from ..materials.guard import reports_errors
from . import passes
from .fields import FIELDS


class NACRE_OT_add_aovs(bpy.types.Operator):
    bl_idname = "nacre.add_aovs"
    bl_label = "Nacre: Add Passes"
    bl_description = "Let a render have thickness, angle and the like as passes, in every engine"
    bl_options = {"REGISTER", "UNDO"}

    fields: EnumProperty(
        name="Passes",
        description="What the passes hold",
        items=[(item.id, item.name, item.description, 1 << i) for i, item in enumerate(FIELDS)],
        options={"ENUM_FLAG"},
        default={item.id for item in FIELDS},
    )

    @reports_errors
    def execute(self, context):
        count = passes.add(context.scene, self.fields)
        if scene.state(context.scene).osl_on:
            self.report({"WARNING"}, passes.NOT_WITH_OSL)
        else:
            self.report({"INFO"}, f"{len(self.fields)} passes of {count} materials")
        return {"FINISHED"}


class NACRE_OT_remove_aovs(bpy.types.Operator):
    bl_idname = "nacre.remove_aovs"
    bl_label = "Nacre: Remove Passes"
    bl_description = "Take the passes and their nodes out of the file again"
    bl_options = {"REGISTER", "UNDO"}

    @reports_errors
    def execute(self, context):
        passes.remove(context.scene)
        return {"FINISHED"}


CLASSES = (NACRE_OT_add_aovs, NACRE_OT_remove_aovs)
