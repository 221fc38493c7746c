# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets a material look as its picture does."""

from __future__ import annotations

import bpy

from ..core.manifest import CompiledMaterial, ManifestError
from .nodes import add_source, thickness_range, thickness_socket
from .sources import SOCKETS, ThicknessError, read_varied, socket_values


def dress(material: bpy.types.Material, compiled: CompiledMaterial) -> None:
    """Puts the sources of its look upon the thickness, if it has any.

    Raises ManifestError, and changes nothing, where one of them is unknown or does not fit.
    """
    wanted = compiled.look.thickness
    if not wanted:
        return
    socket = thickness_socket(material)
    if socket is None:
        raise ManifestError(f"{compiled.id}: look.thickness: the material has no thickness to vary")
    fed = next(filter(None, map(compiled.socket, SOCKETS)))
    span = thickness_range(socket)
    try:
        varied = [read_varied(text) for text in wanted]
        values = [socket_values(item, fed.name, span) for item in varied]
    except ThicknessError as error:
        raise ManifestError(f"{compiled.id}: look.thickness: {error}") from error
    for item, given in zip(varied, values, strict=True):
        node = add_source(material, item.source.id)
        for name, value in given.items():
            node.inputs[name].default_value = value
