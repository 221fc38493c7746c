# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A film that was compiled for another light is edited for that light, whether menus have it or not."""

from __future__ import annotations

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

extension = load()
extension.register()

import nacre  # noqa: E402  the extension knows where it is

materials = module("materials.material")
stack = module("films.edited")
recipes = module("materials.recipe")
light = module("core.light")
panel = module("films.panel")

LAMP = light.Conditions("lamp/hps", "cie1964", "none")


def texels(material):
    """Row 0 at the least thickness, as in tables; Blender's is the lowest."""
    nodes = materials.group_node(material).node_tree.nodes
    (image,) = {n.image for n in nodes if n.type == "TEX_IMAGE" and n.image["nacre_table"] == "R"}
    values = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)[::-1, :, :3].copy()


def expected(material, conditions):
    text = recipes.recipe(material).template
    return nacre.compile_template(text, **conditions._asdict()).tables["R"]


def is_alike(material, conditions) -> bool:
    """What is packed has 13 bits."""
    wanted, found = expected(material, conditions), texels(material)
    return wanted.shape == found.shape and np.allclose(wanted, found, rtol=2e-4, atol=1e-5)


cube = new_file()
bpy.context.scene.render.engine = "CYCLES"
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
material = cube.active_material
assert recipes.recipe(material).conditions == LAMP
as_compiled = texels(material)
# Sodium light is orange: it is in the tables.
assert as_compiled[..., 0].mean() > 3.0 * as_compiled[..., 2].mean()
assert is_alike(material, LAMP)
assert not is_alike(material, light.USUAL)

assert bpy.ops.nacre.edit_stack() == {"FINISHED"}
assert material.nacre.illuminant == light.AS_COMPILED
assert material.nacre.observer == "cie1964"
assert recipes.recipe(material).conditions == LAMP
assert not stack.is_stale(material)
assert panel._unusual_light(LAMP) == "lamp/hps, its colour is in the tables"
assert panel._unusual_light(light.USUAL) == ""

# An edit of a layer is of that layer alone.
material.nacre.layers[0].medium = "abbe 1.6 40"
assert recipes.recipe(material).conditions == LAMP
stack.finish(material)
assert is_alike(material, LAMP)
assert recipes.recipe(material).conditions == LAMP

# Another light is chosen; whose colour is in the tables stays as it is.
material.nacre.illuminant = "A"
assert recipes.recipe(material).conditions == LAMP._replace(illuminant="A")
stack.finish(material)
assert is_alike(material, LAMP._replace(illuminant="A"))
# What it was compiled for before is gone but for Revert.
material.nacre.illuminant = light.AS_COMPILED
assert material.nacre.illuminant == "A"
assert recipes.recipe(material).conditions == LAMP._replace(illuminant="A")

# Back to the library's.
assert bpy.ops.nacre.revert_stack() == {"FINISHED"}
assert not [name for name in recipes.CONDITIONS if name in material]
assert recipes.recipe(material).conditions == LAMP
assert np.array_equal(texels(material), as_compiled)

# A damaged note of the light is that of none.
for damage in (7, "[", '["D65"]', '["D65", "cie1931", 3]', '["D65", "cie2050", "none"]'):
    materials.group_node(material).node_tree["nacre_conditions"] = damage
    assert recipes.recipe(material).conditions == light.USUAL, damage
