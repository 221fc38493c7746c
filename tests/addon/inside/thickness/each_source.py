# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Sources of a thickness: made, chained, taken away, driven, and what they compute."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.measured import camera_over_cube, close, measure, measure_all
from jobs.steps import new_file, refused

extension = load()
extension.register()
materials = module("materials.material")
thickness = module("thickness.nodes")
SOURCES = module("thickness.sources").SOURCES
folder = Path(sys.argv[1])


cube = camera_over_cube()
scene = bpy.context.scene
refused(lambda: bpy.ops.nacre.add_thickness(source="drop"), "no thickness")
bpy.ops.nacre.assign_material(material="test_film", form="nodes")
material = cube.active_material
socket = thickness.thickness_socket(material)
span = thickness.thickness_range(socket)
assert span == (0.0, 1200.0)

# Each group is made once; names and ranges.
for source in SOURCES:
    assert bpy.ops.nacre.add_thickness(source=source.id) == {"FINISHED"}
    assert bpy.ops.nacre.add_thickness(source=source.id) == {"FINISHED"}
    node, under = thickness.sources_of(material)
    assert node.node_tree == under.node_tree
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
for modifier in list(cube.modifiers):
    cube.modifiers.remove(modifier)

# The parabola of a drop.
bpy.ops.nacre.add_thickness(source="drop")
drop = thickness.sources_of(material)[0]
given = {"Base": 100.0, "Height": 300.0, "Centre": (0.0, 0.0, 0.0), "Radius": 2.0}
assert close(measure(drop, given), 400.0)
assert close(measure(drop, {**given, "Strength": 0.5}), 250.0)
assert close(measure(drop, {**given, "Strength": 1.0, "On": False}), 100.0)
drop.inputs["On"].default_value = True
assert close(measure(drop, given, (1.0, 0.0, 0.0)), 100.0 + 300.0 * 0.75)
assert close(measure(drop, given, (0.0, 3.0, 0.0)), 100.0)

# Drainage: a root of the depth, 1/√t, black at the top with an edge.
bpy.ops.nacre.remove_thickness()
bpy.ops.nacre.add_thickness(source="drainage")
drainage = thickness.sources_of(material)[0]
given = {"Bottom": 900.0, "Time": 1.0, "Black Film": 0.1, "Black Thickness": 8.0}
assert close(measure(drainage, given, (0.0, 0.0, 0.0)), 900.0)
assert close(measure(drainage, given, (0.0, 0.0, 0.75)), 900.0 * math.sqrt(0.25))
assert close(measure(drainage, given, (0.0, 0.0, 0.95)), 8.0)
assert close(measure(drainage, {**given, "Time": 4.0}, (0.0, 0.0, 0.0)), 450.0)

# A value from 0 to 1 is held to its range; an attribute in nm is taken as it is.
bpy.ops.nacre.remove_thickness()
bpy.ops.nacre.add_thickness(source="map")
mapped = thickness.sources_of(material)[0]
material.node_tree.links.remove(mapped.inputs["Value"].links[0])
for value, wanted in ((0.25, 250.0), (-1.0, 200.0), (2.0, 400.0)):
    given = {"Value": value, "Minimum": 200.0, "Maximum": 400.0}
    assert close(measure(mapped, given), wanted), value

# Swirl goes upon what is there; the same time gives the same film, another time another.
bpy.ops.nacre.remove_thickness()
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
bpy.ops.nacre.remove_thickness()
bpy.ops.nacre.add_thickness(source="map")
bpy.ops.nacre.add_thickness(source="spread")
spread, below = thickness.sources_of(material)
assert below.node_tree[thickness.SOURCE] == "map"
material.node_tree.links.remove(below.inputs["Value"].links[0])
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
bpy.ops.nacre.remove_thickness()
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
bpy.ops.nacre.remove_thickness()
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
bpy.ops.nacre.remove_thickness()
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
bpy.ops.nacre.remove_thickness()
assert bpy.ops.nacre.add_thickness(source="map", filepath=picture.filepath_raw) == {"FINISHED"}
image = thickness.sources_of(material)[0].inputs["Value"].links[0].from_node.image
assert image.colorspace_settings.is_data
nodes = len(material.node_tree.nodes)
refused(
    lambda: bpy.ops.nacre.add_thickness(source="map", filepath=str(folder / "none.png")), "none.png"
)
assert len(material.node_tree.nodes) == nodes

# Dropped onto a panel, a picture makes its source, or takes the place of the one that is there.
bpy.ops.nacre.remove_thickness()
drops = [c for c in module("registration").classes() if issubclass(c, bpy.types.FileHandler)]
assert len(drops) == 2
for drop in drops:
    kind = getattr(bpy.ops.nacre, drop.bl_import_operator.partition(".")[2]).get_rna_type()
    assert kind.properties["filepath"].is_skip_save
    assert not drop.poll_drop(bpy.context)  # there is no panel
for _ in range(2):
    dropped = bpy.ops.nacre.open_thickness_image("INVOKE_DEFAULT", filepath=picture.filepath_raw)
    assert dropped == {"FINISHED"}
    assert thickness.image_node(*thickness.sources_of(material)).image == image
refused(
    lambda: bpy.ops.nacre.open_thickness_image("INVOKE_DEFAULT", filepath=str(folder / "none.png")),
    "none.png",
)

# Switching the form keeps what feeds the thickness.
assert bpy.ops.nacre.rebuild_material(form="osl") == {"FINISHED"}
assert len(thickness.sources_of(material)) == 1


# ---- The newer sources, at places where the answer is known.


def alone(source: str):
    bpy.ops.nacre.remove_thickness()
    assert bpy.ops.nacre.add_thickness(source=source) == {"FINISHED"}
    return thickness.sources_of(material)[0]


bpy.ops.nacre.rebuild_material(form="nodes")
given = {"Near": 100.0, "Far": 500.0, "Start": (0, 0, 0), "Axes": (1, 0, 0), "Reach": 2.0}
gradient = alone("gradient")
for x, wanted in ((0.0, 100.0), (0.5, 200.0), (2.0, 500.0), (7.0, 500.0), (-1.0, 300.0)):
    assert close(measure(gradient, given, (x, 3.0, -4.0)), wanted), x
assert close(measure(gradient, {"Axes": (1, 1, 1)}, (0.8, 0.0, 0.6)), 300.0)
height = alone("height")
given = {"Near": 100.0, "Far": 500.0, "Bottom": -1.0, "Top": 3.0}
for z, wanted in ((-2.0, 100.0), (1.0, 300.0), (4.0, 500.0)):
    assert close(measure(height, given, (9.0, 9.0, z)), wanted), z

# Heat: as a fin it falls to 1/e within the reach; oxide grows by Arrhenius. The workshop's colours of
# carbon steel are those of magnetite of 10, 20, 30, 38 and 48 nm at 220, 243, 265, 277 and 293 °C.
heated = alone("temperature")
given = {"Coldest": 20.0, "Start": (0, 0, 0), "Axes": (1, 0, 0), "Reach": 1.0, "At": 258.0}
given |= {"Grown": 25.6, "Growth": heated.inputs["Growth"].default_value}
for celsius, nm in ((220.0, 10.0), (243.0, 20.0), (265.0, 30.0), (277.0, 38.0), (293.0, 48.0)):
    grown = measure(heated, {**given, "Hottest": celsius}, (0.0, 5.0, 5.0))
    assert abs(grown - nm) < 3.0, (celsius, grown)
fallen = 20.0 + 280.0 * math.exp(-0.1)
wanted = 25.6 * math.exp(5800.0 * (1.0 / 531.15 - 1.0 / (fallen + 273.15)))
assert close(measure(heated, {**given, "Hottest": 300.0}, (0.1, 0.0, 0.0)), wanted)

# Clouds reach from the minimum to the maximum, and no further.
noise = alone("noise")
clouds = [
    measure(noise, {"Minimum": 100.0, "Maximum": 500.0}, (i * 0.37, i * 0.71, 0.2))
    for i in range(12)
]
assert min(clouds) >= 100.0 - 1e-3
assert max(clouds) <= 500.0 + 1e-3
assert max(clouds) - min(clouds) > 150.0, clouds

# ---- A stack: what lies below is seen through, and stays when one is taken out or moved.
bpy.ops.nacre.remove_thickness()
for source in ("gradient", "drop", "height"):
    bpy.ops.nacre.add_thickness(source=source)
height, drop, gradient = thickness.sources_of(material)
gradient.inputs["Near"].default_value = gradient.inputs["Far"].default_value = 300.0
height.inputs["Near"].default_value = height.inputs["Far"].default_value = 700.0
drop_given = {"Centre": (0.0, 0.0, 0.0), "Height": 200.0, "Radius": 1.0}
assert close(measure(drop, drop_given), 500.0)
for strength, wanted in ((1.0, 700.0), (0.25, 550.0), (0.0, 500.0)):
    assert close(measure(height, {"Strength": strength}), wanted)
assert close(measure(height, {"Strength": 1.0, "On": False}), 500.0)
height.inputs["On"].default_value = True
assert bpy.ops.nacre.move_thickness_source(index=0, direction="DOWN") == {"FINISHED"}
assert [node.label for node in thickness.sources_of(material)] == [
    "Drop",
    "Gradient by Height",
    "Gradient over the Object",
]
assert close(measure(drop, drop_given), 900.0)  # upon the height now
assert bpy.ops.nacre.move_thickness_source(index=0, direction="UP") == {"CANCELLED"}
assert bpy.ops.nacre.move_thickness_source(index=2, direction="DOWN") == {"CANCELLED"}
assert bpy.ops.nacre.remove_thickness_source(index=1) == {"FINISHED"}
assert thickness.sources_of(material) == [drop, gradient]
assert close(measure(drop, drop_given), 500.0)
assert close(gradient.inputs["Near"].default_value, 300.0)
refused(lambda: bpy.ops.nacre.remove_thickness_source(index=7), "no source 7")

# What an artist's own nodes feed stays below all.
bpy.ops.nacre.remove_thickness()
own = material.node_tree.nodes.new("ShaderNodeValue")
own.outputs[0].default_value = 222.0
material.node_tree.links.new(own.outputs[0], thickness.thickness_socket(material))
bpy.ops.nacre.add_thickness(source="drop")
bpy.ops.nacre.add_thickness(source="gradient")
gradient = thickness.sources_of(material)[0]
drop = thickness.sources_of(material)[1]
assert drop.inputs["Base"].links[0].from_node == own
bpy.ops.nacre.remove_thickness()
assert thickness.thickness_socket(material).links[0].from_node == own
material.node_tree.nodes.remove(own)

# ---- What follows an object: an empty, a curve.
bpy.ops.nacre.add_thickness(source="distance")
point = thickness.feed_of(thickness.sources_of(material)[0], "TEX_COORD", "Vector").object
assert point.name.startswith("Film Point")
bpy.ops.nacre.remove_thickness()
bpy.ops.nacre.add_thickness(source="heat_curve")
heat = module("thickness.heat")
holder, path = heat.curve_property(heat.modifier_of(cube))
curve = holder.path_resolve(path)
assert curve.name.startswith("Heat Curve")
curve.location = (0.0, 0.0, 3.0)
bpy.context.view_layer.update()
mesh = cube.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
away = [tuple(item.vector) for item in mesh.attributes[heat.ATTRIBUTE].data]
for vertex, vector in zip(mesh.vertices, away, strict=True):
    reached = min(max(vertex.co.x, -curve.scale.x), curve.scale.x)
    wanted = (vertex.co.x - reached, vertex.co.y, vertex.co.z - 3.0)
    assert all(close(a, b) for a, b in zip(vector, wanted, strict=True)), (vector, wanted)
bpy.ops.nacre.remove_thickness()

# ---- Painting: the brush carries the value, the layer is the active one.
bpy.ops.nacre.add_thickness(source="attribute")
assert bpy.ops.nacre.paint_thickness(index=0, value=0.25) == {"FINISHED"}
assert cube.mode == "VERTEX_PAINT"
settings = bpy.context.tool_settings
brush = settings.vertex_paint.brush
is_srgb = brush.bl_rna.properties["color"].subtype == "COLOR_GAMMA"
assert close(brush.color[0], 0.5371 if is_srgb else 0.25), tuple(brush.color)
bpy.ops.object.mode_set(mode="OBJECT")
painted = thickness.sources_of(material)[0]
thickness.feed_of(painted, "ATTRIBUTE").attribute_name = "position"
refused(lambda: bpy.ops.nacre.paint_thickness(index=0), "is no colour")
bpy.ops.nacre.remove_thickness()
refused(lambda: bpy.ops.nacre.paint_thickness(index=0), "does not vary")

# ---- A value outside the limits that is typed is held to them, of the film and of its sources.
socket = thickness.thickness_socket(material)
for typed, held in ((-5.0, 0.0), (1e5, 1200.0), (math.nan, None), (640.0, 640.0)):
    socket.default_value = typed
    bpy.context.view_layer.update()
    now = socket.default_value
    assert now == held if held is not None else 0.0 <= now <= 1200.0, (typed, now)
    # And it is said, until the value is one of those between.
    said = module("materials.limits").held(material)
    assert bool(said) == (typed != 640.0), said
bpy.ops.nacre.add_thickness(source="drop")
drop = thickness.sources_of(material)[0]
drop.inputs["Base"].default_value = -3.0
drop.inputs["Strength"].default_value = 4.0
bpy.context.view_layer.update()
assert drop.inputs["Base"].default_value == 0.0
assert drop.inputs["Strength"].default_value == 1.0
bpy.ops.nacre.remove_thickness()
assert bpy.ops.nacre.set_thickness(thickness=5000.0) == {"FINISHED"}
assert thickness.thickness_socket(material).default_value == 1200.0


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
    ("temperature", "height", "noise"),
    ("heat_curve", "distance", "edge"),
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
