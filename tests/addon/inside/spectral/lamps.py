# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Lamps keep their own colour for RGB and for EEVEE's viewport, which looks at nothing else; in bands their
nodes have all of it. Blender's black bodies are black bodies; what is Blender's own RGB is named."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.eevee import engine as eevee_engine
from jobs.extension import load, module
from jobs.pictures import render_picture
from jobs.steps import new_file

load().register()
convert, described = module("spectral.convert"), module("spectral.described")
groups, needs = module("spectral.groups"), module("spectral.needs")
rendering, lamps = module("spectral.rendering"), module("spectral.lamps")
operators, marks = module("spectral.operators"), module("spectral.marks")
give = module("spectral.give")
folder = Path(sys.argv[1])


def picture(name: str) -> np.ndarray:
    channels = module("core.exr").read_channels(folder / name)
    return np.stack([np.frombuffer(channels[channel], np.float32) for channel in "RGB"], -1)


OWN = (1.0, 0.5, 0.25)
cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
lamp = bpy.data.lights.new("Own", "SUN")
lamp.color, lamp.angle = OWN, 0.0
scene.collection.objects.link(bpy.data.objects.new("Own", lamp))
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
assert tuple(lamp.color) == OWN
give.to_lamp(lamp, described.Described.named("A"))
luminance = float(np.dot((0.2126390059, 0.7151686788, 0.0721923154), OWN))
warm = groups.rgb_of(described.Described.named("A"))
np.testing.assert_allclose(lamp.color, luminance * np.array(warm), rtol=1e-5)
give.to_lamp(lamp, described.Described.named("D65"))
np.testing.assert_allclose(lamp.color, luminance, rtol=1e-3)
given = tuple(lamp.color)
plan = needs.plan_for(scene, 4)
for engine in ("CYCLES", eevee_engine(scene)):
    scene.render.engine = engine
    with rendering.prepared(scene, plan, 4) as begin:
        begin(1)
        bands = lamps.lamps_in_bands(plan)[lamp][list(plan.indices(1))]
        shown = (1.0, 1.0, 1.0) if engine == "CYCLES" else bands
        np.testing.assert_allclose(lamp.color, shown, rtol=1e-5)
    assert tuple(lamp.color) == given
assert bpy.ops.nacre.make_rgb() == {"FINISHED"}
assert tuple(lamp.color) == OWN

# A black body is as bright in bands as Blender has it.
cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
material = bpy.data.materials.new("Glow")
material.use_nodes = True
tree = material.node_tree
tree.nodes.clear()
body, emission = tree.nodes.new("ShaderNodeBlackbody"), tree.nodes.new("ShaderNodeEmission")
output = tree.nodes.new("ShaderNodeOutputMaterial")
tree.links.new(body.outputs[0], emission.inputs["Color"])
tree.links.new(emission.outputs[0], output.inputs["Surface"])
cube.data.materials.clear()
cube.data.materials.append(material)
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.location = (0.0, 0.0, 1.5)
scene.collection.objects.link(camera)
scene.camera = camera
for kelvin in (2000.0, 5500.0):
    body.inputs[0].default_value = kelvin
    render_picture(scene, 4, 4, 1, str(folder / "before.exr"))
    assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
    assert (
        emission.inputs["Color"].links[0].from_node.node_tree.name
        == f"Spectrum: blackbody:{kelvin:g}"
    )
    render_picture(scene, 4, 4, 1, str(folder / "rgb.exr"))
    np.testing.assert_array_equal(picture("rgb.exr"), picture("before.exr"))
    plan = needs.plan_for(scene, 8)
    passes = rendering.beside(folder / "bands.exr", scene, plan, 8)
    passes.begin(resume=False)
    with rendering.prepared(scene, plan, 8) as begin:
        for number in passes.missing():
            begin(number)
            bpy.ops.render.render(scene=scene.name)
            passes.save(scene, number)
    in_bands = rendering.rendered(passes).rgb[2, 2]
    passes.end()
    in_rgb = picture("before.exr")[10]
    np.testing.assert_allclose(in_bands, in_rgb, rtol=0.05, atol=0.02)
    assert bpy.ops.nacre.make_rgb() == {"FINISHED"}

# What is Blender's own is named.
sky = tree.nodes.new("ShaderNodeTexSky")
tree.links.new(sky.outputs[0], emission.inputs["Color"])
principled = tree.nodes.new("ShaderNodeBsdfPrincipled")
if "Thin Film Thickness" in principled.inputs:
    principled.inputs["Thin Film Thickness"].default_value = 300.0
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
told = " ".join(remark.text for remark in operators.remarks())
assert "Blender's sky is RGB" in told
assert ("thin film is Blender's" in told) == ("Thin Film Thickness" in principled.inputs)
