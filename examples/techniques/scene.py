# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The same free film by every technique: two rows of balls."""

from __future__ import annotations

import sys

import bpy
from staging import backdrop, camera, lamp, new_scene, save, thickness_field, wave_material

TECHNIQUES = (
    *("multilayer", "path_difference", "airy", "series"),
    *("opaque_base", "free_film", "etalon", "recursion"),
)
COLUMNS = 4
RANGE_NM = (20.0, 600.0)


def by_technique(obj: bpy.types.Object, technique: str) -> bpy.types.Node:
    """A clear lamella with air on both sides, its stack edited as in the panel."""
    wave_material(obj, "oil_on_water")
    material = obj.active_material
    with bpy.context.temp_override(object=obj, active_object=obj, selected_objects=[obj]):
        bpy.ops.nacre.edit_stack()
        shown = material.nacre
        shown.substrate = shown.ambient
        shown.layers[0].medium = "2.0"
        shown.low_nm, shown.high_nm = RANGE_NM
        shown.technique = technique
        bpy.ops.nacre.finish_stack()
    return next(node for node in material.node_tree.nodes if node.type == "GROUP")


def main() -> None:
    new_scene("interior", strength=0.7, turn_deg=150.0)
    backdrop((0.06, 0.06, 0.065), roughness=0.5)
    for number, technique in enumerate(TECHNIQUES):
        x = 2.3 * (number % COLUMNS - (COLUMNS - 1) / 2)
        z = 3.5 if number < COLUMNS else 1.1
        bpy.ops.mesh.primitive_uv_sphere_add(
            radius=1.0, segments=96, ring_count=64, location=(x, 0.0, z)
        )
        bpy.ops.object.shade_smooth()
        ball = bpy.context.object
        node = by_technique(ball, technique)
        low, high = RANGE_NM
        thickness_field(ball, node, low_nm=low, high_nm=high, axis="Z", swirl=0.0, swirl_scale=1.0)
    lamp((-4.0, -5.0, 6.0), (0.0, 0.0, 2.3), size=4.0, watts=900.0)
    lamp((5.0, -4.0, 3.0), (0.0, 0.0, 2.3), size=3.0, watts=350.0)
    camera((0.0, -14.0, 2.9), (0.0, 0.0, 2.3), lens_mm=50.0, f_stop=16.0)
    save(sys.argv[1])


main()
