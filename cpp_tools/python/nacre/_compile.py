# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Templates to materials."""

from __future__ import annotations

import ctypes
import json
from collections.abc import Mapping
from ctypes import c_void_p
from typing import Any, NamedTuple

import numpy as np

from ._capi import WAVELENGTHS
from ._film_bands import table_sizes
from ._native import check, lib, number, take_tables
from ._native import text as encoded


class CompiledMaterial(NamedTuple):
    """osl: shader text; manifest: form in cpp_tools/doc/manifest.md; tables: by name, float32
    (height, width, 3), row 0 at the minimum of the second axis."""

    id: str
    osl: str
    manifest: dict[str, Any]
    tables: dict[str, np.ndarray]


def compile_template(
    template: str,
    file: str = "template.toml",
    *,
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
    adaptation: str = "bradford",
    tolerance: float = 0.1,
    strict_range: bool = False,
) -> CompiledMaterial:
    """Compiles the text of a template (TOML) to shader, manifest and tables.

    Parameters
    ----------
    template : str
        Text of the template.
    file : str
        What messages call it.
    illuminant, observer, space : str
        Of the tables: a light by name (`nacre.illuminant`), "cie1931" or "cie1964", and
        "lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene" or "xyz_d65".
    adaptation : "bradford", "cat16" or "none"
        Of the light's white to the space's. None: films alone, and their tables have the colour of
        the light in them.
    tolerance : float
        Largest CIEDE2000 difference between table and exact colour.
    strict_range : bool
        Whether media whose data end within 360-830 nm are refused; else data of 400-700 nm do, n and
        k are held at their ends, and the manifest's `held_ends` says so.

    Raises
    ------
    NacreError
        Every problem of the template, one a line: `file:line: field: message`.
    """
    handle = c_void_p()
    check(
        lib.nacre_compile_template(
            *_texts(template, file, illuminant, observer, space, adaptation, strict_range),
            number(tolerance, "tolerance"),
            ctypes.byref(handle),
        )
    )
    try:
        name, osl, manifest = (
            lib.nacre_result_text(handle, part).decode() for part in (b"id", b"osl", b"manifest")
        )
        tables = {info.name.decode(): texels for info, texels in take_tables(handle)}
    finally:
        lib.nacre_result_free(handle)
    return CompiledMaterial(name, osl, json.loads(manifest), tables)


def preview_tables(
    template: str,
    sizes: Mapping[str, tuple[int, int]],
    file: str = "template.toml",
    *,
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
    adaptation: str = "bradford",
    strict_range: bool = False,
) -> dict[str, np.ndarray]:
    """New texels for a compiled film whose stack is being edited: quick, errors not stated.

    The shader and the graphs that read the old tables go on reading the new ones.

    Parameters
    ----------
    template : str
        Text of the edited template.
    sizes : mapping
        (height, width) by name of a table, as the compiled material has them. `R_further`,
        `R_schlick` and `lobe_…` are left out of the result.
    file, illuminant, observer, space, adaptation, strict_range
        As of `compile_template`.

    Returns
    -------
    dict
        float32 (height, width, 3) by name.

    Raises
    ------
    NacreError
        Problems of the template, one a line; a table that such a film does not have.
    """
    handle = c_void_p()
    check(
        lib.nacre_preview_template(
            *_texts(template, file, illuminant, observer, space, adaptation, strict_range),
            len(sizes),
            table_sizes(sizes),
            ctypes.byref(handle),
        )
    )
    try:
        return {info.name.decode(): texels for info, texels in take_tables(handle)}
    finally:
        lib.nacre_result_free(handle)


class TemplateSpectrum(NamedTuple):
    """reflectance, transmittance: float64 (471,) over 360 ... 830 nm; colours: float64 (2, 3), of
    both in the space, not clipped."""

    reflectance: np.ndarray
    transmittance: np.ndarray
    colours: np.ndarray


def template_spectrum(
    template: str,
    value: float = 1.0,
    angle_deg: float = 0.0,
    file: str = "template.toml",
    *,
    illuminant: str = "D65",
    observer: str = "cie1931",
    space: str = "lin_rec709_scene",
    adaptation: str = "bradford",
    strict_range: bool = False,
) -> TemplateSpectrum:
    """What the film of a template reflects and lets pass, unpolarised, by its
    technique: the exact multilayer unless it asks for another.

    Parameters
    ----------
    template : str
        Text of the template.
    value : float
        Of what varies: a thickness in nm, or the factor on all layers; not held to its range. Where
        nothing varies it is not looked at.
    angle_deg : float
        In the ambient, in [0, 90).
    file, illuminant, observer, space, adaptation, strict_range
        As of `compile_template`.

    Raises
    ------
    NacreError
        Problems of the template, one a line, or a value out of its range.
    """
    spectra, colours = np.empty((2, WAVELENGTHS)), np.empty((2, 3))
    check(
        lib.nacre_template_spectrum(
            *_texts(template, file, illuminant, observer, space, adaptation, strict_range),
            number(value, "value"),
            number(angle_deg, "angle_deg"),
            spectra[0].ctypes.data,
            spectra[1].ctypes.data,
            colours.ctypes.data,
        )
    )
    return TemplateSpectrum(spectra[0], spectra[1], colours)


def _texts(
    template: str,
    file: str,
    illuminant: str,
    observer: str,
    space: str,
    adaptation: str,
    strict_range: bool,
) -> list[bytes]:
    """As C takes them; with `strict_range` of a template whose media need not be held."""
    texts = [
        encoded(template, "template"),
        encoded(file, "file"),
        encoded(illuminant, "illuminant"),
        encoded(observer, "observer"),
    ]
    if strict_range:
        check(lib.nacre_template_held_ends(*texts, 1, ctypes.byref(ctypes.c_char_p())))
    return [*texts, encoded(space, "space"), encoded(adaptation, "adaptation")]
