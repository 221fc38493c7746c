# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Dispersive glass in bands, inside Blender."""

from __future__ import annotations

from pathlib import Path

import bpy

from .. import extension
from ..eevee import engine as eevee_engine
from ..furnace import blenders_own, film, keep_all_light
from ..pictures import empty_scene, render_picture
from ..prism import add_camera, wedge_of
from .scenes import rendered


def wedge(
    *, material: str, form: str, values: dict, apex_deg: float, incidence_deg: float, lines: str,
    samples: int, folder: str,
) -> dict:  # fmt: skip
    """Parallel rays through a wedge, in the bands of these lines: 4 plus the x of the direction to where the
    ray came from (direction.exr), and 1 (passed.exr), of what crossed both faces and was nowhere reflected; that
    light is RGB, `white` of a band."""
    scene = empty_scene()
    made = film(scene, {"material": material, "form": form, "values": values})
    wedge_of(scene, made, apex_deg, incidence_deg)
    add_camera(scene)
    scene.render.resolution_x = scene.render.resolution_y = 4
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    convert, give = extension.module("spectral.convert"), extension.module("spectral.give")
    described = extension.module("spectral.described").Described
    lamp = bpy.data.lights.new("lines", "POINT")  # in no scene: it asks for bands
    convert.make_spectral()
    give.to_lamp(lamp, described.named(lines))
    strength = _straight_light(scene)
    rendered(scene, str(Path(folder) / "passed.exr"), samples, 4)
    strength()
    return rendered(scene, str(Path(folder) / "direction.exr"), samples, 4)


def _straight_light(scene: bpy.types.Scene):
    """1 for what was refracted twice and not reflected; what is returned makes it 4 + x of the direction."""
    world = scene.world = bpy.data.worlds.new("World")
    world.use_nodes = True
    world.cycles.sampling_method = "NONE"
    tree = world.node_tree
    background = next(node for node in tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    path, geometry = tree.nodes.new("ShaderNodeLightPath"), tree.nodes.new("ShaderNodeNewGeometry")
    axes = tree.nodes.new("ShaderNodeSeparateXYZ")
    tree.links.new(geometry.outputs["Incoming"], axes.inputs[0])
    number = extension.module("blender.formula").Formula(tree).number
    twice = number("COMPARE", path.outputs["Transmission Depth"], 2.0, 0.5)
    unbent = number("COMPARE", path.outputs["Glossy Depth"], 0.0, 0.5)
    seen = number("MULTIPLY", twice, unbent)
    directed = number("MULTIPLY", seen, number("ADD", axes.outputs[0], 4.0))
    tree.links.new(seen, background.inputs["Strength"])
    return lambda: tree.links.new(directed, background.inputs["Strength"])


def ball(
    *, material: str, form: str, values: dict, indices: list[float], size: int, samples: int,
    folder: str, triples: int,
) -> dict:  # fmt: skip
    """A solid ball before a glowing chequered wall: in bands (bands.exr), and of plain glass of each index
    (000.exr …). Every pass has the same samples, as every index has, and chance decides alike: what differs is
    colour alone."""
    scene = empty_scene()
    shape = extension.module("background.scenes.shape").sphere
    item = shape(scene, "Sphere", (0.0, 0.0, 0.0), 1.0, rings=256)
    item.data.materials.append(film(scene, {"material": material, "form": form, "values": values}))
    scene.collection.objects.link(_wall())
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (0.0, -6.0, 0.0), (1.5708, 0.0, 0.0)
    camera.data.lens = 80.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    keep_all_light(scene)
    # What is reflected, outside or within, is chance, and would hide what colours do.
    scene.cycles.glossy_bounces, scene.cycles.transmission_bounces = 0, 2
    scene.render.resolution_x, scene.render.resolution_y = 4 * size, 3 * size
    extension.module("spectral.convert").make_spectral()
    rendering = extension.module("spectral.rendering")
    plan = extension.module("spectral.needs").plan_for(scene, triples)
    file = Path(folder) / "bands.exr"
    passes = rendering.beside(file, scene, plan, samples)
    passes.begin(resume=False)
    with rendering.prepared(scene, plan, samples) as begin:
        for number in passes.missing():
            begin(number)
            scene.cycles.use_sample_subset, scene.cycles.sample_offset = False, 0
            scene.cycles.samples = samples
            bpy.ops.render.render(scene=scene.name)
            passes.save(scene, number)
    found = rendering.rendered(passes)
    rendering.write(found, found.rgb, scene, file)
    passes.end()
    for at, index in enumerate(indices):
        item.data.materials[0] = _plain_glass(index)
        render_picture(scene, 4 * size, 3 * size, samples, str(Path(folder) / f"{at:03d}.exr"))
    return {"passes": plan.passes, "bands": len(plan.bands)}


def _plain_glass(index: float) -> bpy.types.Material:
    """As paths have it that are refracted in bands: at the first surface two lobes, mixed as Fresnel's law
    says, behind it Blender's glass."""
    material = blenders_own(0.0, index)
    tree = material.node_tree
    glass = next(node for node in tree.nodes if node.type == "BSDF_GLASS")
    end = glass.outputs[0].links[0].to_socket
    passed, mirrored, share, path, both, first = (
        tree.nodes.new(f"ShaderNode{name}")
        for name in (
            "BsdfRefraction",
            "BsdfAnisotropic",
            "Fresnel",
            "LightPath",
            "MixShader",
            "MixShader",
        )
    )
    for node in (passed, mirrored):
        node.distribution = "GGX"
        node.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
        node.inputs["Roughness"].default_value = 0.0
    for node in (passed, share):
        node.inputs["IOR"].default_value = index
    once = tree.nodes.new("ShaderNodeMath")
    once.operation, once.inputs[1].default_value = "LESS_THAN", 0.5
    tree.links.new(path.outputs["Transmission Depth"], once.inputs[0])
    for node, sources in ((both, (share, passed, mirrored)), (first, (once, glass, both))):
        for source, socket in zip(sources, node.inputs, strict=True):
            tree.links.new(source.outputs[0], socket)
    tree.links.new(first.outputs[0], end)
    return material


def _wall() -> bpy.types.Object:
    mesh = bpy.data.meshes.new("wall")
    mesh.from_pydata([(-9, 3, -9), (9, 3, -9), (9, 3, 9), (-9, 3, 9)], [], [(0, 1, 2, 3)])
    material = bpy.data.materials.new("wall")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    place = tree.nodes.new("ShaderNodeNewGeometry")
    checker = tree.nodes.new("ShaderNodeTexChecker")
    checker.inputs["Scale"].default_value = 2.0
    emission = tree.nodes.new("ShaderNodeEmission")
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    moved = tree.nodes.new("ShaderNodeVectorMath")  # no border lies on an axis
    moved.inputs[1].default_value = (0.1, 0.1, 0.1)
    tree.links.new(place.outputs["Position"], moved.inputs[0])
    tree.links.new(moved.outputs[0], checker.inputs["Vector"])
    tree.links.new(checker.outputs["Fac"], emission.inputs["Strength"])
    tree.links.new(emission.outputs[0], output.inputs["Surface"])
    mesh.materials.append(material)
    return bpy.data.objects.new("wall", mesh)


def eevee(*, material: str, folder: str, samples: int) -> list:
    """A ball under a white sky in EEVEE, in the three turns of a pass: what each channel has of its middle."""
    scene = empty_scene()
    shape = extension.module("background.scenes.shape").sphere
    item = shape(scene, "Sphere", (0.0, 0.0, 0.0), 1.0, rings=16)
    glass = film(scene, {"material": material, "form": "nodes", "values": {}})
    glass.use_raytrace_refraction = True
    item.data.materials.append(glass)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    background = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (0.0, -6.0, 0.0), (1.5708, 0.0, 0.0)
    camera.data.lens = 200.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = 8
    scene.render.engine = eevee_engine(scene)
    scene.eevee.use_raytracing = True
    extension.module("spectral.convert").make_spectral()
    rendering = extension.module("spectral.rendering")
    plan = extension.module("spectral.needs").plan_for(scene, 4)
    passes = rendering.beside(Path(folder) / "ball.exr", scene, plan, samples)
    passes.begin(resume=False)
    found = []
    with rendering.prepared(scene, plan, samples) as begin:
        for number in range(0, plan.passes, plan.triples):
            begin(number)
            bpy.ops.render.render()
            passes.save(scene, number)
            channels = extension.module("core.exr").read_channels(passes.files[number])
            found.append([sum(channels[f"Combined.{name}"]) / 64 for name in "RGB"])
    return found
