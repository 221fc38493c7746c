# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Optics of films, gratings and spectra as colours: numpy over the C interface of Nacre.

Conventions (normative page: cpp_tools/doc/conventions.md): indices are n + ik with k >= 0, stacks
are listed from the ambient down, angles are measured in the ambient, wavelengths are in vacuum.
"""

from __future__ import annotations

from . import develop, library, shapes, textures
from ._bands import (
    BandChoice,
    BandError,
    Bands,
    LightSamples,
    Lines,
    bands,
    choose_bands,
)
from ._colour import (
    Colour,
    ColourTemperature,
    RgbSpectrum,
    colour_matching,
    colour_temperature,
    illuminant,
    map_range,
    rgb_basis,
    rgb_to_spectrum,
    spectrum_to_colour,
)
from ._compile import (
    CompiledMaterial,
    TemplateSpectrum,
    compile_template,
    preview_tables,
    template_spectrum,
)
from ._film import FilmLut, Table, film_lut
from ._film_bands import band_tables, film_fringes, optical_thickness
from ._grating import GratingOrders, grating_orders
from ._models import film_reflectance, slit_intensity
from ._native import NacreError, version
from ._stack import StackResult, stack
from ._stack_colour import StackColour, stack_colour

__version__ = version()
__all__ = [
    "BandChoice",
    "BandError",
    "Bands",
    "Colour",
    "ColourTemperature",
    "CompiledMaterial",
    "FilmLut",
    "GratingOrders",
    "LightSamples",
    "Lines",
    "NacreError",
    "RgbSpectrum",
    "StackColour",
    "StackResult",
    "Table",
    "TemplateSpectrum",
    "band_tables",
    "bands",
    "choose_bands",
    "colour_matching",
    "colour_temperature",
    "compile_template",
    "develop",
    "film_fringes",
    "film_lut",
    "film_reflectance",
    "grating_orders",
    "illuminant",
    "library",
    "map_range",
    "optical_thickness",
    "preview_tables",
    "rgb_basis",
    "rgb_to_spectrum",
    "shapes",
    "slit_intensity",
    "spectrum_to_colour",
    "stack",
    "stack_colour",
    "template_spectrum",
    "textures",
]
