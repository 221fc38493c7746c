# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spheres of films as nodes under white light, by EEVEE: an atlas, as in furnace.py.

EEVEE draws no points, so the spheres are meshes; the stage is else that of the furnace.
"""

from __future__ import annotations

import math
from types import ModuleType

import bpy

from . import extension

# Normals are smooth between them; the picture's rim is left out of comparisons.
RINGS = 64


def engine(scene: bpy.types.Scene) -> str:
    engines = scene.render.bl_rna.properties["engine"].enum_items.keys()
    return "BLENDER_EEVEE_NEXT" if "BLENDER_EEVEE_NEXT" in engines else "BLENDER_EEVEE"


def makers_of_materials() -> ModuleType:
    """With what stones show in EEVEE, which the extension and its program have switched on."""
    extension.module("gems.cut_stone").register()
    return extension.module("materials.material")


def atlas(**job) -> None:
    """`cells` (material, values), `columns`, the `size` of a cell, samples, file; `unlit_behind`: what
    passes the films sees black, though they reflect white."""
    materials = makers_of_materials()
    library = extension.module("core.library").Library.default()
    add_sphere = extension.module("background.scenes.shape").sphere
    scene = extension.module("background.scenes").build_stage("furnace").scene
    columns = job["columns"]
    rows = math.ceil(len(job["cells"]) / columns)
    scene.camera.data.ortho_scale = 2.0 * max(columns, rows)
    for at, cell in enumerate(job["cells"]):
        row, column = divmod(at, columns)
        place = (2.0 * column - columns + 1, rows - 1.0 - 2 * row, 0.0)
        ball = add_sphere(scene, f"Ball {at}", place, 1.0, rings=RINGS)
        material = materials.create_material(library.load(cell["material"]), "nodes")
        materials.set_values(material, cell["values"])
        ball.data.materials.append(material)
    scene.render.engine = engine(scene)
    scene.eevee.taa_render_samples = job["samples"]
    scene.render.film_transparent = job.get("unlit_behind", False)
    scene.render.filter_size = 0.0  # the first sample lies at the pixel's centre
    render = scene.render
    render.resolution_x, render.resolution_y = columns * job["size"], rows * job["size"]
    render.resolution_percentage = 100
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.filepath = job["file"]
    bpy.ops.render.render(write_still=True)


def portrait(**job) -> None:
    """The `material` as its picture has it, without a floor, and with alpha for what it covers: `size`,
    samples, file; on another `object`; `plain`: as EEVEE shows it without an output of its own."""
    materials = makers_of_materials()
    compiled = extension.module("core.library").Library.default().load(job["material"])
    stage = extension.module("background.scenes").build_stage(
        "portrait", job.get("object", compiled.look.object)
    )
    # How images are filtered by their slope depends on the driver.
    bpy.context.preferences.system.anisotropic_filter = "FILTER_0"
    scene = stage.scene
    if "Floor" in bpy.data.objects:
        bpy.data.objects.remove(bpy.data.objects["Floor"])
    material = materials.create_material(compiled, "nodes")
    if job.get("plain"):
        outputs = material.node_tree.nodes
        outputs.remove(next(node for node in outputs if getattr(node, "target", "") == "EEVEE"))
    stage.place(material)
    scene.render.engine = engine(scene)
    scene.eevee.taa_render_samples = job["samples"]
    render = scene.render
    render.film_transparent = True
    render.resolution_x = render.resolution_y = job["size"]
    render.resolution_percentage = 100
    scene.view_settings.view_transform = "AgX"
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGBA"
    render.filepath = job["file"]
    bpy.ops.render.render(write_still=True)
