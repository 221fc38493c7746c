# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of the extension that belong to a scene, and the stack of a material as the panel edits it."""

from __future__ import annotations

import time

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

from ..browser import thumbnails
from ..core.library import Library
from ..core.light import AS_COMPILED, ILLUMINANTS, OBSERVERS, menu_item
from ..core.looks import variants
from ..core.words import finds
from ..viewer import views
from ..viewer.fields import FIELDS, SHADED
from . import edited as stacks
from . import live
from .stack import TECHNIQUES as TECHNIQUE_TEXTS
from .stack import Layer, Stack, StackError

# The numbers are stored in .blend files: append, never reorder.
FORMS = (
    ("auto", "Automatic", "Open Shading Language where the renderer runs it, else nodes", 0),
    ("osl", "Open Shading Language", "Exact colours; Cycles on the CPU or with OptiX", 1),
    ("nodes", "Nodes", "Works in EEVEE and on every GPU; colours outside the gamut are clipped", 2),
)
VIEWS = (
    (SHADED, "Shaded", "Materials as they are", 0),
    *((item.id, item.name, item.description, 1 + i) for i, item in enumerate(FIELDS)),
)
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
        offers = (f"{key}{_NAME_OF}{name}" if name else key for key, name in stacks.media())
        return [offer for offer in offers if all(word in offer.lower() for word in words)]

    return offered


def _on_edit(self, _context) -> None:
    material = self.id_data
    if material.session_uid not in _filling:
        store(material)


def _medium_edit(attribute: str):
    """For `update`: what the search offered is cut down to the key, and a name becomes its key."""

    def edited(self, context) -> None:
        text = getattr(self, attribute)
        if self.id_data.session_uid in _filling:
            return
        key, offered, _ = text.partition(_NAME_OF)
        key = key if offered else stacks.meant(text)
        if key != text:
            setattr(self, attribute, key)  # which comes here again
        else:
            _on_edit(self, context)

    return edited


def _shown_view(_self) -> int:
    """Read from the nodes, so that undo and files agree with it."""
    shown = views.shown()
    return next(number for name, _, _, number in VIEWS if name == shown)


def _show_view(self, number: int) -> None:
    views.show(self.id_data, VIEWS[number][0])


def _is_lamp(_self, obj: bpy.types.Object) -> bool:
    return obj.type == "LIGHT"


def _on_lamp(self, _context) -> None:
    views.choose_lamp(self.id_data, self.view_lamp)


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


class NACRE_PG_scene(bpy.types.PropertyGroup):
    form: EnumProperty(
        name="Form",
        description="Which form new wave materials take",
        items=FORMS,
        default="auto",
    )
    view: EnumProperty(
        name="View",
        description="What wave materials show; files are saved with their shaded surfaces",
        items=VIEWS,
        get=_shown_view,
        set=_show_view,
    )
    view_lamp: PointerProperty(
        name="Lamp",
        description="What To Light points to; none: the nearest",
        type=bpy.types.Object,
        poll=_is_lamp,
        update=_on_lamp,
    )


# Blender keeps no reference to the texts of a computed list of items, and asks for it several times at
# each redraw, where a look at the library's files each time would be felt.
_found: list[tuple[str, str, str, int, int]] = []
_found_for: list[object] = [None, ""]  # the entries and the search
_looked_at = [0.0]
_SHOWN_FIRST = "tempered_steel"  # as long as nothing was chosen
_LOOK_AGAIN = 0.5  # seconds


def _choices(self, _context):
    """What the search finds, each with the number that it has among all."""
    now = time.monotonic()
    if _found_for[1] == self.search and now < _looked_at[0] + _LOOK_AGAIN:
        return _found
    _looked_at[0] = now
    entries = Library.default().entries()
    if _found_for[0] is not entries or _found_for[1] != self.search:
        _found_for[:] = entries, self.search
        _found[:] = [
            (item.key, item.label, item.entry.description, thumbnails.icon(item.key), number)
            for number, item in enumerate(variants(entries).values())
            if finds(item.entry, self.search)
        ]
    return _found


def _choice(self) -> int:
    """The one that was chosen, or the first that is found while that is not among them. Read without a
    value of its own: Blender warns of one that is not offered."""
    numbers = [item[4] for item in _choices(self, None)]
    if self.number in numbers or not numbers:
        return self.number
    first = [item[4] for item in _found if item[0] == _SHOWN_FIRST]
    return (first or numbers)[0]


def _choose(self, number: int) -> None:
    self.number = number


def _on_search(self, _context) -> None:
    if self.finds_any():
        self.number = _choice(self)


class NACRE_PG_browser(bpy.types.PropertyGroup):
    """Of the side bar; of this session, in no file."""

    search: StringProperty(
        name="Search",
        description="A look, a thing or a material: iridescent, burnt, beetle, CD, gasoline …",
        options={"TEXTEDIT_UPDATE"},
        update=_on_search,
    )
    number: IntProperty(
        name="Number", description="Of the material that was chosen, among all", default=-1
    )
    choice: EnumProperty(
        name="Material",
        description="Which material",
        items=_choices,
        get=_choice,
        set=_choose,
    )
    recent: StringProperty(name="Recent", description="Assigned last, the last one first")
    favourites: StringProperty(name="Favourites", description="In the order in which they came")
    shows_fine: BoolProperty(
        name="More", description="Show what is seldom changed, too", default=False
    )

    def finds_any(self) -> bool:
        return bool(_choices(self, None))


class NACRE_PG_probe(bpy.types.PropertyGroup):
    """What the last probe found, as JSON; of this session, in no file."""

    json: StringProperty(name="JSON", description="All numbers and both spectra")


def fill(material: bpy.types.Material) -> None:
    """Shows the stack that the material stores."""
    wanted = stacks.recipe(material)
    stack = stacks.read_stack(wanted.template)
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
    recipe = stacks.recipe(material)
    before = stacks.read_stack(recipe.template)
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
        text = stacks.write_template(stack)
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
    stacks.set_recipe(material, stacks.Recipe(text, conditions))
    live.changed(material)


def _tidy(number: float) -> float:
    """Without the digits that single precision adds."""
    return float(f"{number:.7g}")


CLASSES = (
    NACRE_PG_layer,
    NACRE_PG_stack,
    NACRE_PG_scene,
    NACRE_PG_browser,
    NACRE_PG_probe,
)


def register() -> None:
    bpy.types.Scene.nacre = PointerProperty(type=NACRE_PG_scene)
    bpy.types.Material.nacre = PointerProperty(type=NACRE_PG_stack)
    bpy.types.WindowManager.nacre = PointerProperty(type=NACRE_PG_browser)
    bpy.types.WindowManager.nacre_probe = PointerProperty(type=NACRE_PG_probe)


def unregister() -> None:
    del bpy.types.WindowManager.nacre_probe
    del bpy.types.WindowManager.nacre
    del bpy.types.Material.nacre
    del bpy.types.Scene.nacre
