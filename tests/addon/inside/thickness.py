# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Sources of a thickness: made, chained, taken away, driven, and what they compute."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy
from steps import new_file, refused

from jobs.extension import load, module

extension = load()
extension.register()
materials = module("nodes.material")
thickness = module("nodes.thickness")
SOURCES = module("core.thickness").SOURCES
folder = Path(sys.argv[1])


def close(a: float, b: float, tolerance: float = 1e-3) -> bool:
    return abs(a - b) <= tolerance * max(1.0, abs(b))


def measure(node, values: dict, at=(0.0, 0.0, 0.0)) -> float:
    """What a source gives at a place."""
    return measure_all(node, values, 4, at)[0]


def measure_all(node, values: dict, size: int, at=(0.0, 0.0, 0.0)) -> list[float]:
    """What a source gives at each pixel of a square: rendered as emission, one sample each."""
    for name, value in values.items():
        node.inputs[name].default_value = value
    tree = node.id_data
    for name in ("probe", "probe out", "probe at"):
        if name in tree.nodes:
            tree.nodes.remove(tree.nodes[name])
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.name = "probe"
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.name = "probe out"
    output.is_active_output = True
    tree.links.new(node.outputs[0], emission.inputs["Strength"])
    tree.links.new(emission.outputs[0], output.inputs["Surface"])
    if "Vector" in node.inputs:
        place = tree.nodes.new("ShaderNodeCombineXYZ")
        place.name = "probe at"
        for socket, value in zip(place.inputs, at, strict=True):
            socket.default_value = value
        tree.links.new(place.outputs[0], node.inputs["Vector"])
    scene = bpy.context.scene
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.shading_system = False
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(folder / "probe.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath, check_existing=False)
    reds = list(image.pixels[:])[::4]
    bpy.data.images.remove(image)
    return reds


cube = new_file()
scene = bpy.context.scene
scene.render.engine = "CYCLES"
camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
camera.location.z = 5.0
camera.data.type = "ORTHO"
camera.data.ortho_scale = 1.0
scene.collection.objects.link(camera)
scene.camera = camera
refused(lambda: bpy.ops.nacre.add_thickness(source="drop"), "no thickness")
bpy.ops.nacre.assign_material(material="test_film", form="nodes")
material = cube.active_material
socket = thickness.thickness_socket(material)
span = thickness.thickness_range(socket)
assert span == (0.0, 1200.0)

# Each source is made once and replaces the one before; names and ranges.
for source in SOURCES:
    assert bpy.ops.nacre.add_thickness(source=source.id) == {"FINISHED"}
    assert bpy.ops.nacre.add_thickness(source=source.id) == {"FINISHED"}
    node = thickness.sources_of(material)[0]
    assert node.node_tree[thickness.SOURCE] == source.id
    for item in source.inputs:
        assert item.name in node.inputs
        if item.is_thickness:
            assert span[0] <= node.inputs[item.name].default_value <= span[1]
    count = sum(1 for group in bpy.data.node_groups if thickness.SOURCE in group)
    assert count == 1 + SOURCES.index(source), count
    bpy.ops.nacre.remove_thickness()
    assert thickness.sources_of(material) == []
    assert not socket.is_linked
assert {node.type for node in material.node_tree.nodes} == {"OUTPUT_MATERIAL", "GROUP"}

# The parabola of a drop.
bpy.ops.nacre.add_thickness(source="drop")
drop = thickness.sources_of(material)[0]
given = {"Base": 100.0, "Height": 300.0, "Centre": (0.0, 0.0, 0.0), "Radius": 2.0}
assert close(measure(drop, given), 400.0)
assert close(measure(drop, given, (1.0, 0.0, 0.0)), 100.0 + 300.0 * 0.75)
assert close(measure(drop, given, (0.0, 3.0, 0.0)), 100.0)

# Drainage: a root of the depth, 1/√t, black at the top with an edge.
bpy.ops.nacre.add_thickness(source="drainage")
drainage = thickness.sources_of(material)[0]
given = {"Bottom": 900.0, "Time": 1.0, "Black Film": 0.1, "Black Thickness": 8.0}
assert close(measure(drainage, given, (0.0, 0.0, 0.0)), 900.0)
assert close(measure(drainage, given, (0.0, 0.0, 0.75)), 900.0 * math.sqrt(0.25))
assert close(measure(drainage, given, (0.0, 0.0, 0.95)), 8.0)
assert close(measure(drainage, {**given, "Time": 4.0}, (0.0, 0.0, 0.0)), 450.0)

# A value from 0 to 1 is held to its range; an attribute in nm is taken as it is.
bpy.ops.nacre.add_thickness(source="map")
mapped = thickness.sources_of(material)[0]
for value, wanted in ((0.25, 250.0), (-1.0, 200.0), (2.0, 400.0)):
    given = {"Value": value, "Minimum": 200.0, "Maximum": 400.0}
    assert close(measure(mapped, given), wanted), value

# Swirl goes upon what is there; the same time gives the same film, another time another.
bpy.ops.nacre.add_thickness(source="drop")
bpy.ops.nacre.add_thickness(source="swirl")
swirl, below = thickness.sources_of(material)
assert below.node_tree[thickness.SOURCE] == "drop"
place = (0.3, -0.2, 0.7)
first = measure(swirl, {"Time": 1.7, "Amount": 0.5}, place)
other = measure(swirl, {"Time": 2.9}, place)
again = measure(swirl, {"Time": 1.7}, place)
assert first == again
assert not close(first, other)
# It moves without a jump, also where one copy of the noise begins anew (every 2 s).
before, after = (measure(swirl, {"Time": t}, place) for t in (1.9995, 2.0005))
assert close(before, after, 0.02), (before, after)

# Spread: samples of one Gaussian, whose mean and deviation are those that were asked for.
bpy.ops.nacre.add_thickness(source="map")
bpy.ops.nacre.add_thickness(source="spread")
spread, below = thickness.sources_of(material)
assert below.node_tree[thickness.SOURCE] == "map"
plane = bpy.data.objects.new("Plane", bpy.data.meshes.new("Plane"))
plane.data.from_pydata([(-1, -1, 2), (1, -1, 2), (1, 1, 2), (-1, 1, 2)], [], [(0, 1, 2, 3)])
plane.data.materials.append(material)
scene.collection.objects.link(plane)
given = {"Value": 0.5, "Minimum": 400.0, "Maximum": 600.0}
for name, value in given.items():
    below.inputs[name].default_value = value
deviates = [value - 500.0 for value in measure_all(spread, {"Spread": 30.0}, 64)]
count = len(deviates)
deviation = math.sqrt(sum(value * value for value in deviates) / count)
assert abs(sum(deviates) / count) < 4 * 30.0 / math.sqrt(count)
assert close(deviation, 30.0, 4 / math.sqrt(2 * count)), deviation
beyond = sum(abs(value) > 60.0 for value in deviates) / count  # erfc(√2) = 0.0455
assert abs(beyond - 0.0455) < 4 * math.sqrt(0.0455 / count), beyond
bpy.data.objects.remove(plane)
bpy.ops.nacre.add_thickness(source="drop")
bpy.ops.nacre.add_thickness(source="swirl")
swirl = thickness.sources_of(material)[0]

# Driven by the frames.
assert bpy.ops.nacre.animate_thickness() == {"FINISHED"}
scene.render.fps = 24
scene.frame_set(48)
evaluated = material.evaluated_get(bpy.context.evaluated_depsgraph_get())
timed = evaluated.node_tree.nodes[swirl.name].inputs["Time"].default_value
assert close(timed, 2.0), timed

# Painting: an attribute is made, becomes active, and feeds the film.
bpy.ops.nacre.add_thickness(source="attribute")
assert cube.data.color_attributes.active_color.name == "Film Thickness"
painted = thickness.sources_of(material)[0]
ramp = thickness.ramp_of(painted)
assert painted.inputs["Value"].links[0].from_node == ramp
assert ramp.inputs["Fac"].links[0].from_node.attribute_name == "Film Thickness"
assert [(e.position, tuple(e.color)[:3]) for e in ramp.color_ramp.elements] == [
    (0.0, (0.0, 0.0, 0.0)),
    (1.0, (1.0, 1.0, 1.0)),
]
bpy.ops.nacre.add_thickness(source="attribute_nm", attribute="nm")
held = thickness.sources_of(material)[0]
assert thickness.ramp_of(held) is None
assert not any(node.type == "VALTORGB" for node in material.node_tree.nodes)
assert held.inputs["Value"].links[0].from_node.attribute_name == "nm"

# A picture; one that is missing changes nothing.
picture = bpy.data.images.new("map", 4, 4)
picture.filepath_raw = str(folder / "Dicke é.png")
picture.file_format = "PNG"
picture.save()
assert bpy.ops.nacre.add_thickness(source="map", filepath=picture.filepath_raw) == {"FINISHED"}
image = thickness.sources_of(material)[0].inputs["Value"].links[0].from_node.image
assert image.colorspace_settings.is_data
nodes = len(material.node_tree.nodes)
refused(
    lambda: bpy.ops.nacre.add_thickness(source="map", filepath=str(folder / "none.png")), "none.png"
)
assert len(material.node_tree.nodes) == nodes

# Switching the form keeps what feeds the thickness.
assert bpy.ops.nacre.rebuild_material(form="osl") == {"FINISHED"}
assert len(thickness.sources_of(material)) == 1


# ---- Where nodes lie: from left to right, none upon another, and a word about what had to go.


def box(node) -> tuple[float, float, float, float]:
    """Left, right, bottom, top: nothing has a height before it is drawn."""
    rows = len([socket for socket in node.inputs if not socket.hide_value])
    height = 300.0 if node.type in ("TEX_IMAGE", "VALTORGB", "TEX_COORD") else 80.0 + 24.0 * rows
    x, y = node.location
    return x, x + node.width, y - height, y


def check_layout(material) -> None:
    tree = material.node_tree
    for link in tree.links:
        left, right = box(link.from_node), box(link.to_node)
        assert left[1] <= right[0] + 1.0, (link.from_node.name, link.to_node.name)
    boxes = [(node.name, box(node)) for node in tree.nodes]
    for index, (name, a) in enumerate(boxes):
        for other, b in boxes[index + 1 :]:
            apart = a[1] <= b[0] or b[1] <= a[0] or a[3] <= b[2] or b[3] <= a[2]
            assert apart, (name, a, other, b)


picture = bpy.data.images.new("Thickness", 8, 8)
picture.filepath_raw = str(folder / "thickness.png")
picture.file_format = "PNG"
picture.save()
for sources in (
    ("drainage", "swirl"),
    ("map", "swirl", "spread"),
    ("attribute", "swirl"),
    ("drop", "spread", "swirl"),
):
    cube = new_file()
    bpy.ops.nacre.assign_material(material="test_film", form="nodes")
    material = cube.active_material
    for name in sources:
        options = {"filepath": str(folder / "thickness.png")} if name == "map" else {}
        assert bpy.ops.nacre.add_thickness(source=name, **options) == {"FINISHED"}
        check_layout(material)
    assert len(thickness.sources_of(material)) == len(sources)

extension.unregister()
