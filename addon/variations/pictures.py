# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ball by which a material is known in lists, of the material as it is or of a variation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import bpy

from ..films import edited
from ..materials import group as groups
from ..materials import recipe as recipes
from ..materials.image import SIZE, TABLE
from ..materials.material import group_node, input_socket
from ..materials.thickness import thickness_range, thickness_socket
from ..materials.traits import traits
from ..thickness.nodes import below, sources_of, spec_of
from ..thickness.sources import source

_ROWS, _COLUMNS = 96, 48
_TABLES = ("R", "R_bare", "T")

Values = tuple[tuple[str, float | tuple[float, ...]], ...]


@dataclass(frozen=True)
class Subject:
    """All that a picture depends on."""

    library: str
    recipe: recipes.Recipe
    tables: tuple[tuple[str, int], ...]  # names and rows
    sources: tuple[tuple[str, Values], ...]  # the lowest first
    lowest: float
    span: tuple[float, float]
    finish: Values


def subject(
    material: bpy.types.Material, state: Mapping[str, float] | None = None
) -> Subject | None:
    """None of what has no layers, or cannot be computed."""
    found = edited.known(material) if traits(material).editable_stack else None
    if found is None:
        return None
    library, wanted = found
    given = state or {}
    sources = sources_of(material)[::-1]
    socket = thickness_socket(material)
    span = thickness_range(socket) if socket is not None else (0.0, 1.0)
    return Subject(
        library,
        wanted,
        _tables(material),
        tuple((spec_of(node).id, _values(node, given)) for node in sources),
        _lowest(material, sources, given, span),
        span,
        _finish(material, given),
    )


def draw(shown: Subject, size: int):
    """float32 (size, size, 4), display-referred, bottom row first. Raises ValueError where the layers
    cannot be computed."""
    from . import ball, ball_fields

    tables = _computed(shown.library, shown.recipe, shown.tables)
    normal, _ = ball.sphere(size)
    layers = [(source(name), dict(values)) for name, values in shown.sources]
    thickness = ball_fields.thickness(layers, shown.lowest, normal)
    low, high = shown.span
    return ball.draw(
        tables, (thickness - low) / (high - low), ball.Finish(**dict(shown.finish)), size
    )


@lru_cache(maxsize=16)
def _computed(_library: str, wanted: recipes.Recipe, tables: tuple[tuple[str, int], ...]):
    import numpy as np

    import nacre

    from . import ball

    sizes = {name: (rows, _COLUMNS) for name, rows in tables}
    made = nacre.preview_tables(wanted.template, sizes, **wanted.conditions._asdict())
    found = [made.get(name) for name in _TABLES]
    return ball.Tables(*(None if t is None else np.asarray(t, dtype=np.float32) for t in found))


def _tables(material: bpy.types.Material) -> tuple[tuple[str, int], ...]:
    nodes = group_node(material).node_tree.nodes
    images = {node.image for node in nodes if node.type == "TEX_IMAGE"} - {None}
    rows = {image.get(TABLE): _ROWS if image.get(SIZE, (1, 2))[1] > 1 else 1 for image in images}
    return tuple((name, rows[name]) for name in _TABLES if name in rows) or (("R", _ROWS),)


def _values(node: bpy.types.ShaderNodeGroup, given: Mapping[str, float]) -> Values:
    values = {socket.name: _plain(socket) for socket in node.inputs}
    return tuple((name, given.get(f"{node.name}/{name}", v)) for name, v in values.items())


def _lowest(material, sources, given: Mapping[str, float], span: tuple[float, float]) -> float:
    """What other nodes feed is not known: the middle."""
    if sources:
        socket = below(sources[0])
        name = f"{sources[0].name}/{socket.name}" if socket is not None else ""
    else:
        socket = thickness_socket(material)
        found = groups.socket_identifiers(group_node(material).node_tree).items()
        name = next((n for n, i in found if socket is not None and i == socket.identifier), "")
    if socket is None or socket.is_linked:
        return (span[0] + span[1]) / 2.0
    return given.get(name, socket.default_value)


def _finish(material: bpy.types.Material, given: Mapping[str, float]) -> Values:
    found = {}
    for name in ("roughness", "anisotropy", "coverage"):
        socket = input_socket(material, name)
        if socket is not None:
            found[name] = given.get(name, socket.default_value)
    base = input_socket(material, "base_colour")
    if base is not None:
        found["base"] = _plain(base)[:3]
    return tuple(found.items())


def _plain(socket: bpy.types.NodeSocket):
    value = getattr(socket, "default_value", 0.0)
    return value if isinstance(value, (bool, int, float)) else tuple(value)
