# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs in a Python with bpy: CPU time to render Nacre's films and Blender's own.

A sphere that fills the picture, under white light, so that shading is what counts; two numbers of
samples, whose difference is free of what it takes to prepare a scene. Variants take turns. Prints one
line of JSON: seconds by shading system and variant, and Blender's version.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable
from pathlib import Path

import bpy
from in_blender import extension, load_extension

ROUGHNESS = 0.2
# Short renders, many times: the least of a long one is still as restless as the machine.
FEW, MANY = 1, 33
SYSTEMS = ("svm", "osl")
FILMS = {"one": "anodised_titanium", "sixteen": "jewel_beetle"}


def blender_film(node_type: str) -> bpy.types.Material | None:
    """One of Blender's shaders with its thin film, everything else as it comes; None without film."""
    material = bpy.data.materials.new(node_type)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    node = tree.nodes.new(node_type)
    if "Thin Film Thickness" not in node.inputs:
        return None
    values = {"Roughness": ROUGHNESS, "Thin Film Thickness": 180.0, "Thin Film IOR": 2.2}
    for name, value in values.items():
        node.inputs[name].default_value = value
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(node.outputs[0], output.inputs["Surface"])
    return material


def nacre_film(material_id: str, form: str, exact: int = 0) -> bpy.types.Material:
    compiled = extension("core.library").Library.default().load(material_id)
    material = extension("materials.material").create_material(compiled, form)
    values = {"roughness": ROUGHNESS, "exact_rough": exact}
    extension("materials.material").set_values(material, values)
    return material


def variants() -> dict[tuple[str, str], bpy.types.Material]:
    """By shading system and name."""
    made: dict[tuple[str, str], bpy.types.Material] = {}
    for system, form in zip(SYSTEMS, ("nodes", "osl"), strict=True):
        for name, node_type in (
            ("principled", "ShaderNodeBsdfPrincipled"),
            ("metallic", "ShaderNodeBsdfMetallic"),
        ):
            material = blender_film(node_type)
            if material is not None:
                made[system, name] = material
        for name, material_id in FILMS.items():
            made[system, name] = nacre_film(material_id, form)
    made["osl", "exact"] = nacre_film(FILMS["one"], "osl", exact=1)
    return made


def prepare(options: argparse.Namespace) -> tuple[bpy.types.Scene, Callable]:
    scene = extension("background.scenes").build_stage("furnace").scene
    ball = extension("background.scenes.shape").sphere(
        scene, "Ball", (0.0, 0.0, 0.0), 1.0, rings=128
    )
    scene.render.resolution_x = scene.render.resolution_y = options.side
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", options.threads
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    return scene, extension("background.scenes.stage").place_on(ball)


def cpu_seconds(scene: bpy.types.Scene, samples: int) -> float:
    scene.cycles.samples = samples
    start = time.process_time()  # of all threads: other programs do not count
    bpy.ops.render.render()
    return time.process_time() - start


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--addon", type=Path, required=True)
    parser.add_argument("--side", type=int, default=160)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--repeats", type=int, default=20)
    options = parser.parse_args()

    load_extension(options.addon)
    scene, place = prepare(options)
    materials = variants()
    times: dict[tuple[str, str], list[tuple[float, float]]] = {key: [] for key in materials}
    for _ in range(options.repeats):
        for (system, name), material in materials.items():
            place(material)
            scene.cycles.shading_system = system == "osl"
            times[system, name].append((cpu_seconds(scene, FEW), cpu_seconds(scene, MANY)))
    # The least of each: what other programs take away only adds, and must not be subtracted.
    seconds = {
        f"{system}-{name}": min(many for _, many in pairs) - min(few for few, _ in pairs)
        for (system, name), pairs in times.items()
    }
    print("RESULT " + json.dumps({"seconds": seconds, "blender": bpy.app.version_string}))


if __name__ == "__main__":
    main()
