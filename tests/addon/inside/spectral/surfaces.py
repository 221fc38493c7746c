# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Surfaces and lamps are given measured spectra, of the library and of files, and their colours back."""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file, refused

load().register()
give, marks, groups = module("spectral.give"), module("spectral.marks"), module("spectral.groups")
choices, described = module("spectral.choices"), module("spectral.described")
folder = Path(sys.argv[1])


def only(colours):
    (colour,) = colours
    return colour


cube = new_file()
scene = bpy.context.scene
paint = bpy.data.materials.new("Paint")
paint.use_nodes = True
shader = next(node for node in paint.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
shader.inputs["Base Color"].default_value = (0.4, 0.05, 0.04, 1.0)
cube.data.materials.clear()
cube.data.materials.append(paint)
links = len(paint.node_tree.links)
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
colour = only(give.colours_of(paint))
assert colour.label == "Principled BSDF: Base Color"
assert colour.spectrum == ""

assert module("spectral.outlook").lines()[0] == "24 bands in 8 passes"

# Those that look most like it come first; what it is shows in RGB too.
items = choices._reflectances(
    type("Choice", (), {"material": "Paint", "colour": ""})(), bpy.context
)
assert [item[0] for item in items[:2]] == [choices.ITS_COLOUR, "colorchecker/red"], items[:3]
assert bpy.ops.nacre.give_reflectance(reflectance="colorchecker/red") == {"FINISHED"}
assert only(give.colours_of(paint)).spectrum == "ColorChecker, red"
source = shader.inputs["Base Color"].links[0].from_node
assert described.Described.parse(source.node_tree[marks.SPECTRUM]).kind == "reflectance"

# A file of one spectrum is given at once; of several, all stand first in the lists.
one, two = folder / "one.csv", folder / "two paints.csv"
one.write_text(
    "wavelength_nm,ochre\n" + "".join(f"{nm},{nm / 1000:.3f}\n" for nm in range(380, 781, 20))
)
two.write_text("wavelength_nm,a,b\n" + "".join(f"{nm},0.3,0.6\n" for nm in range(380, 781, 20)))
said = {"material": "Paint", "colour": "Principled BSDF: Base Color"}
assert bpy.ops.nacre.read_spectra(filepath=str(one), **said) == {"FINISHED"}
assert only(give.colours_of(paint)).spectrum == "ochre"
assert bpy.ops.nacre.read_spectra(filepath=str(two), **said) == {"FINISHED"}
assert only(give.colours_of(paint)).spectrum == "ochre"
assert bpy.ops.nacre.give_reflectance(reflectance=f"{two}#b", **said) == {"FINISHED"}
assert only(give.colours_of(paint)).spectrum == "b"
refused(lambda: bpy.ops.nacre.read_spectra(filepath=str(two)), "does not say whether")
refused(lambda: bpy.ops.nacre.read_spectra(filepath=str(folder / "none.csv"), **said), "none.csv")
(folder / "bad.csv").write_text("wavelength_nm,a\n400,0.5\n410,green\n")
refused(lambda: bpy.ops.nacre.read_spectra(filepath=str(folder / "bad.csv"), **said), "bad.csv:3")
refused(lambda: bpy.ops.nacre.give_reflectance(reflectance="colorchecker/red", material="Paint", colour="Coat"),
        "has no colour Coat")  # fmt: skip

# What a light is comes from files as well, and is no reflectance.
lamp = bpy.data.lights.new("Lamp", "SUN")
lamp.color = (1.0, 0.5, 0.25)
scene.collection.objects.link(bpy.data.objects.new("Lamp", lamp))
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
assert bpy.ops.nacre.read_spectra(filepath=str(one), lamp="Lamp") == {"FINISHED"}
assert marks.lit_by(lamp.node_tree) == "ochre"
assert lamp.color[2] < lamp.color[1], tuple(lamp.color)
assert bpy.ops.nacre.give_light(lamp="Lamp", light=choices.ITS_COLOUR) == {"FINISHED"}
assert marks.lit_by(lamp.node_tree) == ""
np.testing.assert_allclose(lamp.color, (1.0, 0.5, 0.25))
scene.world = bpy.data.worlds.new("Sky")
scene.world.use_nodes = True
for light, shown in (("F11", "F11"), (choices.ITS_COLOUR, "")):
    assert bpy.ops.nacre.give_light(lamp="World", light=light) == {"FINISHED"}
    assert marks.lit_by(scene.world.node_tree) == shown

# A metal has n and k at each wavelength, and in RGB by channel.
ring = bpy.data.materials.new("Ring")
ring.use_nodes = True
conductor = ring.node_tree.nodes.new("ShaderNodeBsdfMetallic")
refused(lambda: bpy.ops.nacre.give_metal(material="Ring", metal="Au/Johnson"), "Physical Conductor")
conductor.fresnel_type = "PHYSICAL_CONDUCTOR"
before = [tuple(conductor.inputs[name].default_value) for name in ("IOR", "Extinction")]
offered = [item[0] for item in choices._metals(None, bpy.context)]
assert "Au/Johnson" in offered
assert "SiO2/Malitson" not in offered
assert bpy.ops.nacre.give_metal(material="Ring", metal="Au/Johnson") == {"FINISHED"}
(metal,) = give.metals_of(ring)
assert metal.metal == "Au/Johnson"
n, k = described.Described.of_metal("Au/Johnson")
(red_n, *_), (red_k, *_) = (of.at(np.array(described.RGB_NM)) for of in (n, k))
assert red_n < 0.3
assert red_k > 3.0
for wrong, words in (("SiO2/Malitson", "is no metal"), ("unobtainium", "unobtainium")):
    said_so = ""
    try:
        metal.give(wrong)
    except described.SpectrumError as error:
        said_so = str(error)
    assert words in said_so, said_so
assert metal.metal == "Au/Johnson"
assert bpy.ops.nacre.give_metal(material="Ring", metal=choices.ITS_COLOUR) == {"FINISHED"}
assert give.metals_of(ring)[0].metal == ""
assert bpy.ops.nacre.give_metal(material="Ring", metal="Cu/Johnson") == {"FINISHED"}

# Its colour again, and all as it was.
assert bpy.ops.nacre.give_reflectance(reflectance=choices.ITS_COLOUR, **said) == {"FINISHED"}
again = only(give.colours_of(paint))
assert again.spectrum == ""
assert marks.UPSAMPLING in shader.inputs["Base Color"].links[0].from_node.node_tree
np.testing.assert_allclose(again.rgb, (0.4, 0.05, 0.04, 1.0))
assert bpy.ops.nacre.give_reflectance(reflectance="colorchecker/red") == {"FINISHED"}
assert bpy.ops.nacre.make_rgb() == {"FINISHED"}
assert len(paint.node_tree.links) == links
np.testing.assert_allclose(shader.inputs["Base Color"].default_value, (0.4, 0.05, 0.04, 1.0))
assert [tuple(conductor.inputs[name].default_value) for name in ("IOR", "Extinction")] == before
assert not any(conductor.inputs[name].is_linked for name in ("IOR", "Extinction"))
