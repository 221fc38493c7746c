# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What paths draw, on average, is the sum over bands; what cannot be set up leaves nodes as they were."""

from __future__ import annotations

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

load().register()
plans, described = module("spectral.plan"), module("spectral.described")
paths, drawn = module("spectral.paths.nodes"), module("spectral.paths.draws")

SODIUM = "line:589.0@2,589.6@1"
LIGHTS = ("D65", "F11", "lamp/hps", SODIUM)
for names, triples in ((LIGHTS, 8), (LIGHTS, 100), ((SODIUM,), 8)):
    lights = [described.Described.named(name) for name in names]
    spectra = {light.attribute: light for light in lights}
    plan = plans.make(spectra, triples)
    draws = drawn.draws(plan)
    rows = draws.rows()
    for name in spectra:
        radiance = plan.values[name] / plan.white
        np.testing.assert_allclose(rows[name].mean(0), plan.bands.xyz(radiance), rtol=2e-3)
        half = np.where(plan.bands.wavelength_nm < 560.0, 0.2, 0.8)
        seen = (rows[name] * half[draws.bands]).mean(0)
        np.testing.assert_allclose(seen, plan.bands.xyz(radiance * half), rtol=5e-3, atol=1e-4)
    live = rows["nacre_live"]
    assert (live.sum(1) == 3.0).all()
    np.testing.assert_allclose(live.mean(0), 1.0)

# An error on the way puts back what was changed already.
new_file()
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
world = bpy.context.scene.world = bpy.data.worlds.new("Sky")
world.use_nodes = True
assert bpy.ops.nacre.make_spectral() == {"FINISHED"}
assert bpy.ops.nacre.give_light(lamp="World", light="D65") == {"FINISHED"}


def links() -> list[tuple]:
    return sorted(
        (group.name, link.from_node.name, link.to_node.name, link.to_socket.name)
        for group in bpy.data.node_groups
        for link in group.links
    )


before, images = links(), {image.name for image in bpy.data.images}
fill, paths.fill_with_source = paths.fill_with_source, lambda *_: 1 / 0
plan = plans.make(module("spectral.groups").found_spectra(), 8)
try:
    with paths.in_place(bpy.context.scene, drawn.draws(plan)):
        raise AssertionError
except ZeroDivisionError:
    pass
paths.fill_with_source = fill
assert links() == before
assert {image.name for image in bpy.data.images} == images
with paths.in_place(bpy.context.scene, drawn.draws(plan)):
    assert links() != before
assert links() == before
