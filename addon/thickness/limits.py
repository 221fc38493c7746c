# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Between which thicknesses the inputs of sources make sense."""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from ..materials.limits import Limit, of_interface
from ..materials.thickness import thickness_range, thickness_socket
from .nodes import sources_of, spec_of


def of_sources(material: bpy.types.Material) -> Iterator[Limit]:
    socket = thickness_socket(material)
    if socket is None:
        return
    span = thickness_range(socket)
    for source in sources_of(material):
        yield from of_interface(source)
        for item in spec_of(source).inputs:
            if item.is_thickness and item.name in source.inputs:
                yield source.inputs[item.name], *((0.0, span[1]) if item.added else span)
