# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What Blender raises while a material is made ends the operator, and leaves nothing in the file."""

from __future__ import annotations

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
group = module("materials.group")
image = module("materials.image")
kinds = ("images", "materials", "node_groups", "texts")


def counts() -> list[int]:
    return [len(getattr(bpy.data, kind)) for kind in kinds]


def gives_up(*_arguments):
    raise TypeError("enum 'Data' not found")


def failing(holder, name: str) -> None:
    """The operator, with one of the steps that it takes made to fail."""
    cube = new_file()
    before = counts()
    kept = getattr(holder, name)
    setattr(holder, name, gives_up)
    try:
        for form in ("osl", "nodes"):
            refused(
                lambda form=form: bpy.ops.nacre.assign_material(material="test_film", form=form),
                "TypeError: enum 'Data' not found",
            )
    finally:
        setattr(holder, name, kept)
    assert counts() == before, (name, counts(), before)
    assert not cube.material_slots


failing(image, "hold_as_data")
failing(group, "_set_default")
failing(group, "_arrange")
failing(module("browser.assign"), "put")
extension.unregister()
