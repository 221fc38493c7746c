# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders spheres under white light with EEVEE in a Blender program: `-- ADDON JOBS.json`.

EEVEE draws no points, so the sphere is a mesh; the stage is else that of the furnace.
"""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path

import bpy

addon, jobs = sys.argv[sys.argv.index("--") + 1 :]
sys.path.insert(0, addon)
importlib.import_module("driver").load_package("nacre_extension")


def extension(module: str):
    return importlib.import_module(f"nacre_extension.{module}")


def eevee(scene: bpy.types.Scene) -> str:
    engines = scene.render.bl_rna.properties["engine"].enum_items.keys()
    return "BLENDER_EEVEE_NEXT" if "BLENDER_EEVEE_NEXT" in engines else "BLENDER_EEVEE"


library = extension("core.library").Library.default()
materials = extension("nodes.material")
scene = extension("scenes").build_stage("furnace").scene
ball = extension("scenes.shape").sphere(scene, "Ball", (0.0, 0.0, 0.0), 1.0, rings=256)
scene.render.engine = eevee(scene)
scene.eevee.taa_render_samples = 32
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
for job in json.loads(Path(jobs).read_text("utf-8")):
    material = materials.create_material(library.load(job["material"]), "nodes")
    materials.set_values(material, job["values"])
    extension("scenes.stage").place_on(ball)(material)
    scene.render.resolution_x = scene.render.resolution_y = job["size"]
    scene.render.filepath = job["file"]
    bpy.ops.render.render(write_still=True)
