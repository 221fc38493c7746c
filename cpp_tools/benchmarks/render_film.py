# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs in a Python with bpy: CPU time to render Nacre's films and Principled's on one stage.

The stage, the material and the settings are those of `nacre render --stage sphere`. Prints one line
of JSON: seconds by variant, and Blender's version.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import json
import time
from collections.abc import Callable
from pathlib import Path

import bpy

PACKAGE = "nacre_extension"


def load_extension(folder: Path) -> None:
    spec = importlib.util.spec_from_file_location("nacre_driver", folder / "driver.py")
    driver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(driver)
    driver.load_package(PACKAGE)


def extension(module: str):
    return importlib.import_module(f"{PACKAGE}.{module}")


def principled(roughness: float) -> bpy.types.Material:
    """A thin film of oil on black dielectric: Principled's film, and nothing else of its layers."""
    material = bpy.data.materials.new("Principled")
    material.use_nodes = True
    node = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    values = {
        "Base Color": (0.0, 0.0, 0.0, 1.0),
        "Roughness": roughness,
        "IOR": 1.333,
        "Thin Film Thickness": 450.0,
        "Thin Film IOR": 1.47,
    }
    for name, value in values.items():
        node.inputs[name].default_value = value
    return material


def nacre_material(material_id: str, form: str, roughness: float) -> bpy.types.Material:
    compiled = extension("core.library").Library.default().load(material_id)
    material = extension("nodes.material").create_material(compiled, form)
    extension("nodes.material").set_values(material, {"roughness": roughness})
    return material


def settings(scene: bpy.types.Scene, options: argparse.Namespace) -> None:
    scene.render.resolution_x = scene.render.resolution_y = options.side
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", options.threads
    # Kept data also keep their number of samples, which is therefore the same in every render.
    scene.cycles.samples = options.samples
    scene.render.use_persistent_data = True  # what is timed is sampling, not preparation
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False


def cpu_seconds(scene: bpy.types.Scene, place: Callable, variant: tuple, repeats: int) -> float:
    """Best of some renders of one variant, after one that prepares the scene and its shaders."""
    material, uses_osl = variant
    place(material)
    scene.cycles.shading_system = uses_osl
    bpy.ops.render.render()
    best = float("inf")
    for _ in range(repeats):
        start = time.process_time()  # of all threads: other programs do not count
        bpy.ops.render.render()
        best = min(best, time.process_time() - start)
    return best


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--addon", type=Path, required=True)
    parser.add_argument("--side", type=int, default=192)
    parser.add_argument("--samples", type=int, default=32)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--roughness", type=float, default=0.12)
    options = parser.parse_args()

    load_extension(options.addon)
    stage = extension("scenes").build_stage("sphere")
    settings(stage.scene, options)
    variants = {"principled": (principled(options.roughness), False)}
    for material_id in ("oil_on_water", "jewel_beetle"):
        for form in ("nodes", "osl"):
            material = nacre_material(material_id, form, options.roughness)
            variants[f"{material_id}-{form}"] = material, form == "osl"

    seconds = {
        name: cpu_seconds(stage.scene, stage.place, variant, options.repeats)
        for name, variant in variants.items()
    }
    print("RESULT " + json.dumps({"seconds": seconds, "blender": bpy.app.version_string}))


if __name__ == "__main__":
    main()
