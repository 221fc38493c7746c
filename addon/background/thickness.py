# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `render` lets a material's thickness follow: --look, --vary, --thickness-map."""

from __future__ import annotations

import argparse

import bpy

from ..core.manifest import CompiledMaterial
from ..thickness import dress as looks
from ..thickness import nodes as thickness
from ..thickness.sources import SOCKETS, ThicknessError, socket_values
from .options import UsageError


def dress(
    material: bpy.types.Material, compiled: CompiledMaterial, options: argparse.Namespace
) -> None:
    """As the library pictures it; frames run what has a time."""
    looks.dress(material, compiled)
    if not options.frames:
        return
    timed = thickness.timed_sources(material)
    if not timed and not options.animate:
        raise UsageError(f"--frames: nothing in the look of {compiled.id} moves")
    for node in timed:
        thickness.animate(node)


def vary(
    material: bpy.types.Material, compiled: CompiledMaterial, options: argparse.Namespace
) -> None:
    socket = thickness.thickness_socket(material)
    if socket is None:
        raise UsageError(f"{compiled.id} has no thickness that could vary")
    if options.thickness_map:
        _map_thickness(material, options)
    fed = next(filter(None, map(compiled.socket, SOCKETS)))
    for varied in options.vary:
        try:
            values = socket_values(varied, fed.name, thickness.thickness_range(socket))
        except ThicknessError as error:
            raise UsageError(
                "\n".join(f"--vary: {line}" for line in str(error).splitlines())
            ) from error
        node = thickness.add_source(material, varied.source.id)
        for name, value in values.items():
            node.inputs[name].default_value = value
        if varied.source.id == "swirl" and options.frames:
            if "Time" in values:
                raise UsageError("--vary: swirl: time_s does not go with --frames, which run it")
            thickness.animate(node)


def _map_thickness(material: bpy.types.Material, options: argparse.Namespace) -> None:
    low, high = thickness.thickness_range(thickness.thickness_socket(material))
    wanted = options.range or (low, high)
    if not (low <= wanted[0] and wanted[1] <= high):
        raise UsageError(
            f"--range: must be within {low:g}:{high:g}, which the tables cover "
            f"(got {wanted[0]:g}:{wanted[1]:g})"
        )
    try:
        image = bpy.data.images.load(str(options.thickness_map.absolute()))
    except RuntimeError as error:
        raise UsageError(f"--thickness-map: {options.thickness_map}: {error}") from error
    if tuple(image.size) == (0, 0):
        raise UsageError(f"--thickness-map: {options.thickness_map}: is not a picture")
    node = thickness.add_source(material, "map")
    node.inputs["Minimum"].default_value, node.inputs["Maximum"].default_value = wanted
    thickness.link_image(material, node, image)
