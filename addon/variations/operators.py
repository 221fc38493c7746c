# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variations of the active material: drawn by chance, and taken by a click."""

from __future__ import annotations

import random

import bpy
from bpy.props import EnumProperty, IntProperty

from ..blender.output import OutputError
from ..materials.guard import allows_change, reports_errors
from ..materials.material import group_node
from ..materials.subject import active_material
from . import drawn as variations
from .drawing import words

_SEEDS = 2**20

# Operators remember these by name; the numbers are in no file.
KINDS = (
    (
        variations.RANDOM,
        "Randomise",
        "Anything that this material can be, as thick as it is made",
        0,
    ),
    (variations.LIKE, "More Like This", "A little thicker, rougher or finer than it is now", 1),
)


class _VariationOperator(bpy.types.Operator):
    @classmethod
    def poll(cls, context):
        material = active_material(context)
        if group_node(material) is None:
            cls.poll_message_set("Select an object that has a wave material")
            return False
        return allows_change(cls, material)


class NACRE_OT_vary_look(_VariationOperator):
    bl_idname = "nacre.vary_look"
    bl_label = "Nacre: Show Variations"
    bl_description = "Draw other values for the active material and show them as pictures to click"

    kind: EnumProperty(name="Kind", description="How far variations go", items=KINDS)
    seed: IntProperty(
        name="Seed",
        description="The same number draws the same again; -1: by chance",
        default=-1,
        min=-1,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def description(cls, _context, properties):
        return next(text for name, _, text, _ in KINDS if name == properties.kind) + "."

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        if not variations.knobs(material, with_colours=False):
            raise OutputError(f"{material.name} has nothing to vary that is not linked or animated")
        seed = self.seed if self.seed >= 0 else random.randrange(_SEEDS)
        variations.draw(material, self.kind, seed)
        return {"FINISHED"}


class NACRE_OT_take_variation(_VariationOperator):
    bl_idname = "nacre.take_variation"
    bl_label = "Nacre: Take Variation"
    bl_description = "Give the active material the values of a variation that is shown"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(
        name="Variation",
        description="Which one; 0: as it was when they were drawn",
        min=0,
        max=variations.COUNT,
    )

    @classmethod
    def description(cls, context, properties):
        """Such as `roughness 0.21 · thickness nm 310`."""
        material = active_material(context)
        drawn = variations.drawn(material) if group_node(material) else None
        if drawn is None:
            return cls.bl_description
        if properties.index == 0:
            return "Back to how it was when these were drawn."
        said = words(variations.knobs(material, with_colours=False), drawn.states[properties.index])
        return f"{said}." if said else "As it is now."

    @reports_errors
    def execute(self, context):
        material = active_material(context)
        drawn = variations.drawn(material)
        if drawn is None:
            raise OutputError("There are no variations of this material: Randomise first")
        variations.take(material, drawn.states[self.index])
        return {"FINISHED"}


CLASSES = (NACRE_OT_vary_look, NACRE_OT_take_variation)
