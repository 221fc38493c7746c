# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The probe: numbers of known points, of every source of a thickness, and nothing left behind."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
thickness = module("thickness.nodes")
stack = module("films.edited")
recipes = module("materials.recipe")
views = module("viewer.views")
folder, form = Path(sys.argv[1]), sys.argv[2]

import nacre  # noqa: E402  which the driver has brought

SIZE, TILT_DEG = 32, 50.0
UV_AT = ((20, 9), (5, 25), (16, 16))


def probe(x: int, y: int) -> dict:
    assert bpy.ops.nacre.probe(x=x, y=y, camera=True) == {"FINISHED"}
    return json.loads(bpy.context.window_manager.nacre_probe.json)


def snapshot() -> dict:
    """What a user would notice."""
    trees = [m.node_tree for m in bpy.data.materials if m.node_tree] + list(bpy.data.node_groups)
    return {
        "data": {
            name: sorted(item.name for item in getattr(bpy.data, name))
            for name in ("scenes", "objects", "cameras", "node_groups", "materials", "worlds")
        },
        "images": sorted(i.name for i in bpy.data.images if i.name != "Render Result"),
        "nodes": [
            (tree.name, sorted((n.name, getattr(n, "is_active_output", None)) for n in tree.nodes))
            for tree in trees
        ],
        "links": [len(tree.links) for tree in trees],
        "drivers": [
            len(tree.animation_data.drivers) if tree.animation_data else -1 for tree in trees
        ],
        "scene": [
            (name, getattr(bpy.context.scene.render, name))
            for name in ("engine", "resolution_x", "use_border", "filepath", "film_transparent")
        ],
        "passes": [len(layer.aovs) for layer in bpy.context.scene.view_layers],
        "world": bpy.context.scene.world,
        "camera": bpy.context.scene.camera,
    }


def plane(material: str) -> bpy.types.Object:
    new_file()
    bpy.data.objects.remove(bpy.context.object)
    bpy.ops.mesh.primitive_plane_add(size=2.0)
    obj = bpy.context.object
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    tilt = math.radians(TILT_DEG)
    camera.location = (0.0, -5.0 * math.sin(tilt), 5.0 * math.cos(tilt))
    camera.rotation_euler = (tilt, 0.0, 0.0)
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = 1.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    bpy.ops.nacre.assign_material(material=material, form=form)
    return obj


def check_film(found: dict, template: str, value: float, angle_deg: float) -> None:
    exact = nacre.template_spectrum(template, value, angle_deg)
    np.testing.assert_allclose(found["R"]["spectrum"], exact.reflectance, atol=1e-6)
    np.testing.assert_allclose(found["R"]["rgb"], exact.colours[0], atol=1e-6)
    XYZ = nacre.spectrum_to_colour(np.arange(360, 831), exact.reflectance).XYZ  # noqa: N806
    np.testing.assert_allclose(found["R"]["XYZ"], XYZ, atol=1e-6)


# A plane under a known angle: numbers, place, nothing changed.
obj = plane("soap_film:even")
material = obj.active_material
template = recipes.recipe(material).template
socket = thickness.thickness_socket(material)
socket.default_value = 543.25
before = snapshot()
for x, y in UV_AT:
    found = probe(x, y)
    assert found["material"] == material.name
    assert abs(found["angle_deg"] - TILT_DEG) < 1e-4, found["angle_deg"]
    assert found["thickness_nm"] == 543.25
    place = ((x + 0.5) / SIZE - 0.5, (0.5 - (y + 0.5) / SIZE) / math.cos(math.radians(TILT_DEG)))
    np.testing.assert_allclose(found["point"], [*place, 0.0], atol=1e-3)
    np.testing.assert_allclose(found["uv"], [0.5 + p / 2 for p in found["point"][:2]], atol=1e-6)
    np.testing.assert_allclose(found["normal"], [0.0, 0.0, 1.0], atol=1e-6)
    check_film(found, template, 543.25, TILT_DEG)
assert "T" in found
assert snapshot() == before, (snapshot(), before)

# It is undone with, and undoes nothing.
bpy.ops.ed.undo_push(message="before")
socket.default_value = 321.0
bpy.ops.ed.undo_push(message="thickness")
probe(16, 16)
bpy.ops.ed.undo()
obj = bpy.context.view_layer.objects.active
material = obj.active_material
assert thickness.thickness_socket(material).default_value == 543.25
assert json.loads(bpy.context.window_manager.nacre_probe.json)["thickness_nm"] == 321.0

# What was found can be copied line by line; a background Blender has no clipboard to read.
assert bpy.ops.nacre.copy_probe(what="json") == {"FINISHED"}
assert bpy.ops.nacre.copy_probe(what="line", line=1) == {"FINISHED"}

# Held to the tables' range, as the film is.
value = material.node_tree.nodes.new("ShaderNodeValue")
value.outputs[0].default_value = 5000.0
material.node_tree.links.new(value.outputs[0], thickness.thickness_socket(material))
assert probe(16, 16)["thickness_nm"] == 1500.0
material.node_tree.nodes.remove(value)

# A drop, by its own formula at the place that is reported.
bpy.ops.nacre.add_thickness(source="drop")
drop = thickness.sources_of(material)[0]
for name, given in {"Base": 100.0, "Height": 700.0, "Radius": 0.4}.items():
    drop.inputs[name].default_value = given
for x, y in UV_AT:
    found = probe(x, y)
    u, v = found["uv"]
    r = math.hypot(u - 0.5, v - 0.5) / 0.4
    wanted = 100.0 + 700.0 * max(0.0, 1.0 - r * r)
    assert abs(found["thickness_nm"] - wanted) < 1e-2, (found, wanted)
    check_film(found, template, found["thickness_nm"], TILT_DEG)

# An attribute of the mesh, from corner to corner.
layer = obj.data.attributes.new("nm", "FLOAT", "POINT")
for vertex, item in zip(obj.data.vertices, layer.data, strict=True):
    item.value = 600.0 + 200.0 * vertex.co.x + 50.0 * vertex.co.y
bpy.ops.nacre.add_thickness(source="attribute_nm", attribute="nm")
for x, y in UV_AT:
    found = probe(x, y)
    wanted = 600.0 + 200.0 * found["point"][0] + 50.0 * found["point"][1]
    assert abs(found["thickness_nm"] - wanted) < 1e-2, (found, wanted)

# A picture: the middle of a texel has its value.
picture = bpy.data.images.new("map", 4, 4, float_buffer=True, is_data=True)
texels = np.random.default_rng(5).random((4, 4), np.float32)
rgba = np.ones((4, 4, 4), np.float32)
rgba[..., :3] = texels[..., None]
picture.pixels.foreach_set(rgba.ravel())
picture.file_format = "OPEN_EXR"
picture.filepath_raw = str(folder / "Dicke é.exr")
picture.save()
bpy.ops.nacre.add_thickness(source="map", filepath=picture.filepath_raw)
mapped = thickness.sources_of(material)[0]
image_node = mapped.inputs["Value"].links[0].from_node
image_node.interpolation = "Closest"
mapped.inputs["Minimum"].default_value, mapped.inputs["Maximum"].default_value = 100.0, 900.0
for x, y in UV_AT:
    found = probe(x, y)
    u, v = found["uv"]
    wanted = 100.0 + 800.0 * float(texels[int(4 * v), int(4 * u)])
    assert abs(found["thickness_nm"] - wanted) < 0.05, (found, wanted)

# A swirl upon it, against the same nodes rendered as light.
bpy.ops.nacre.add_thickness(source="swirl")
swirl = thickness.sources_of(material)[0]
found = probe(20, 9)
emission = material.node_tree.nodes.new("ShaderNodeEmission")
output = material.node_tree.nodes.new("ShaderNodeOutputMaterial")
material.node_tree.links.new(swirl.outputs[0], emission.inputs["Strength"])
material.node_tree.links.new(emission.outputs[0], output.inputs["Surface"])
output.is_active_output = True
scene = bpy.context.scene
scene.cycles.samples, scene.cycles.filter_width = 1, 0.01
scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
scene.cycles.shading_system = False
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = str(folder / "swirl.exr")
bpy.ops.render.render(write_still=True)
lit = bpy.data.images.load(scene.render.filepath)
shown = lit.pixels[4 * ((SIZE - 1 - 9) * SIZE + 20)]
assert abs(found["thickness_nm"] - max(shown, 20.0)) < 0.01 * shown, (found, shown)
# Its own output stays the active one.
assert output.is_active_output
material.node_tree.nodes.remove(output)

# A normal that is given, and a debug view that is on.
bpy.ops.nacre.remove_thickness()
given = material.node_tree.nodes.new("ShaderNodeCombineXYZ")
given.inputs[1].default_value, given.inputs[2].default_value = -0.6, 0.8
material.node_tree.links.new(given.outputs[0], materials.input_socket(material, "normal"))
scene.nacre.view = "normal"
found = probe(16, 16)
assert scene.nacre.view == "normal"
np.testing.assert_allclose(found["normal"], [0.0, -0.6, 0.8], atol=1e-6)
wanted = abs(math.degrees(math.atan2(0.6, 0.8)) - TILT_DEG)
assert abs(found["angle_deg"] - wanted) < 1e-3, found["angle_deg"]
scene.nacre.view = "shaded"

# An edited stack, at once, under its own light.
bpy.ops.nacre.edit_stack()
material.nacre.layers[0].medium = "1.7"
material.nacre.illuminant = "A"
found = probe(16, 16)
exact = nacre.template_spectrum(
    recipes.recipe(material).template, found["thickness_nm"], wanted, illuminant="A"
)
np.testing.assert_allclose(found["R"]["spectrum"], exact.reflectance, atol=1e-5)
np.testing.assert_allclose(found["R"]["rgb"], exact.colours[0], atol=1e-5)
assert (found["illuminant"], found["observer"]) == ("A", "cie1931")

# A script in front of the thickness cannot be read back, and that is said.
if form == "osl":
    script = material.node_tree.nodes.new("ShaderNodeScript")
    script.outputs.new(type="NodeSocketFloat", name="nm", identifier="nm")
    material.node_tree.links.new(script.outputs[0], thickness.thickness_socket(material))
    before = snapshot()
    refused(lambda: probe(16, 16), "a script node feeds the thickness")
    assert snapshot() == before
    material.node_tree.nodes.remove(script)

# Nothing there; something else there; no camera.
refused(lambda: probe(99, 0), "must be within 0 0 … 31 31")
scene.camera.data.ortho_scale = 100.0
refused(lambda: probe(0, 0), "there is nothing")
scene.camera.data.ortho_scale = 1.0
obj.data.materials[0] = bpy.data.materials.new("Plain")
refused(lambda: probe(16, 16), "there is no wave material")
scene.camera = None
refused(lambda: probe(16, 16), "the scene has no camera")

# All layers grow and shrink together: the thickness is of all of them.
obj = plane("jewel_beetle")
material = obj.active_material
total = sum(layer.thickness_nm for layer in stack.stack_of(material).layers)
thickness.thickness_socket(material).default_value = 1.05
found = probe(16, 16)
assert abs(found["thickness_nm"] - 1.05 * total) < 1e-3 * total, (found["thickness_nm"], total)
scale = found["thickness_nm"] / total
check_film(found, recipes.recipe(material).template, scale, TILT_DEG)
assert "T" not in found
extension.unregister()
