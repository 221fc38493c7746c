# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Templates to materials."""

from __future__ import annotations

import ctypes
import json
from ctypes import c_void_p
from typing import Any, NamedTuple

import numpy as np

from ._native import check, lib, number, take_tables, text


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
    tolerance: float = 0.1,
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
    tolerance : float
        Largest CIEDE2000 difference between table and exact colour.

    Raises
    ------
    NacreError
        Every problem of the template, one a line: `file:line: field: message`.
    """
    handle = c_void_p()
    check(
        lib.nacre_compile_template(
            text(template, "template"),
            text(file, "file"),
            text(illuminant, "illuminant"),
            text(observer, "observer"),
            text(space, "space"),
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
