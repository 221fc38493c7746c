# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a material is compiled from: the text of a template, and the light that it is computed for. A material
that was edited stores its own; the others have that of the library's material."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass

import bpy

from ..core.faults import RecipeError
from ..core.library import Library
from ..core.light import USUAL, Conditions, conditions_problem
from ..core.manifest import CompiledMaterial, ManifestError, from_memory
from . import group as groups
from .material import asked_form, group_node, rebuild_material

TEMPLATE = "nacre_template"
CONDITIONS = Conditions("nacre_illuminant", "nacre_observer", "nacre_adaptation")
"""Custom properties of a material that was edited. The text has the schema in it."""


@dataclass(frozen=True)
class Recipe:
    """All that a compiled material depends on."""

    template: str
    conditions: Conditions = USUAL

    @property
    def digest(self) -> str:
        parts = "\0".join((self.template, *self.conditions))
        return hashlib.sha256(parts.encode()).hexdigest()


def is_edited(material: bpy.types.Material | None) -> bool:
    return material is not None and TEMPLATE in material


def recipe(material: bpy.types.Material) -> Recipe:
    """Of the material as it is asked for: its own, or that of the library's material."""
    if is_edited(material):
        template = material[TEMPLATE]
        names = [
            material.get(name, default) for name, default in zip(CONDITIONS, USUAL, strict=True)
        ]
        problem = conditions_problem(*names)
        if problem or not isinstance(template, str):
            detail = f" ({problem})" if problem else ""
            raise RecipeError(f"{material.name}: the stored stack is damaged{detail}; revert it")
        return Recipe(template, Conditions(*names))
    return recipe_of_group(group_node(material).node_tree, material.name)


def recipe_of_group(tree: bpy.types.NodeTree, name: str) -> Recipe:
    """That it was compiled from; `name` is for messages. Raises RecipeError where it is from before groups
    said so."""
    text = tree.get(groups.TEMPLATE_TEXT, "")
    if text and isinstance(text, str):
        return Recipe(text, _conditions(tree))
    known = Library.default().load(tree[groups.MATERIAL])
    if not known.template:
        raise RecipeError(f"{name} was made by an older version: assign it again")
    return Recipe(known.template, known.conditions)


def _conditions(tree: bpy.types.NodeTree) -> Conditions:
    """That the group was compiled for; older ones do not say."""
    try:
        names = json.loads(tree[groups.CONDITIONS])
    except (KeyError, TypeError, ValueError):
        return USUAL
    if not isinstance(names, list) or len(names) != len(Conditions._fields):
        return USUAL
    return USUAL if conditions_problem(*names) else Conditions(*names)


def set_recipe(material: bpy.types.Material, wanted: Recipe) -> None:
    """Stores it; what makes it visible is up to the editor."""
    material[TEMPLATE] = wanted.template
    for name, value in zip(CONDITIONS, wanted.conditions, strict=True):
        material[name] = value


def revert(material: bpy.types.Material) -> None:
    """Back to the library's material of this id."""
    compiled = Library.default().load(group_node(material).node_tree[groups.MATERIAL])
    for name in (TEMPLATE, *CONDITIONS):
        if name in material:
            del material[name]
    rebuild_material(material, compiled, asked_form(material))


def compile_recipe(wanted: Recipe, name: str) -> CompiledMaterial:
    """Takes up to seconds; touches nothing of Blender's, so that it may run in any thread.

    Raises ManifestError with every problem of the template.
    """
    import nacre

    try:
        made = nacre.compile_template(wanted.template, name, **wanted.conditions._asdict())
    except nacre.NacreError as error:
        raise ManifestError(str(error)) from error
    return from_memory(made.manifest, made.osl, made.tables)


def put_in_place(
    material: bpy.types.Material,
    compiled: CompiledMaterial,
    made_from: Recipe | None,
    form: str,
) -> None:
    """What was compiled, with values and links kept. `made_from`: None of the library's own."""
    rebuild_material(material, compiled, form)
    if made_from is not None:
        group_node(material).node_tree[groups.RECIPE] = made_from.digest
