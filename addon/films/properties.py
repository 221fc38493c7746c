# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stack of a material as the panel edits it."""

from __future__ import annotations

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from ..core.light import AS_COMPILED, ILLUMINANTS, OBSERVERS, menu_item
from ..materials import recipe as recipes
from . import edited, live
from .stack import TECHNIQUES as TECHNIQUE_TEXTS
from .stack import Layer, Stack, StackError, read_stack, write_template

# The numbers are stored in .blend files: append, never reorder.
TECHNIQUES = tuple(
    (name, label, text, number)
    for number, (name, (label, text)) in enumerate(TECHNIQUE_TEXTS.items())
)

# Between key and name in the search for media: Blender looks for what is typed in the offered text alone.
_NAME_OF = " · "

_filling: set[int] = set()  # materials whose properties follow the stored stack


def _media_search(attribute: str):
    """For `search`: media of the library with every word that was typed in key or name, such as `Cu`
    or `copper`; all of them as long as the field still holds its value."""

    def offered(self, _context, typed: str) -> list[str]:
        words = [] if typed == getattr(self, attribute) else typed.lower().split()
        offers = (f"{key}{_NAME_OF}{name}" if name else key for key, name in edited.media())
        return [offer for offer in offers if all(word in offer.lower() for word in words)]

    return offered


def _on_edit(self, _context) -> None:
    material = self.id_data
    if material.session_uid not in _filling:
        store(material)


def _medium_edit(attribute: str):
    """For `update`: what the search offered is cut down to the key, and a name becomes its key."""

    def taken(self, context) -> None:
        text = getattr(self, attribute)
        if self.id_data.session_uid in _filling:
            return
        key, offered, _ = text.partition(_NAME_OF)
        key = key if offered else edited.meant(text)
        if key != text:
            setattr(self, attribute, key)  # which comes here again
        else:
            _on_edit(self, context)

    return taken


class NACRE_PG_layer(bpy.types.PropertyGroup):
    medium: StringProperty(
        name="Medium",
        description="A key of the library such as TiO2/Sarkar, an index such as 1.5 or 2.1+0.05i, "
        "or cauchy 1.54 0.004",
        search=_media_search("medium"),
        search_options={"SUGGESTION"},
        update=_medium_edit("medium"),
    )
    thickness_nm: FloatProperty(
        name="Thickness (nm)",
        description="Thickness of the layer",
        min=0.0,
        max=1e8,
        soft_max=2000.0,
        step=100,
        precision=1,
        update=_on_edit,
    )
    coherent: BoolProperty(
        name="Interferes",
        description="Off: too thick for interference, as a pane is (incoherent)",
        default=True,
        update=_on_edit,
    )


class NACRE_PG_stack(bpy.types.PropertyGroup):
    """Follows the template that the material stores; an edit goes back into it."""

    ambient: StringProperty(
        name="Above",
        description="What lies over the film, where the light comes from (the ambient)",
        search=_media_search("ambient"),
        search_options={"SUGGESTION"},
        update=_medium_edit("ambient"),
    )
    layers: CollectionProperty(type=NACRE_PG_layer)
    active: IntProperty(name="Layer", description="The layer whose fields are shown below")
    substrate: StringProperty(
        name="Below",
        description="What the film lies on (the substrate)",
        search=_media_search("substrate"),
        search_options={"SUGGESTION"},
        update=_medium_edit("substrate"),
    )
    varying: IntProperty(
        name="Varying Layer", description="Whose thickness varies; -1: none", default=-1
    )
    low_nm: FloatProperty(
        name="From (nm)",
        description="Least thickness that the slider and pictures of the thickness can give",
        min=0.0,
        max=1e6,
        precision=1,
        update=_on_edit,
    )
    high_nm: FloatProperty(
        name="To (nm)",
        description="Largest thickness that the slider and pictures of the thickness can give",
        min=0.0,
        max=1e6,
        precision=1,
        default=1000.0,
        update=_on_edit,
    )
    illuminant: EnumProperty(
        name="Illuminant",
        description="The light that white light of the scene stands for",
        items=ILLUMINANTS,
        update=_on_edit,
    )
    observer: EnumProperty(
        name="Observer",
        description="Whose eyes the colours are for",
        items=OBSERVERS,
        update=_on_edit,
    )
    technique: EnumProperty(
        name="Technique",
        description="What the reflectance is computed by; all but the first are for comparison",
        items=TECHNIQUES,
        update=_on_edit,
    )
    plot_angle_deg: FloatProperty(
        name="Angle (°)",
        description="Angle of incidence of the plotted spectrum",
        min=0.0,
        max=89.0,
        precision=0,
    )


def fill(material: bpy.types.Material) -> None:
    """Shows the stack that the material stores."""
    wanted = recipes.recipe(material)
    stack = read_stack(wanted.template)
    shown = material.nacre
    _filling.add(material.session_uid)
    try:
        shown.ambient, shown.substrate = stack.ambient, stack.substrate
        shown.layers.clear()
        for layer in stack.layers:
            item = shown.layers.add()
            item.medium, item.thickness_nm = layer.medium, layer.thickness_nm
            item.coherent = layer.coherent
        shown.varying = -1 if stack.varying is None else stack.varying
        shown.low_nm, shown.high_nm = stack.range_nm
        shown.illuminant = menu_item(wanted.conditions.illuminant)
        shown.observer = wanted.conditions.observer
        shown.technique = stack.technique
        shown.active = min(shown.active, max(0, len(stack.layers) - 1))
    finally:
        _filling.discard(material.session_uid)


def store(material: bpy.types.Material) -> None:
    """Takes what is shown over into the stored template, and makes it visible."""
    shown = material.nacre
    varying = shown.varying if 0 <= shown.varying < len(shown.layers) else None
    recipe = recipes.recipe(material)
    before = read_stack(recipe.template)
    stack = Stack(
        ambient=shown.ambient,
        layers=[Layer(i.medium, _tidy(i.thickness_nm), i.coherent) for i in shown.layers],
        substrate=shown.substrate,
        varying=varying,
        range_nm=(_tidy(shown.low_nm), max(_tidy(shown.high_nm), _tidy(shown.low_nm) + 1.0)),
        technique=shown.technique,
        rest=before.rest,
        look_range_nm=before.look_range_nm,
    )
    try:
        text = write_template(stack)
    except StackError as error:
        live.refuse(material, str(error))
        return
    conditions = recipe.conditions._replace(observer=shown.observer)
    item = menu_item(conditions.illuminant)
    if shown.illuminant == AS_COMPILED and item != AS_COMPILED:
        shown.illuminant = item  # which comes here again
        return
    if shown.illuminant != AS_COMPILED:
        conditions = conditions._replace(illuminant=shown.illuminant)
    recipes.set_recipe(material, recipes.Recipe(text, conditions))
    live.changed(material)


def _tidy(number: float) -> float:
    """Without the digits that single precision adds."""
    return float(f"{number:.7g}")


CLASSES = (NACRE_PG_layer, NACRE_PG_stack)


def register() -> None:
    bpy.types.Material.nacre = PointerProperty(type=NACRE_PG_stack)


def unregister() -> None:
    del bpy.types.Material.nacre
