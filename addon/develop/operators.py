# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open spectral pictures, measure places of them."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import IntProperty, StringProperty

from ..blender.windows import begin_pick, end_pick, within
from ..core import spectral_image
from ..core.whole_file import write_whole
from ..materials.guard import reports_errors
from ..spectral.operators import NeedsLibrary
from . import session


def file_of(image: bpy.types.Image | None) -> Path | None:
    """Which has the spectra of a picture that an editor shows, as far as can be told without opening it."""
    if image is None:
        return None
    path = image.get(spectral_image.FILE) or bpy.path.abspath(image.filepath)
    return Path(path) if str(path).lower().endswith(".exr") else None


class _NeedsPicture(bpy.types.Operator):
    @classmethod
    def poll(cls, _context):
        if session.shown() is None:
            cls.poll_message_set("Develop a spectral picture first")
            return False
        return True


class NACRE_OT_develop(NeedsLibrary):
    bl_idname = "nacre.develop"
    bl_label = "Nacre: Develop a Spectral Picture"
    bl_description = (
        "Open what Render Spectral wrote, or another program's spectral EXR: see it under other lamps, by other "
        "eyes and cameras, and measure spectra in it"
    )
    bl_options = {"REGISTER"}

    filepath: StringProperty(name="File", description="A spectral .exr", subtype="FILE_PATH")
    filter_glob: StringProperty(default="*.exr", options={"HIDDEN"})

    def invoke(self, context, _event):
        if self.properties.is_property_set("filepath"):
            return self.execute(context)
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        path = Path(bpy.path.abspath(self.filepath)).absolute()
        image = session.open_file(path, context.window_manager.nacre_develop)
        shown_in = context.space_data
        if shown_in is not None and shown_in.type == "IMAGE_EDITOR":
            shown_in.image = image
        bands = session.shown().picture.bands
        self.report({"INFO"}, f"{path.name}: {len(bands)} bands; the picture is {image.name}.")
        return {"FINISHED"}


class NACRE_OT_measure_spectrum(_NeedsPicture):
    bl_idname = "nacre.measure_spectrum"
    bl_label = "Nacre: Measure a Spectrum"
    bl_description = (
        "Click places of the developed picture to see their spectra. Esc ends, or the right button"
    )

    x: IntProperty(name="X", description="Pixels from the left", min=0)
    y: IntProperty(name="Y", description="Pixels from the top", min=0)

    def invoke(self, context, _event):
        if self.properties.is_property_set("x") or context.window is None:
            return self.execute(context)
        return begin_pick(self, context, "Click places to measure their spectra, Esc to end")

    def modal(self, context, event):
        if event.type in {"ESC", "RIGHTMOUSE"}:
            end_pick(context)
            return {"FINISHED"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            return {"PASS_THROUGH"}
        found = _pixel_under(context.window, (event.mouse_x, event.mouse_y))
        if found is None:
            return {"PASS_THROUGH"}  # a button of the panel, perhaps
        self.x, self.y = found
        self.execute(context)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        settings, picture = context.window_manager.nacre_develop, session.shown().picture
        width, height = picture.image.size
        if self.x >= width or self.y >= height:
            self.report({"ERROR"}, f"{self.x}, {self.y} is not within {width} x {height} pixels")
            return {"CANCELLED"}
        settings.places.add().pixel = (self.x, self.y)
        session.renew_places(settings)
        return {"FINISHED"}


def _pixel_under(window: bpy.types.Window, mouse: tuple[int, int]) -> tuple[int, int] | None:
    """Of the open picture, from its top left, where an image editor shows it there."""
    width, height = session.shown().picture.image.size
    for area in window.screen.areas:
        image = area.spaces.active.image if area.type == "IMAGE_EDITOR" else None
        if image is None or tuple(image.size) != (width, height):
            continue
        there = [region for region in area.regions if within(region, mouse)]
        if [region.type for region in there] != ["WINDOW"]:
            continue  # elsewhere, or on a panel that lies over the picture
        u, v = there[0].view2d.region_to_view(*within(there[0], mouse))
        if 0.0 <= u < 1.0 and 0.0 <= v < 1.0:
            return int(u * width), height - 1 - int(v * height)
    return None


class NACRE_OT_forget_spectrum(_NeedsPicture):
    bl_idname = "nacre.forget_spectrum"
    bl_label = "Nacre: Forget a Place"
    bl_description = "Measure this place no longer"

    index: IntProperty(name="Place", description="From 0; -1: all of them", default=-1, min=-1)

    def execute(self, context):
        settings = context.window_manager.nacre_develop
        if self.index < 0:
            settings.places.clear()
        elif self.index < len(settings.places):
            settings.places.remove(self.index)
        session.renew_places(settings)
        return {"FINISHED"}


class NACRE_OT_save_spectra(_NeedsPicture):
    bl_idname = "nacre.save_spectra"
    bl_label = "Nacre: Save Spectra"
    bl_description = "Write the spectra of all places that were measured as CSV"

    filepath: StringProperty(
        name="File", description="A table, .csv", subtype="FILE_PATH", default="//spectra.csv"
    )
    filter_glob: StringProperty(default="*.csv", options={"HIDDEN"})

    @classmethod
    def poll(cls, _context):
        if session.shown() is None or not session.shown().places:
            cls.poll_message_set("Measure a spectrum first")
            return False
        return True

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, _context):
        from .places import spectra_csv

        shown = session.shown()
        path = Path(bpy.path.abspath(self.filepath)).absolute().with_suffix(".csv")
        write_whole(path, spectra_csv(shown.picture.bands.wavelength_nm, shown.places))
        self.report({"INFO"}, f"{path} written: {len(shown.places)} spectra")
        return {"FINISHED"}


CLASSES = (
    NACRE_OT_develop,
    NACRE_OT_measure_spectrum,
    NACRE_OT_forget_spectrum,
    NACRE_OT_save_spectra,
)
