# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light for a scene whose world is empty, and its removal. Never done without being asked."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, FloatProperty

from ..materials.guard import must_be_local, reports_errors
from . import world as lighting
from .rooms import LIGHTS, name_of


class _LightOperator(bpy.types.Operator):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if context.scene.is_editable:
            return True
        cls.poll_message_set(must_be_local("The scene", context.scene.library))
        return False


class NACRE_OT_light_scene(_LightOperator):
    bl_idname = "nacre.light_scene"
    bl_label = "Nacre: Light the Scene"
    bl_description = (
        "Put the scene into light that films can mirror. Its world is kept and comes back with Remove "
        "the Light"
    )

    light: EnumProperty(name="Light", description="What is around the scene", items=LIGHTS)
    strength: FloatProperty(
        name="Strength",
        description="How bright it is",
        default=1.0,
        min=0.0,
        max=100.0,
        soft_max=4.0,
    )
    rotation: FloatProperty(
        name="Rotation", description="Turns it around the vertical", subtype="ANGLE"
    )

    @reports_errors
    def execute(self, context):
        lighting.light_scene(context.scene, self.light, self.strength, self.rotation)
        self.report({"INFO"}, f"The scene is in the light {name_of(self.light)}.")
        return {"FINISHED"}


class NACRE_OT_remove_light(_LightOperator):
    bl_idname = "nacre.remove_light"
    bl_label = "Nacre: Remove the Light"
    bl_description = "Take Nacre's light away; the world that was there before comes back"

    @classmethod
    def poll(cls, context):
        if lighting.light_of(context.scene.world) is None:
            cls.poll_message_set("The scene has no light of Nacre's")
            return False
        return super().poll(context)

    @reports_errors
    def execute(self, context):
        lighting.remove_light(context.scene)
        return {"FINISHED"}


CLASSES = (NACRE_OT_light_scene, NACRE_OT_remove_light)
