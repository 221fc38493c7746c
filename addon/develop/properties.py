# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a spectral picture is developed to."""

from __future__ import annotations

from zlib import crc32

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    IntVectorProperty,
    PointerProperty,
    StringProperty,
)

from ..blender.parts import Extended
from ..core.computation import library_problem
from . import session
from .session import FILE, KEEP, NONE, PLACE

_shown: dict[str, list] = {}
"""Blender wants lists to live on."""


def _lights(name: str, *first: tuple[str, str, str]) -> list:
    """Each with a number of its own, which stays when files bring more of them."""
    found = [(*item, "NONE", number) for number, item in enumerate(first)]
    if not library_problem():
        from ..spectral import choices

        known = {item[0] for item in first}
        found += [
            (*item, "NONE", crc32(item[0].encode()) >> 1)
            for item in choices.known_lights()
            if item[0] not in known
        ]
    _shown[name] = found
    return found


def _exchanges(_self, _context):
    return _lights("exchange", (KEEP, "As Rendered", "The lamps stay what they are"))


def _whites(_self, _context):
    return _lights(
        "white",
        (NONE, "No Adaptation", "Colours are as lamps make them"),
        (PLACE, "First Place", "What is at the first place that was measured is white"),
    )


def _comparisons(_self, _context):
    return _lights("under", ("A", "A", "of the CIE"))


def _viewers(_self, _context):
    found = [
        (FILE, "As Rendered", "The observer that bands were made for"),
        ("cie1931", "CIE 1931, 2°", "The eye, of what is small"),
        ("cie1964", "CIE 1964, 10°", "The eye, of what is large"),
    ]
    if not library_problem():
        import nacre

        for key in nacre.develop.cameras():
            maker, _, model = key.partition("-")
            name = f"{maker.capitalize()} {model.replace('-', ' ').title()}"
            found.append((key, name, "A camera whose sensitivities were measured"))
    _shown["viewer"] = found
    return found


def _on_change(_self, context) -> None:
    session.renew(context.window_manager.nacre_develop)


def _on_measure(_self, context) -> None:
    session.renew(context.window_manager.nacre_develop, with_picture=False)


class NACRE_PG_developed_lamp(bpy.types.PropertyGroup):
    """What the lamps of a layer become."""

    layer: StringProperty(name="Layer", description="A light group, or all light")
    light: EnumProperty(
        name="Light",
        description="What the lamps are instead, as bright as they were",
        items=_exchanges,
        update=_on_change,
    )
    strength: FloatProperty(
        name="Strength", description="How much of this light there is", default=1.0, min=0.0,
        soft_max=4.0, update=_on_change,
    )  # fmt: skip


class NACRE_PG_measured_place(bpy.types.PropertyGroup):
    """A place of the picture whose spectrum is shown."""

    pixel: IntVectorProperty(name="Pixel", description="From the top left", size=2)


class NACRE_PG_develop(bpy.types.PropertyGroup):
    """Of the picture that is open; in no file."""

    viewer: EnumProperty(
        name="Seen By", description="An eye or a camera", items=_viewers, update=_on_change
    )
    raw: BoolProperty(
        name="Raw",
        description="The camera's own channels, white balanced, in no space",
        update=_on_change,
    )
    white: EnumProperty(
        name="White", description="What is white to who looks", items=_whites, update=_on_change
    )
    exposure: FloatProperty(
        name="Exposure", description="In stops", soft_min=-6.0, soft_max=6.0, update=_on_change
    )
    lamps: CollectionProperty(type=NACRE_PG_developed_lamp)
    places: CollectionProperty(type=NACRE_PG_measured_place)
    side: IntProperty(
        name="Size",
        description="Of a place, in pixels: the mean of a square",
        default=5,
        min=1,
        max=512,
        update=_on_measure,
    )
    under: EnumProperty(
        name="Under",
        description="The light that two places are compared under",
        items=_comparisons,
        update=_on_measure,
    )

    def begin(self, opened) -> None:
        """As they come, for a picture."""
        for name in ("viewer", "raw", "white", "exposure"):
            self.property_unset(name)
        self.places.clear()
        self.lamps.clear()
        for layer in opened.image.layers:
            self.lamps.add().layer = layer


def forget() -> None:
    _shown.clear()
    session.forget()


CLASSES = (NACRE_PG_developed_lamp, NACRE_PG_measured_place, NACRE_PG_develop)
PARTS = (Extended(bpy.types.WindowManager, nacre_develop=PointerProperty(type=NACRE_PG_develop)),)
