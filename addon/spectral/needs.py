# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene asks of bands: its lights, its films, and what disperses light in it."""

from __future__ import annotations

import bpy
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

from ..core.wavelengths import Wavelengths
from . import films, forms, groups, plan

_SPREAD = 0.045
"""Of the lines F and C, in parts of the size of what disperses: dense flint, n_F - n_C = 0.03, which shows
what is a bit more than its own size behind it."""


def plan_for(
    scene: bpy.types.Scene,
    triples: int | None = None,
    wavelengths: Wavelengths | None = None,
) -> plan.Plan:
    """Of as many bands as the scene needs where neither their number nor where they are is given. Raises
    ForeseenError."""
    return plan.make(
        groups.found_spectra(),
        triples,
        wavelengths=wavelengths,
        films=films.fringes(),
        spread_px=_spread_px(scene),
    )


def _spread_px(scene: bpy.types.Scene) -> float | None:
    """An estimate, of the largest object that disperses light; None where none does."""
    sizes = [_size_px(scene, item) for item in scene.objects if _disperses(item)]
    return _SPREAD * max(sizes) if sizes else None


def _disperses(item: bpy.types.Object) -> bool:
    trees = [slot.material.node_tree for slot in item.material_slots if slot.material is not None]
    return any(_uses_dispersive(tree, set()) for tree in trees if tree is not None)


def _uses_dispersive(tree: bpy.types.NodeTree, seen: set) -> bool:
    """Also within groups of somebody's own."""
    if tree in seen:
        return False
    seen.add(tree)
    inner = [node.node_tree for node in tree.nodes if node.type == "GROUP" and node.node_tree]
    return any(forms.is_dispersive(group) or _uses_dispersive(group, seen) for group in inner)


def _size_px(scene: bpy.types.Scene, item: bpy.types.Object) -> float:
    """The larger side of what it covers of the picture; all of it where there is no telling."""
    render = scene.render
    size = [
        side * render.resolution_percentage / 100
        for side in (render.resolution_x, render.resolution_y)
    ]
    if scene.camera is None:
        return max(size)
    corners = [item.matrix_world @ Vector(corner) for corner in item.bound_box]
    seen = [world_to_camera_view(scene, scene.camera, corner) for corner in corners]
    if min(place.z for place in seen) <= 0.0:
        return max(size)
    spans = []
    for axis, pixels in enumerate(size):
        places = [min(1.0, max(0.0, place[axis])) * pixels for place in seen]
        spans.append(max(places) - min(places))
    return max(spans)
