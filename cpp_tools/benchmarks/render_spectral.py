# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs in a Python with bpy: noise and CPU time of a scene in bands beside plain RGB, equal samples.

A Cornell box with painted walls and two blocks under one lamp, whose colours bleed into each other.
Noise is the RMS difference from a picture of many samples, of RGB or bands each from its own: of Y
over its mean, and of a* and b*. Prints one line of JSON.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from pathlib import Path

import bpy
import numpy as np
from in_blender import extension, load_extension
from noise import noise
from room import ROOM

SAMPLES, MANY, PASSES = 96, 2048, 8


def material(name: str) -> bpy.types.Material:
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*ROOM[name], 1.0)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
    return made


def box(size: tuple[int, int]) -> bpy.types.Scene:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    cycles = scene.cycles
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.diffuse_bounces = 8
    cycles.sample_clamp_indirect = 0.0
    paint = {name: material(name) for name in ROOM}

    def wall(corners: list, name: str) -> None:
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
        mesh.materials.append(paint[name])
        scene.collection.objects.link(bpy.data.objects.new(name, mesh))

    a = 1.33
    wall([(-a, -1, 0), (a, -1, 0), (a, 1, 0), (-a, 1, 0)], "white")
    wall([(-a, -1, 2), (a, -1, 2), (a, 1, 2), (-a, 1, 2)], "white")
    wall([(-a, 1, 0), (a, 1, 0), (a, 1, 2), (-a, 1, 2)], "white")
    wall([(-a, -1, 0), (-a, 1, 0), (-a, 1, 2), (-a, -1, 2)], "red")
    wall([(a, -1, 0), (a, 1, 0), (a, 1, 2), (a, -1, 2)], "green")
    bpy.ops.mesh.primitive_uv_sphere_add(
        segments=48, ring_count=24, radius=0.42, location=(-0.55, 0.1, 0.42)
    )
    bpy.context.object.data.materials.append(paint["yellow"])
    bpy.ops.mesh.primitive_cube_add(size=0.7, location=(0.55, 0.3, 0.35), rotation=(0, 0, 0.5))
    bpy.context.object.data.materials.append(paint["blue"])

    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.size, lamp.energy = 0.6, 40.0
    placed = bpy.data.objects.new("lamp", lamp)
    placed.location = (0.0, 0.0, 1.98)
    scene.collection.objects.link(placed)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.lens = 38.0
    camera.location, camera.rotation_euler = (0.0, -4.2, 1.0), (np.pi / 2, 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene


def read(file: Path) -> np.ndarray:
    exr = extension("core.exr")
    width, height = exr.size_of(file)
    channels = exr.read_channels(file)
    values = [np.frombuffer(channels[f"Combined.{c}"], np.float32) for c in "RGB"]
    return np.stack(values, axis=-1).reshape(height, width, 3)


def in_rgb(scene: bpy.types.Scene, samples: int, seed: int, folder: Path) -> tuple:
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.use_persistent_data = True
    start = time.process_time()  # of all threads: other programs do not count
    bpy.ops.render.render()
    extension("blender.output").Writer(scene, layers=True, compressed=False).save(
        folder / "rgb.exr"
    )
    seconds = time.process_time() - start
    return read(folder / "rgb.exr"), seconds


def in_bands(scene: bpy.types.Scene, samples: int, seed: int, folder: Path) -> tuple:
    rendering = extension("spectral.rendering")
    spectra = extension("spectral.groups").found_spectra()
    plan = extension("spectral.plan").make(spectra, PASSES)
    scene.cycles.seed = seed
    passes = rendering.beside(folder / "bands.exr", scene, plan, samples)
    passes.begin(resume=False)
    with rendering.prepared(scene, plan, samples) as begin:
        start = time.process_time()
        for number in passes.missing():
            begin(number)
            bpy.ops.render.render()
            passes.save(scene, number)
        seconds = time.process_time() - start
    rgb = rendering.rendered(passes).rgb
    passes.end()
    return rgb, seconds


def in_paths(scene: bpy.types.Scene, samples: int, seed: int, _folder: Path) -> tuple:
    spectra = extension("spectral.groups").found_spectra()
    plan = extension("spectral.plan").make(spectra, PASSES)
    scene.cycles.samples, scene.cycles.seed = samples, seed
    start = time.process_time()
    found = extension("spectral.paths.render").picture(scene, plan)
    return found.rgb, time.process_time() - start


def in_xyz(rgb: np.ndarray) -> np.ndarray:
    return rgb @ np.array(extension("core.space").REC709).T


def a_pass(triangles: int, folder: Path) -> dict[str, float]:
    """Seconds of a pass of a million triangles with a sample a pixel, the shortest, and of a render in which
    nothing changed since the one before."""
    scene = box((64, 48))
    side = round((triangles / 2) ** 0.5) + 1
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=side, y_subdivisions=side, location=(0, 0, 0.9))
    bpy.context.object.data.materials.append(bpy.data.materials["blue"])
    extension("spectral.convert").make_spectral()
    rendering = extension("spectral.rendering")
    plan = extension("spectral.plan").make(extension("spectral.groups").found_spectra(), 16)
    passes = rendering.beside(folder / "many.exr", scene, plan, plan.passes)
    passes.begin(resume=False)
    seconds: dict[str, list[float]] = {"pass": [], "same": []}

    def timed(name: str) -> None:
        start = time.perf_counter()
        bpy.ops.render.render()
        seconds[name].append(time.perf_counter() - start)

    with rendering.prepared(scene, plan, plan.passes) as begin:
        for number in range(plan.passes):
            begin(number)
            timed("pass")
        for _ in range(plan.passes):
            timed("same")
    return {name: min(all_of_them[1:]) for name, all_of_them in seconds.items()}


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--addon", type=Path, required=True)
    parser.add_argument("--size", type=int, nargs=2, default=(160, 120))
    parser.add_argument("--repeats", type=int, default=4)
    options = parser.parse_args()
    load_extension(options.addon)
    scene = box(tuple(options.size))
    folder = Path(tempfile.mkdtemp())
    reference = {"rgb": in_rgb(scene, MANY, 1, folder)[0]}
    results: dict[str, list] = {"rgb": [], "bands": [], "paths": []}
    for seed in range(options.repeats):
        results["rgb"].append(in_rgb(scene, SAMPLES, 10 + seed, folder))
    extension("spectral.convert").make_spectral()
    reference["bands"] = reference["paths"] = in_bands(scene, MANY, 1, folder)[0]
    for seed in range(options.repeats):
        results["bands"].append(in_bands(scene, SAMPLES, 10 + seed, folder))
        results["paths"].append(in_paths(scene, SAMPLES, 10 + seed, folder))
    measured = {}
    for name, renders in results.items():
        both = [noise(in_xyz(picture), in_xyz(reference[name])) for picture, _ in renders]
        measured[name] = {
            "luminance": float(np.mean([pair[0] for pair in both])),
            "chroma": float(np.mean([pair[1] for pair in both])),
            "seconds": min(seconds for _, seconds in renders),
        }
    many = a_pass(1_000_000, folder)
    sys.stdout.flush()
    print(
        "RESULT "
        + json.dumps({"measured": measured, "many": many, "blender": bpy.app.version_string})
    )


if __name__ == "__main__":
    main()
