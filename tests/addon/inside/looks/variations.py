# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Variations of every shipped material: within limits, the same for the same seed, taken in one step."""

from __future__ import annotations

import sys
import time
from types import SimpleNamespace

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
variations = module("variations.drawn")
drawing = module("variations.drawing")
ball = module("variations.pictures")
materials = module("materials.material")
thickness = module("thickness.nodes")
limits = module("materials.limits")
panel = module("variations.panel")
entries = module("core.library").Library.default().entries()
form = sys.argv[1]


def values(material) -> list:
    nodes = [materials.group_node(material), *thickness.sources_of(material)]
    sockets = (socket for node in nodes for socket in node.inputs)
    return [
        value if isinstance(value, (int, float)) else tuple(value)
        for value in (getattr(socket, "default_value", 0) for socket in sockets)
    ]


class Layout:
    """Stands for a UILayout: keeps the buttons."""

    def __init__(self):
        self.buttons = []

    def _part(self, *_arguments, **_options):
        return self

    row = column = grid_flow = _part

    def operator(self, name, text="", **_options):
        self.buttons.append((name, text))
        return SimpleNamespace()

    def label(self, **_options):
        pass

    def template_icon(self, icon_value, scale):
        pass


def shown() -> list[tuple[str, str]]:
    layout = Layout()
    panel.NACRE_PT_viewport_variations.draw(SimpleNamespace(layout=layout), bpy.context)
    return layout.buttons


cube = new_file()
slowest = 0.0
for key in module("core.looks").variants(entries):
    entry = entries[key.partition(":")[0]]
    bpy.ops.nacre.assign_material(material=key, form=form if form in entry.forms else "osl")
    material = cube.active_material
    knobs = variations.knobs(material)
    assert knobs, key
    before = values(material)
    seen = set()
    for make in (drawing.randomised, drawing.like):
        for seed in range(21):
            state = make(knobs, seed)
            assert state == make(knobs, seed)
            for knob in knobs:
                assert knob.low <= state[knob.name] <= knob.high, (key, knob, state[knob.name])
            variations.take(material, state)
            taken = values(material)
            limits.hold(material)
            assert values(material) == taken, (key, seed)
            seen.add(tuple(state.values()))
    assert len(seen) > 20, (key, seen)
    variations.take(material, drawing.state_of(knobs))
    assert values(material) == before
    if entry.kind == "film":
        assert ball.draw(ball.subject(material, state), 96).shape == (96, 96, 4)
        start = time.perf_counter()
        picture = ball.draw(ball.subject(material, state), 96)
        slowest = max(slowest, time.perf_counter() - start)
        assert 0.0 <= picture.min() <= picture.max() <= 1.0
        assert picture[..., :3].std() > 0.03, key
    else:
        assert ball.subject(material) is None
print(f"slowest picture: {1000.0 * slowest:.1f} ms")

# Drawn, shown, taken in one step, and back.
cube = new_file()
bpy.ops.nacre.assign_material(material="tempered_steel", form=form)
material = cube.active_material
assert [name for name, _ in shown()] == ["nacre.vary_look"] * 2
refused(lambda: bpy.ops.nacre.take_variation(index=1), "Randomise first")
assert bpy.ops.nacre.vary_look(kind="RANDOM", seed=3) == {"FINISHED"}
first = variations.drawn(material).states
assert bpy.ops.nacre.vary_look(kind="RANDOM", seed=3) == {"FINISHED"}
assert variations.drawn(material).states == first
assert [text for _, text in shown()][2:] == ["Back", *map(str, range(1, 8))]
before = values(material)
bpy.ops.ed.undo_push(message="start")
assert bpy.ops.nacre.take_variation("EXEC_DEFAULT", True, index=4) == {"FINISHED"}
assert variations.is_now(material, first[4])
assert values(material) != before
bpy.ops.ed.undo()
material = bpy.context.object.active_material
assert values(material) == before
assert variations.drawn(material) is not None
bpy.ops.nacre.take_variation(index=4)
bpy.ops.nacre.take_variation(index=0)
assert values(material) == before

# More Like This stays near; the sources that there are stay.
bpy.ops.nacre.vary_look(kind="LIKE", seed=1)
for state in variations.drawn(material).states[1:]:
    for name, value in state.items():
        was = first[0][name]
        assert abs(value - was) <= max(0.1201 * abs(was), 15.0)
assert [thickness.spec_of(node).id for node in thickness.sources_of(material)] == ["temperature"]

# What links or drivers give is left to them; other inputs than were drawn: nothing is shown any more.
bpy.ops.nacre.remove_thickness()
assert variations.drawn(material) is None
names = [knob.name for knob in variations.knobs(material)]
assert names == ["roughness", "thickness_nm"]
materials.input_socket(material, "roughness").driver_add("default_value")
thickness.thickness_socket(material).keyframe_insert("default_value")
assert variations.knobs(material) == []
refused(bpy.ops.nacre.vary_look, "nothing to vary")
assert shown() == []

# Of gratings and glass, in words.
bpy.ops.nacre.assign_material(material="cd", form="osl")
bpy.ops.nacre.vary_look(kind="LIKE", seed=5)
assert any("strength" in text and "roughness" in text for _, text in shown())
extension.unregister()
