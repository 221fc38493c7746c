# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectra for all colours of a file, for lamps and the world, and back."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, StringProperty

from ..core.computation import library_problem
from ..materials.guard import must_be_local, reports_errors
from . import marks
from .marks import WORLD

_remarks: list = []
"""What the last *Make Spectral* left as RGB."""


def remarks() -> list:
    return _remarks


def forget() -> None:
    _remarks.clear()


class _NeedsLibrary(bpy.types.Operator):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        problem = library_problem()
        if problem:
            cls.poll_message_set(problem)
        return not problem


class NACRE_OT_make_spectral(_NeedsLibrary):
    bl_idname = "nacre.make_spectral"
    bl_label = "Nacre: Make Spectral"
    bl_description = (
        "Give every colour of the file a spectrum, by a node in front of each: Render Spectral then "
        "renders wavelengths. Anything else shows what it did before, and Back to RGB is an exact undo"
    )

    @reports_errors
    def execute(self, _context):
        from . import convert

        report = convert.make_spectral()
        _remarks[:] = report.remarks
        left = f"; {len(_remarks)} stay RGB, see the panel" if _remarks else ""
        self.report({"INFO"}, f"{report.spectra} colours got a spectrum{left}.")
        return {"FINISHED"}


class NACRE_OT_make_rgb(bpy.types.Operator):
    bl_idname = "nacre.make_rgb"
    bl_label = "Nacre: Back to RGB"
    bl_description = (
        "Take all spectra out again: the file is as it was before Make Spectral, but for what was "
        "changed since"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        if not marks.is_spectral():
            cls.poll_message_set("No colour of the file has a spectrum")
            return False
        return True

    @reports_errors
    def execute(self, _context):
        from . import convert

        count = convert.make_rgb()
        forget()
        self.report({"INFO"}, f"{count} spectra were taken out.")
        return {"FINISHED"}


_items: list[tuple[str, str, str]] = []


def _lights(_self, _context):
    """All lights that are known. Blender wants the list to live on."""
    if not _items:
        import nacre

        _items.extend((name, name, "of the CIE") for name in _CIE)
        for key in nacre.library.keys("spectra"):
            spectrum = nacre.library.spectrum(key)
            if spectrum.kind == "emission" and not key.startswith("cie/"):
                _items.append((key, spectrum.name, key))
        for kelvin in (1850, 2700, 3000, 3500, 4100, 5000):
            _items.append((f"blackbody:{kelvin}", f"Black body, {kelvin} K", "Planck's law"))
        _items.extend(_LINES)
    return _items


_CIE = (
    "D65",
    "D50",
    "D55",
    "D75",
    "A",
    "B",
    "C",
    "E",
    "F2",
    "F7",
    "F11",
    "F12",
    "LED-B3",
    "LED-RGB1",
)
_LINES = (
    ("line:589.0@2,589.6@1", "Sodium lines", "589.0 and 589.6 nm"),
    (
        "line:404.7@0.4,435.8@1,546.1@1.1,577@0.3,579.1@0.3",
        "Mercury lines",
        "of a low-pressure lamp",
    ),
    ("line:632.8", "Helium-neon laser", "632.8 nm"),
    ("line:532", "Green laser", "532 nm"),
    ("line:450", "Blue laser diode", "450 nm"),
)


class NACRE_OT_give_light(_NeedsLibrary):
    bl_idname = "nacre.give_light"
    bl_label = "Nacre: Light of a Lamp"
    bl_description = (
        "Choose what a lamp or the world is: daylight, tungsten, a fluorescent tube, sodium …"
    )
    bl_property = "light"

    lamp: StringProperty(name="Lamp", description="An object of the scene, or World", default="")
    light: EnumProperty(name="Light", description="What it is; as bright as it was", items=_lights)

    def invoke(self, context, _event):
        context.window_manager.invoke_search_popup(self)
        return {"FINISHED"}

    @reports_errors
    def execute(self, context):
        from . import convert
        from .described import Described

        spectrum = Described.named(self.light)
        name = self.lamp or (context.object.name if context.object else WORLD)
        found = context.scene.objects.get(name)
        if found is not None and found.type == "LIGHT":
            if not found.data.is_editable:
                self.report({"ERROR"}, must_be_local(name, found.data.library))
                return {"CANCELLED"}
            convert.give_lamp(found.data, spectrum)
        elif name == WORLD and context.scene.world is not None:
            convert.give_world(context.scene.world, spectrum)
        else:
            self.report({"ERROR"}, f"{name} is no lamp of the scene")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{name} is {spectrum.name} now, as bright as before.")
        return {"FINISHED"}


class NACRE_OT_show_rgb(bpy.types.Operator):
    bl_idname = "nacre.show_rgb"
    bl_label = "Nacre: Show What Stays RGB"
    bl_description = "Select the objects that have it"
    bl_options = {"REGISTER", "UNDO"}

    kind: StringProperty(name="Kind", description="Of the block of data")
    name: StringProperty(name="Name", description="Its name")

    @reports_errors
    def execute(self, context):
        users = [item for item in context.view_layer.objects if _has(item, self.kind, self.name)]
        if not users:
            self.report(
                {"WARNING"}, f"No object of this view layer has the {self.kind} {self.name}"
            )
            return {"CANCELLED"}
        for item in context.view_layer.objects:
            item.select_set(item in users)
        context.view_layer.objects.active = users[0]
        return {"FINISHED"}


def _has(item: bpy.types.Object, kind: str, name: str) -> bool:
    if kind == "object":
        return item.name == name
    if kind == "lamp":
        return item.type == "LIGHT" and item.data.name == name
    materials = [slot.material for slot in item.material_slots if slot.material is not None]
    if kind == "material":
        return name in {material.name for material in materials}
    group = bpy.data.node_groups.get(name)
    return any(
        node.type == "GROUP" and node.node_tree == group
        for material in materials
        if material.node_tree is not None
        for node in material.node_tree.nodes
    )


CLASSES = (
    NACRE_OT_make_spectral,
    NACRE_OT_make_rgb,
    NACRE_OT_give_light,
    NACRE_OT_show_rgb,
)
