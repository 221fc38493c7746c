# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Sources of a thickness upon others: what is seen of them, heat upon heat, what they lie around, and how
balls show them."""

from __future__ import annotations

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.measured import camera_over_cube, close, measure

extension = load()
extension.register()
thickness = module("thickness.nodes")
SOURCES = module("thickness.sources").SOURCES
cube = camera_over_cube()
bpy.ops.nacre.assign_material(material="test_film", form="nodes")
material = cube.active_material


def alone(source: str):
    bpy.ops.nacre.remove_thickness()
    assert bpy.ops.nacre.add_thickness(source=source) == {"FINISHED"}
    return thickness.sources_of(material)[0]


# What is added leaves in sight what is there, and says so where it does not.
for added, strength in (("noise", 0.5), ("edge", 0.5), ("attribute", 1.0), ("swirl", 1.0)):
    bpy.ops.nacre.remove_thickness()
    bpy.ops.nacre.add_thickness(source="gradient")
    lowest = thickness.sources_of(material)[0]
    assert lowest.inputs["Strength"].default_value == 1.0
    bpy.ops.nacre.add_thickness(source=added)
    upper = thickness.sources_of(material)[0]
    assert upper.inputs["Strength"].default_value == strength, added
    covers = added == "attribute"
    assert thickness.covered([upper, lowest]) == ({1} if covers else set()), added
bpy.ops.nacre.remove_thickness()
for name in ("gradient", "drop", "noise"):
    bpy.ops.nacre.add_thickness(source=name)
nodes = thickness.sources_of(material)
nodes[0].inputs["Strength"].default_value = 1.0
assert thickness.covered(nodes) == {1, 2}
nodes[0].inputs["On"].default_value = False
assert thickness.covered(nodes) == set()

# Heat upon heat: of one heating after another the squares of the oxide add up.
bpy.ops.nacre.remove_thickness()
bpy.ops.nacre.add_thickness(source="temperature")
bpy.ops.nacre.add_thickness(source="heat_point")
torch, end = thickness.sources_of(material)
# The panel's material stays in view while the empty is moved.
subject = module("materials.subject")
bpy.context.view_layer.objects.active = thickness.followed(torch)
assert subject.subject(bpy.context) == cube
assert subject.active_material(bpy.context) == material
bpy.context.view_layer.objects.active = cube
assert torch.inputs["Grows Upon Below"].default_value
assert not end.inputs["Grows Upon Below"].default_value
assert thickness.covered([torch, end]) == set()
hot = {"Hottest": 280.0, "Coldest": 280.0, "Grown": 30.0, "At": 280.0}
for name, value in hot.items():
    end.inputs[name].default_value = value
assert close(measure(torch, {**hot, "Grown": 40.0}), 50.0)
assert close(measure(torch, {"Grows Upon Below": False}), 40.0)
torch.inputs["Grows Upon Below"].default_value = True
assert bpy.ops.nacre.remove_thickness_source(index=1) == {"FINISHED"}
assert close(measure(torch, {}), 40.0)  # there is nothing left to grow upon

# What was made for the heat goes with it; an empty of the artist's own does not.
bpy.ops.nacre.remove_thickness()
bpy.ops.nacre.add_thickness(source="heat_point")
own_point = bpy.data.objects.new("Torch", None)
bpy.context.collection.objects.link(own_point)
torch = thickness.sources_of(material)[0]
made = thickness.followed(torch).name
thickness.feed_of(torch, "TEX_COORD", "Vector").object = own_point
bpy.ops.nacre.remove_thickness()
assert made not in bpy.data.objects
assert "Torch" in bpy.data.objects
bpy.data.objects.remove(own_point)
bpy.context.view_layer.objects.active = cube
bpy.ops.nacre.add_thickness(source="heat_curve")
curve = module("thickness.heat").curve_of(cube)
bpy.context.view_layer.objects.active = curve
assert subject.subject(bpy.context) == cube
bpy.context.view_layer.objects.active = cube
bpy.ops.nacre.remove_thickness()
assert not cube.modifiers
assert not [obj for obj in bpy.data.objects if obj.type in ("EMPTY", "CURVE")]
assert not bpy.data.curves

# On the balls of variations sources lie as their nodes do.
fields = module("variations.ball_fields")
specs = {item.id: item for item in SOURCES}
for name in ("gradient", "temperature", "drainage", "height"):
    node = alone(name)
    values = {
        socket.name: tuple(socket.default_value)
        if socket.type == "VECTOR"
        else socket.default_value
        for socket in node.inputs
    }
    for normal in ((0.36, 0.48, 0.8), (-0.6, 0.64, 0.48), (0.48, -0.6, 0.64)):
        x, z, y = normal[0], normal[1], -normal[2]
        at = (x, y, z) if name == "height" else [(part + 1.0) / 2.0 for part in (x, y, z)]
        drawn = fields.thickness([(specs[name], values)], 0.0, np.array(normal))
        assert close(measure(node, {}, at), float(drawn), 2e-3), (name, normal)

extension.unregister()
