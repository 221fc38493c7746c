# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a lamp, the world or a surface is: chosen from lists, or read from a file."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, StringProperty

from ..blender.space import of_file
from ..core.space import Matrix
from ..materials.guard import must_be_local, reports_errors
from . import outlook
from .described import EMISSION, FILES, REFLECTANCE, Described, SpectrumError, read
from .marks import WORLD
from .operators import NeedsLibrary

ITS_COLOUR = "its colour"
"""In lists: a spectrum of the colour that is set."""

_OWN = (ITS_COLOUR, "Its Colour", "A spectrum of the colour that is set")
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
_KELVIN = (1850, 2700, 3000, 3500, 4100, 5000)
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

Item = tuple[str, str, str]
_of_files: dict[str, list[Item]] = {EMISSION: [], REFLECTANCE: []}
"""What files were read since Blender was started."""
_shown: dict[str, list[Item]] = {}
"""Blender wants lists to live on."""


def forget() -> None:
    for of_kind in _of_files.values():
        of_kind.clear()
    for cached in (_shipped_lights, _known_metals, _of_library, _lab_of):
        cached.cache_clear()


def _lights(_self, _context) -> list[Item]:
    _shown[EMISSION] = [_OWN, *known_lights()]
    return _shown[EMISSION]


def known_lights() -> list[Item]:
    """Those of files first; `Described.named` knows each by its identifier."""
    return [*_of_files[EMISSION], *_shipped_lights()]


@cache
def _shipped_lights() -> tuple[Item, ...]:
    return (
        *((name, name, "of the CIE") for name in _CIE),
        *_of_library(EMISSION),
        *((f"blackbody:{k}", f"Black body, {k} K", "Planck's law") for k in _KELVIN),
        *_LINES,
    )


@cache
def _of_library(kind: str) -> tuple[Item, ...]:
    import nacre

    spectra = [nacre.library.spectrum(key) for key in nacre.library.keys("spectra")]
    return tuple(
        (found.key, found.name, found.key)
        for found in spectra
        if found.kind == kind and not found.key.startswith("cie/")
    )


def _reflectances(self, _context) -> list[Item]:
    """Those of the library by how near they are to the colour that is set."""
    colour = _colour(self)
    known = _of_library(REFLECTANCE)
    if colour is not None:
        wanted = _lab(colour.rgb)
        space = of_file()
        colours = {item[0]: _lab_of(item[0], space) for item in known}
        distance = {key: float(np.linalg.norm(lab - wanted)) for key, lab in colours.items()}
        known = [
            (key, f"{name}  ΔE {distance[key]:.0f}", words)
            for key, name, words in sorted(known, key=lambda item: distance[item[0]])
        ]
    _shown[REFLECTANCE] = [_OWN, *_of_files[REFLECTANCE], *known]
    return _shown[REFLECTANCE]


@cache
def _lab_of(key: str, _space: Matrix) -> np.ndarray:
    """In the file's space; Blender asks for a list again and again while it is open."""
    from .groups import rgb_of

    return _lab(rgb_of(Described.named(key)))


def _lab(rgb: Sequence[float]) -> np.ndarray:
    """CIELAB of a colour of the file, whose white is its own."""
    to_xyz = np.array(of_file())
    relative = np.maximum(to_xyz @ np.array(rgb[:3]) / to_xyz.sum(axis=1), 0.0)
    dark = relative <= (6.0 / 29.0) ** 3
    f = np.where(dark, relative * (29.0 / 6.0) ** 2 / 3.0 + 4.0 / 29.0, np.cbrt(relative))
    return np.array([116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])])


class _Choice(NeedsLibrary):
    def invoke(self, context, _event):
        context.window_manager.invoke_search_popup(self)
        return {"FINISHED"}


class NACRE_OT_give_light(_Choice):
    bl_idname = "nacre.give_light"
    bl_label = "Nacre: Light of a Lamp"
    bl_description = (
        "Choose what a lamp or the world is: daylight, tungsten, a fluorescent tube, sodium …"
    )
    bl_property = "light"

    lamp: StringProperty(name="Lamp", description="An object of the scene, or World", default="")
    light: EnumProperty(name="Light", description="What it is; as bright as it was", items=_lights)

    @reports_errors
    def execute(self, context):
        return _give_light(self, context, None if self.light == ITS_COLOUR else self.light)


def _give_light(operator, context, light: str | None) -> set[str]:
    from . import give

    spectrum = None if light is None else Described.named(light, EMISSION)
    name = operator.lamp or (context.object.name if context.object else WORLD)
    found = context.scene.objects.get(name)
    if found is not None and found.type == "LIGHT":
        if not found.data.is_editable:
            operator.report({"ERROR"}, must_be_local(name, found.data.library))
            return {"CANCELLED"}
        give.to_lamp(found.data, spectrum)
    elif name == WORLD and context.scene.world is not None:
        give.to_world(context.scene.world, spectrum)
    else:
        operator.report({"ERROR"}, f"{name} is no lamp of the scene")
        return {"CANCELLED"}
    outlook.look(context.scene)
    _say(operator, name, spectrum)
    return {"FINISHED"}


def _say(operator, name: str, spectrum: Described | None) -> None:
    what = "of its colour again" if spectrum is None else f"{spectrum.name} now"
    bright = ", as bright as before" if spectrum is not None and spectrum.kind == EMISSION else ""
    operator.report({"INFO"}, f"{name} is {what}{bright}.")


class NACRE_OT_give_reflectance(_Choice):
    bl_idname = "nacre.give_reflectance"
    bl_label = "Nacre: Reflectance of a Surface"
    bl_description = (
        "Choose what a colour of a material is in bands: a measured reflectance, those that look most like it "
        "under daylight first"
    )
    bl_property = "reflectance"

    material: StringProperty(name="Material", description="Empty: that of the active object")
    colour: StringProperty(
        name="Colour", description="Node and socket, as the panel has them; empty: the first"
    )
    reflectance: EnumProperty(name="Reflectance", description="What it is", items=_reflectances)

    @reports_errors
    def execute(self, context):
        wanted = None if self.reflectance == ITS_COLOUR else self.reflectance
        return _give_reflectance(self, context, wanted)


def _material(operator, context) -> bpy.types.Material | None:
    if operator.material:
        return bpy.data.materials.get(operator.material)
    return context.object.active_material if context.object else None


def _colour(operator):
    from . import give

    material = _material(operator, bpy.context)
    colours = give.colours_of(material) if material is not None else []
    if not operator.colour:
        return colours[0] if colours else None
    return next((colour for colour in colours if colour.label == operator.colour), None)


def _changeable(operator, context) -> bpy.types.Material | None:
    """What is meant, or None and a report."""
    material = _material(operator, context)
    if material is None:
        operator.report({"ERROR"}, f"There is no material {operator.material}".rstrip())
    elif not material.is_editable:
        operator.report({"ERROR"}, must_be_local(material.name, material.library))
        return None
    return material


def _give_reflectance(operator, context, reflectance: str | None) -> set[str]:
    material = _changeable(operator, context)
    if material is None:
        return {"CANCELLED"}
    colour = _colour(operator)
    if colour is None:
        what = f"colour {operator.colour}" if operator.colour else "colour that takes a reflectance"
        operator.report({"ERROR"}, f"The material {material.name} has no {what}")
        return {"CANCELLED"}
    spectrum = None if reflectance is None else Described.named(reflectance, REFLECTANCE)
    colour.give(spectrum)
    outlook.look(context.scene)
    _say(operator, f"{material.name}, {colour.label},", spectrum)
    return {"FINISHED"}


def _metals(_self, _context) -> list[Item]:
    _shown["metals"] = [
        (ITS_COLOUR, "As Set", "n and k by channel, as they are set"),
        *_known_metals(),
    ]
    return _shown["metals"]


@cache
def _known_metals() -> tuple[Item, ...]:
    import nacre

    found = []
    for key in nacre.library.keys("media"):
        try:
            Described.of_metal(key)
        except SpectrumError:
            continue
        found.append((key, nacre.library.medium(key).name, key))
    return tuple(found)


class NACRE_OT_give_metal(_Choice):
    bl_idname = "nacre.give_metal"
    bl_label = "Nacre: Metal of a Surface"
    bl_description = (
        "Choose the metal of a Metallic BSDF, as a Physical Conductor: n and k at each wavelength"
    )
    bl_property = "metal"

    material: StringProperty(name="Material", description="Empty: that of the active object")
    colour: StringProperty(name="Node", description="As the panel has it; empty: the first")
    metal: EnumProperty(name="Metal", description="What it is", items=_metals)

    @reports_errors
    def execute(self, context):
        from . import give

        material = _changeable(self, context)
        if material is None:
            return {"CANCELLED"}
        found = [each for each in give.metals_of(material) if self.colour in ("", each.label)]
        if not found:
            self.report(
                {"ERROR"},
                f"The material {material.name} has no Metallic BSDF whose Fresnel is Physical Conductor",
            )
            return {"CANCELLED"}
        key = None if self.metal == ITS_COLOUR else self.metal
        found[0].give(key)
        outlook.look(context.scene)
        what = "as it is set" if key is None else f"{key} now"
        self.report({"INFO"}, f"{material.name}, {found[0].label}, is {what}.")
        return {"FINISHED"}


class NACRE_OT_read_spectra(NeedsLibrary):
    bl_idname = "nacre.read_spectra"
    bl_label = "Nacre: Spectra of a File"
    bl_description = (
        "Read measured spectra: CSV, SPD, IES TM-27 (.spdx), CGATS. A single one is given at once; of several, "
        "all stand first in the list"
    )

    filepath: StringProperty(name="File", description="A file of spectra", subtype="FILE_PATH")
    filter_glob: StringProperty(
        default=";".join(f"*{ending}" for ending in FILES), options={"HIDDEN"}
    )
    lamp: StringProperty(name="Lamp", description="What to give a light; an object, or World")
    material: StringProperty(name="Material", description="What to give a reflectance")
    colour: StringProperty(name="Colour", description="Node and socket; empty: the first")
    is_light: BoolProperty(
        name="Lights",
        description="Values are light, where the file does not say and nothing is given",
        default=False,
    )

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @reports_errors
    def execute(self, context):
        kind = EMISSION if self.lamp or self.is_light else REFLECTANCE if self.material else ""
        path = Path(bpy.path.abspath(self.filepath))
        spectra = read(str(path), kind)
        for spectrum in spectra:
            if spectrum.kind not in _of_files:
                raise SpectrumError(
                    f"{path.name}: {spectrum.name}: does not say whether it is an emission or a reflectance: "
                    "read it from a lamp's or a surface's row"
                )
        for spectrum in spectra:
            item = (f"{path}#{spectrum.name}", spectrum.name, path.name)
            if item not in _of_files[spectrum.kind]:
                _of_files[spectrum.kind].append(item)
        if len(spectra) == 1 and self.lamp:
            return _give_light(self, context, f"{path}#{spectra[0].name}")
        if len(spectra) == 1 and self.material:
            return _give_reflectance(self, context, f"{path}#{spectra[0].name}")
        self.report({"INFO"}, f"{len(spectra)} spectra of {path.name} stand first in the lists.")
        return {"FINISHED"}


CLASSES = (
    NACRE_OT_give_light,
    NACRE_OT_give_reflectance,
    NACRE_OT_give_metal,
    NACRE_OT_read_spectra,
)
