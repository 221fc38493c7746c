# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts sources upon a material's thickness as text has them, such as those by which its picture was made."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from ..core.manifest import CompiledMaterial, ManifestError
from ..materials.thickness import thickness_range, thickness_socket
from .nodes import add_source
from .sources import ThicknessError, Value, Varied, read_varied, socket_values

Put = list[tuple[bpy.types.ShaderNodeGroup, dict[str, Value]]]
"""Nodes of sources, and the values that each was given."""


def put_upon(
    material: bpy.types.Material, compiled: CompiledMaterial, wanted: Sequence[Varied]
) -> Put:
    """Each upon those before it, on a material whose thickness can vary.

    Raises ThicknessError, and changes nothing, where one of them does not fit.
    """
    span = thickness_range(thickness_socket(material))
    values = [socket_values(item, compiled.thickness.name, span) for item in wanted]
    put = []
    for item, given in zip(wanted, values, strict=True):
        node = add_source(material, item.source.id)
        for name, value in given.items():
            node.inputs[name].default_value = value
        put.append((node, given))
    return put


def dress(material: bpy.types.Material, compiled: CompiledMaterial) -> None:
    """Lets it look as its picture does, by the sources of its look, if it has any.

    Raises ManifestError, and changes nothing, where one of them is unknown or does not fit.
    """
    wanted = compiled.look.thickness
    if not wanted:
        return
    if thickness_socket(material) is None:
        raise ManifestError(f"{compiled.id}: look.thickness: the material has no thickness to vary")
    try:
        put_upon(material, compiled, [read_varied(text) for text in wanted])
    except ThicknessError as error:
        raise ManifestError(f"{compiled.id}: look.thickness: {error}") from error
