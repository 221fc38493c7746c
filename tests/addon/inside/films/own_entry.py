# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""An entry of the user's own library that is edited while Blender runs: its name and the panel's pictures
are those of what is in the file, whatever its size and time."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import bpy
import numpy as np

from jobs.extension import load, module
from jobs.steps import new_file

os.environ["XDG_DATA_HOME"] = sys.argv[1]
entry = Path(sys.argv[1], "nacre", "optical_constants", "user", "film.yml")
entry.parent.mkdir(parents=True)

extension = load()
extension.register()
stack, swatch = module("films.edited"), module("films.swatch")
icons = module("blender.icons")


def write(name: str, n: float) -> None:
    text = f"NAMES: [{name}]\nDATA:\n  - type: tabulated n\n    data: |\n      0.3 {n}\n      0.9 {n}\n"
    entry.write_text(text, "utf-8")
    os.utime(entry, (1e9, 1e9))


def pictures(material) -> list[np.ndarray]:
    """Swatch and spectrum, as the panel shows them."""
    swatch.swatch(material)
    swatch.spectrum(material, 120.0, 0.0)
    found = []
    for icon in icons._collections[0].values():
        texels = np.empty(4 * icon.image_size[0] * icon.image_size[1], np.float32)
        icon.image_pixels_float.foreach_get(texels)
        found.append(texels)
    return found


write("Old", 1.4)
cube = new_file()
bpy.context.scene.render.engine = "CYCLES"
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
material = cube.active_material
bpy.ops.nacre.edit_stack()
material.nacre.layers[0].medium = "user/film"
assert ("user/film", "Old") in stack.media()
old = pictures(material)
assert len(old) == 2
drawn = []
draw, swatch._draw_swatch = swatch._draw_swatch, lambda *key: drawn.append(key) or draw(*key)
assert all(np.array_equal(a, b) for a, b in zip(old, pictures(material), strict=True))
assert drawn == []  # panels ask at each redraw

write("New", 2.4)
assert ("user/film", "New") in stack.media()
assert not any(np.array_equal(a, b) for a, b in zip(old, pictures(material), strict=True))

# One that cannot be read is drawn again when it can.
entry.write_text("NAMES: [", "utf-8")
assert ("user/film", "") in stack.media()
pictures(material)
write("Old", 1.4)
assert all(np.array_equal(a, b) for a, b in zip(old, pictures(material), strict=True))
extension.unregister()
