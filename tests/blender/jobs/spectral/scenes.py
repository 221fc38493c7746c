# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Spectral scenes inside Blender."""

from __future__ import annotations

import math
from pathlib import Path
from random import Random

import bpy

from .. import extension
from ..eevee import engine as eevee_engine
from ..furnace import atlas_scene as furnace_atlas
from ..furnace import film as furnace_film
from ..furnace import light_by_depth
from ..pictures import empty_scene, of_one_shader, render_picture


def patch(scene: bpy.types.Scene, column: int, row: int, material: bpy.types.Material) -> None:
    mesh = bpy.data.meshes.new("patch")
    x, y = float(column), -float(row)
    corners = [(x, y, 0), (x + 1, y, 0), (x + 1, y - 1, 0), (x, y - 1, 0)]
    mesh.from_pydata(corners, [], [(3, 2, 1, 0)])
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new("patch", mesh))


def seen_from_above(scene: bpy.types.Scene, columns: int, rows: int, size: int) -> None:
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = float(max(columns, rows))
    camera.location = (columns / 2, -rows / 2, 5.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = size * columns, size * rows
    scene.render.filter_size = 0.01


def spectrum_node(tree: bpy.types.NodeTree, name: str) -> bpy.types.NodeSocket:
    node = tree.nodes.new("ShaderNodeGroup")
    described = extension.module("spectral.described").Described
    node.node_tree = extension.module("spectral.groups").spectrum_group(described.named(name))
    return node.outputs[0]


def chart(
    *, reflectances: list[str], lights: list[str], file: str, size: int, samples: int, passes: int
) -> dict:
    """Patches seen from above, a row of the picture for each light: what they emit is the light times
    the reflectance. `passes`: 0 for as many as are needed, -1 for paths that draw their wavelengths."""
    scene = empty_scene()
    for row, light in enumerate(lights):
        for column, reflectance in enumerate(reflectances):
            material = bpy.data.materials.new(f"{light} {reflectance}")
            material.use_nodes = True
            tree = material.node_tree
            tree.nodes.clear()
            both = tree.nodes.new("ShaderNodeVectorMath")
            both.operation = "MULTIPLY"
            for socket, name in zip(both.inputs, (light, reflectance), strict=False):
                tree.links.new(spectrum_node(tree, name), socket)
            emission = tree.nodes.new("ShaderNodeEmission")
            out = tree.nodes.new("ShaderNodeOutputMaterial")
            tree.links.new(both.outputs[0], emission.inputs["Color"])
            tree.links.new(emission.outputs[0], out.inputs["Surface"])
            patch(scene, column, row, material)
    seen_from_above(scene, len(reflectances), len(lights), size)
    if passes < 0:
        return by_paths(scene, file, samples)
    return rendered(scene, file, samples, passes)


def lit_chart(
    *, reflectances: list[str], light: str, folder: str, size: int, samples: int, passes: int
) -> dict:
    """A row of matt patches, the last one white, under a coloured lamp that gets a spectrum: as they
    were (before.exr), in bands (bands.exr), and with everything undone (after.exr). The lamp's colour is dark,
    as Cycles leaves out lamps that were dark in the pass before; bright samples are clamped, of which there
    are none."""
    convert, give = extension.module("spectral.convert"), extension.module("spectral.give")
    described = extension.module("spectral.described").Described
    scene = empty_scene()
    for column, reflectance in enumerate([*reflectances, ""]):
        patch(scene, column, 0, matt(reflectance))
    lamp = bpy.data.lights.new("lamp", "SUN")
    lamp.angle, lamp.energy, lamp.color = 0.0, 20.0, (0.1, 0.08, 0.05)
    scene.collection.objects.link(bpy.data.objects.new("lamp", lamp))
    scene.cycles.sample_clamp_direct = 2.0
    seen_from_above(scene, len(reflectances) + 1, 1, size)
    places = {name: str(Path(folder) / f"{name}.exr") for name in ("before", "bands", "after")}
    width, height = scene.render.resolution_x, scene.render.resolution_y
    render_picture(scene, width, height, 1, places["before"])
    convert.make_spectral()
    give.to_lamp(lamp, described.named("A"))
    give.to_lamp(lamp, described.named(light))
    said = rendered(scene, places["bands"], samples, passes)
    removed = convert.make_rgb()
    render_picture(scene, width, height, 1, places["after"])
    return {**said, "removed": removed}


def eevee(
    *, reflectances: list[str], lights: list[str], film: dict, folder: str, size: int, samples: int
) -> dict:
    """A row of matt patches in EEVEE, the last but one white, the last one a film that lies flat, each
    time under another lamp that is as white as the sky (LIGHT.exr)."""
    convert, give = extension.module("spectral.convert"), extension.module("spectral.give")
    described = extension.module("spectral.described").Described
    scene = empty_scene()
    for column, reflectance in enumerate([*reflectances, ""]):
        patch(scene, column, 0, matt(reflectance))
    patch(scene, len(reflectances) + 1, 0, furnace_film(scene, {"form": "nodes", **film}))
    lamp = bpy.data.lights.new("lamp", "SUN")
    lamp.angle, lamp.energy = 0.0, 2.0
    sun = bpy.data.objects.new("lamp", lamp)
    sun.rotation_euler.x = 0.7  # the film mirrors the sky alone
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    seen_from_above(scene, len(reflectances) + 2, 1, size)
    scene.render.engine = eevee_engine(scene)
    convert.make_spectral()
    for light in lights:
        spectrum = described.named(light)
        give.to_lamp(lamp, spectrum)
        give.to_world(scene.world, spectrum)
        said = rendered(scene, str(Path(folder) / f"{light.replace('/', '_')}.exr"), samples, 0)
    return said


def matt(reflectance: str) -> bpy.types.Material:
    material, diffuse = of_one_shader(reflectance or "white", "ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    tree = material.node_tree
    if reflectance:
        tree.links.new(spectrum_node(tree, reflectance), diffuse.inputs["Color"])
    return material


def rendered(
    scene: bpy.types.Scene, file: str, samples: int, passes: int, *, denoise: bool = False
) -> dict:
    made = extension.module("spectral.needs").plan_for(scene, passes or None)
    rendering = extension.module("spectral.rendering")
    kept = rendering.beside(Path(file), scene, made, samples, denoise=denoise)
    kept.begin(resume=False)
    with rendering.prepared(scene, made, samples, denoise=denoise) as begin:
        for number in kept.missing():
            begin(number)
            bpy.ops.render.render(scene=scene.name)
            kept.save(scene, number)
    found = rendering.rendered(kept)
    rendering.write(found, rendering.colour_of(found, scene, samples), scene, Path(file))
    kept.end()
    return {
        "passes": made.passes,
        "left": [key for key in scene.keys() if "nacre" in key],  # noqa: SIM118 of an ID
        "white": [float(value) for value in made.white],
    }


def _material(name: str, colour: tuple) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    principled = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    principled.inputs["Base Color"].default_value = (*colour, 1.0)
    principled.inputs["Roughness"].default_value = 0.8
    return material


def room() -> bpy.types.Scene:
    """A room with coloured walls: constants, a picture, colours that nodes compute, a tinted lamp, a
    coloured world, a glowing ball."""
    scene = empty_scene()
    white, red = _material("white", (0.7, 0.7, 0.7)), _material("red", (0.6, 0.06, 0.03))
    painted, mixed = _material("painted", (0.8, 0.8, 0.8)), _material("mixed", (0.8, 0.8, 0.8))
    glowing = _material("glowing", (0.0, 0.0, 0.0))

    tree = painted.node_tree
    picture = bpy.data.images.new("paint", 8, 8, float_buffer=True)
    pixels = [(x / 8, y / 8, 0.4, 1.0) for y in range(8) for x in range(8)]
    picture.pixels.foreach_set([channel for pixel in pixels for channel in pixel])
    picture.pack()
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.image = picture
    tree.links.new(texture.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])

    tree = mixed.node_tree
    checker = tree.nodes.new("ShaderNodeTexChecker")
    checker.inputs["Color1"].default_value = (0.1, 0.5, 0.15, 1.0)
    checker.inputs["Color2"].default_value = (0.05, 0.1, 0.6, 1.0)
    tree.links.new(checker.outputs[0], tree.nodes["Principled BSDF"].inputs["Base Color"])

    shining = glowing.node_tree.nodes["Principled BSDF"]
    shining.inputs["Emission Color"].default_value = (1.0, 0.45, 0.1, 1.0)
    shining.inputs["Emission Strength"].default_value = 2.0

    def wall(corners, material):
        mesh = bpy.data.meshes.new("wall")
        mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
        mesh.uv_layers.new()
        for loop, uv in zip(mesh.uv_layers[0].data, ((0, 0), (1, 0), (1, 1), (0, 1)), strict=True):
            loop.uv = uv
        mesh.materials.append(material)
        scene.collection.objects.link(bpy.data.objects.new("wall", mesh))

    wall([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], mixed)
    wall([(-1, 1, 0), (1, 1, 0), (1, 1, 2), (-1, 1, 2)], painted)
    wall([(-1, -1, 0), (-1, 1, 0), (-1, 1, 2), (-1, -1, 2)], red)
    wall([(1, -1, 0), (1, 1, 0), (1, 1, 2), (1, -1, 2)], white)
    bpy.ops.mesh.primitive_uv_sphere_add(radius=0.3, location=(0.3, 0.2, 0.3))
    bpy.context.object.data.materials.append(glowing)

    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.energy, lamp.size, lamp.color = 30.0, 0.5, (1.0, 0.8, 0.55)
    placed = bpy.data.objects.new("lamp", lamp)
    placed.location = (0.0, 0.0, 1.95)
    scene.collection.objects.link(placed)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = next(n for n in scene.world.node_tree.nodes if n.type == "BACKGROUND")
    background.inputs["Color"].default_value = (0.2, 0.3, 0.5, 1.0)
    background.inputs["Strength"].default_value = 0.3

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (0.0, -4.0, 1.0), (1.5708, 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene


def box(*, folder: str, size: int, samples: int, passes: int) -> dict:
    """As it is (before.exr), made spectral but rendered in RGB (rgb.exr), in bands (bands.exr), and
    with everything undone (after.exr)."""
    convert = extension.module("spectral.convert")
    scene = room()
    places = {
        name: str(Path(folder) / f"{name}.exr") for name in ("before", "rgb", "bands", "after")
    }
    render_picture(scene, size, size, samples, places["before"])
    report = convert.make_spectral()
    twice = convert.make_spectral()
    render_picture(scene, size, size, samples, places["rgb"])
    said = rendered(scene, places["bands"], samples, passes)
    removed = convert.make_rgb()
    render_picture(scene, size, size, samples, places["after"])
    return {
        **said,
        "spectra": report.spectra,
        "remarks": [[remark.where, remark.text] for remark in report.remarks],
        "twice": twice.spectra,
        "removed": removed,
        "is_spectral": extension.module("spectral.marks").is_spectral(),
    }


def films(
    *, cells: list, columns: int, folder: str, size: int, samples: int, lit: str, light: str = "",
    passes: int = 0,
) -> dict:  # fmt: skip
    """Spheres of films under white, as an atlas of the furnace: in RGB (before.exr), in bands under white
    or a light (bands.exr), and with everything undone (after.exr). `lit`: as of the furnace; `passes`: as of the
    chart."""
    give = extension.module("spectral.give")
    convert, described = (
        extension.module("spectral.convert"),
        extension.module("spectral.described"),
    )
    bpy.ops.wm.read_homefile(use_empty=True)
    scene = furnace_atlas({"cells": cells, "columns": columns})
    if lit == "reflected":
        light_by_depth(scene.world, 0)
    width, height = columns * size, -(-len(cells) // columns) * size
    places = {name: str(Path(folder) / f"{name}.exr") for name in ("before", "bands", "after")}
    render_picture(scene, width, height, samples, places["before"])

    def blocks() -> list[str]:
        used = [image.name for image in bpy.data.images if image.users]
        return sorted([group.name for group in bpy.data.node_groups] + used)

    blocks_before = blocks()
    report = convert.make_spectral()
    if light:
        give.to_world(scene.world, described.Described.named(light))
    if passes < 0:
        said = by_paths(scene, places["bands"], samples)
    else:
        said = rendered(scene, places["bands"], samples, passes)
    removed = convert.make_rgb()
    render_picture(scene, width, height, samples, places["after"])
    return {
        **said,
        "spectra": report.spectra,
        "removed": removed,
        "remarks": [[remark.where, remark.text] for remark in report.remarks],
        "blocks_before": blocks_before,
        "blocks": blocks(),
    }


SURFACES = (
    "Principled", "Diffuse", "Anisotropic", "Metallic", "Glass", "Refraction", "Transparent",
    "Translucent", "Sheen", "Toon", "Hair", "HairPrincipled",
)  # fmt: skip
VOLUMES = ("ShaderNodeVolumeAbsorption", "ShaderNodeVolumeScatter", "ShaderNodeVolumePrincipled")
SOURCES = (
    "", "", "ShaderNodeRGB", "ShaderNodeBlackbody", "ShaderNodeTexNoise", "ShaderNodeTexVoronoi",
    "ShaderNodeHueSaturation", "ShaderNodeGamma", "ShaderNodeWavelength", "ShaderNodeTexImage",
    "ShaderNodeVertexColor", "ShaderNodeTexEnvironment",
)  # fmt: skip


def _random_material(number: int, random: Random, picture: bpy.types.Image) -> bpy.types.Material:
    """A shader of some kind, or two mixed, with colours that are set, computed or read."""
    material = bpy.data.materials.new(f"Random {number}")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    out = tree.nodes.new("ShaderNodeOutputMaterial")

    def shader(kind: str) -> bpy.types.NodeSocket:
        node = tree.nodes.new(kind)
        for socket in node.inputs:
            if socket.type != "RGBA":
                continue
            socket.default_value = (random.random(), random.random(), random.random(), 1.0)
            source = random.choice(SOURCES)
            if not source:
                continue
            feed = tree.nodes.new(source)
            if hasattr(feed, "image"):
                feed.image = picture
            tree.links.new(feed.outputs["Color"], socket)
            if random.random() < 0.1:
                socket.links[0].is_muted = True
        return node.outputs[0]

    kinds = [f"ShaderNodeBsdf{random.choice(SURFACES)}" for _ in range(2)]
    surface = shader(kinds[0])
    if random.random() < 0.3:
        mix = tree.nodes.new("ShaderNodeMixShader")
        tree.links.new(surface, mix.inputs[1])
        tree.links.new(shader(kinds[1]), mix.inputs[2])
        surface = mix.outputs[0]
    if random.random() < 0.3:
        group = bpy.data.node_groups.new(f"Group {number}", "ShaderNodeTree")
        group.interface.new_socket("Tint", in_out="INPUT", socket_type="NodeSocketColor")
        group.interface.new_socket("Shader", in_out="OUTPUT", socket_type="NodeSocketShader")
        ends = [group.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput")]
        inner = group.nodes.new("ShaderNodeBsdfTranslucent")
        group.links.new(ends[0].outputs[0], inner.inputs["Color"])
        group.links.new(inner.outputs[0], ends[1].inputs[0])
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = group
        node.inputs[0].default_value = (random.random(), 0.5, random.random(), 1.0)
        add = tree.nodes.new("ShaderNodeAddShader")
        tree.links.new(surface, add.inputs[0])
        tree.links.new(node.outputs[0], add.inputs[1])
        surface = add.outputs[0]
    tree.links.new(surface, out.inputs["Surface"])
    if random.random() < 0.1:
        tree.links.new(shader(random.choice(VOLUMES)), out.inputs["Volume"])
    return material


def many(*, folder: str, count: int, samples: int) -> dict:
    """Tiles of as many materials as chance makes, under a sun and a sky: as they were (before.exr) and
    with another seed (again.exr), in bands (bands.exr), and with everything undone (after.exr)."""
    convert = extension.module("spectral.convert")
    scene = empty_scene()
    if hasattr(
        scene.cycles, "volume_biased"
    ):  # Blender 5; volumes without an end take 40 times as long else
        scene.cycles.volume_biased = True
    random = Random(7)
    picture = bpy.data.images.new("picture", 4, 4, float_buffer=True)
    picture.pixels.foreach_set([random.random() for _ in range(64)])
    picture.pack()
    columns = math.ceil(math.sqrt(count))
    for number in range(count):
        material = _random_material(number, random, picture)
        patch(scene, number % columns, number // columns, material)
    sun = bpy.data.lights.new("sun", "SUN")
    sun.angle, sun.energy, sun.color = 0.5, 2.0, (1.0, 0.9, 0.7)
    scene.collection.objects.link(bpy.data.objects.new("sun", sun))
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = next(n for n in scene.world.node_tree.nodes if n.type == "BACKGROUND")
    background.inputs["Color"].default_value = (0.3, 0.4, 0.6, 1.0)
    seen_from_above(scene, columns, columns, 4)
    names = ("before", "again", "bands", "after")
    places = {name: str(Path(folder) / f"{name}.exr") for name in names}
    width, height = scene.render.resolution_x, scene.render.resolution_y
    render_picture(scene, width, height, samples, places["before"])
    scene.cycles.seed = 1
    render_picture(scene, width, height, samples, places["again"])
    scene.cycles.seed = 0
    report = convert.make_spectral()
    said = rendered(scene, places["bands"], samples, 8)
    removed = convert.make_rgb()
    render_picture(scene, width, height, samples, places["after"])
    return {
        **said,
        "spectra": report.spectra,
        "removed": removed,
        "remarks": [remark.text for remark in report.remarks],
    }


def by_paths(scene: bpy.types.Scene, file: str, samples: int) -> dict:
    """The scene as its paths draw wavelengths, in a file of RGB."""
    plan = extension.module("spectral.needs").plan_for(scene)
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = False
    before = sorted(node.name for group in bpy.data.node_groups for node in group.nodes)
    found = extension.module("spectral.paths.render").picture(scene, plan)
    rendering = extension.module("spectral.rendering")
    image = rendering.as_image(found.rgb, found.alpha, "by paths")
    extension.module("blender.output").Writer(scene).save(Path(file), image)
    bpy.data.images.remove(image)
    after = sorted(node.name for group in bpy.data.node_groups for node in group.nodes)
    return {
        "left": [key for key in scene.keys() if "nacre" in key],  # noqa: SIM118 of an ID
        "same": before == after,
    }
