# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `render` lets a material's thickness follow: --look, --vary, --thickness-map."""

from __future__ import annotations

import argparse

import bpy

from ..core.manifest import CompiledMaterial
from ..materials.thickness import thickness_range, thickness_socket
from ..thickness import nodes
from ..thickness.dress import dress as put_look_upon
from ..thickness.dress import put_upon
from ..thickness.sources import ThicknessError
from .options import UsageError


def dress(
    material: bpy.types.Material, compiled: CompiledMaterial, options: argparse.Namespace
) -> None:
    """As the library pictures it; frames run what has a time."""
    put_look_upon(material, compiled)
    if not options.frames:
        return
    timed = nodes.timed_sources(material)
    if not timed and not options.animate:
        raise UsageError(f"--frames: nothing in the look of {compiled.id} moves")
    for node in timed:
        nodes.animate(node)


def vary(
    material: bpy.types.Material, compiled: CompiledMaterial, options: argparse.Namespace
) -> None:
    if thickness_socket(material) is None:
        raise UsageError(f"{compiled.id} has no thickness that could vary")
    if options.thickness_map:
        _map_thickness(material, options)
    try:
        put = put_upon(material, compiled, options.vary)
    except ThicknessError as error:
        lines = str(error).splitlines()
        raise UsageError("\n".join(f"--vary: {line}" for line in lines)) from error
    for varied, (node, given) in zip(options.vary, put, strict=True):
        if varied.source.id == "swirl" and options.frames:
            if "Time" in given:
                raise UsageError("--vary: swirl: time_s does not go with --frames, which run it")
            nodes.animate(node)


def _map_thickness(material: bpy.types.Material, options: argparse.Namespace) -> None:
    low, high = thickness_range(thickness_socket(material))
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
    node = nodes.add_source(material, "map")
    node.inputs["Minimum"].default_value, node.inputs["Maximum"].default_value = wanted
    nodes.link_image(material, node, image)
