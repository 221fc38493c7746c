# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Folders that cannot be written, and names that are long, foreign, or full of dots."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

folder = Path(sys.argv[1])
locked = folder / "locked"
locked.mkdir()
locked.chmod(0o555)


@contextlib.contextmanager
def ordinary_user() -> Iterator[None]:
    """The superuser may write anywhere; nobody may not."""
    if os.geteuid() != 0:
        yield
        return
    # Folders of pytest's are its own user's alone: this one, the library's, and those above.
    above = [path for path in folder.parents if path.name.startswith(("pytest-", "popen-"))]
    for pytests in (folder, Path(os.environ["NACRE_MATERIALS"]).parent, *above):
        pytests.chmod(pytests.stat().st_mode | 0o011)
    os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(0)


def names(where: Path) -> set[str]:
    return {path.name for path in where.iterdir()}


# Turned on and off it writes nothing, so that a user folder that is read-only does not matter.
user = Path(os.environ["BLENDER_USER_RESOURCES"])
before = {path for path in user.rglob("*") if path.is_file() or "nacre" in path.name}
extension = load()
extension.register()
extension.unregister()
assert before == {path for path in user.rglob("*") if path.is_file() or "nacre" in path.name}
extension.register()
assets = module("assets.build")
stack = module("films.edited")
recipes = module("materials.recipe")
LONGEST = os.pathconf(folder, "PC_NAME_MAX")

cube = new_file()
bpy.ops.nacre.assign_material(material="oil_on_water", form="nodes")
bpy.ops.nacre.edit_stack()
template = cube.active_material[recipes.TEMPLATE]
save, read = bpy.ops.nacre.save_template, bpy.ops.nacre.load_template

# Templates keep the names that they are given.
there = folder / "Öl" / "薄膜 100%"
there.mkdir(parents=True)
for name, written in (
    ("film 1.5 50%", "film 1.5 50%.toml"),
    ("schicht.v2.toml", "schicht.v2.toml"),
    ("薄膜 %d ####", "薄膜 %d ####.toml"),
    ("n" * (LONGEST - 5), "n" * (LONGEST - 5) + ".toml"),
):
    assert save(filepath=str(there / name)) == {"FINISHED"}
    assert (there / written).read_text("utf-8") == template
    assert read(filepath=str(there / written)) == {"FINISHED"}
assert len(names(there)) == 4, names(there)  # nothing half-written beside them
refused(lambda: save(filepath=str(there / ("n" * LONGEST))), "File name too long")
refused(lambda: read(filepath=str(there / ("n" * 5000))), "File name too long")
refused(lambda: save(filepath=""), "needs the name of a file")
refused(lambda: save(filepath=f"{there}/"), "needs the name of a file")
refused(lambda: save(filepath=str(folder / "nowhere" / "a")), "No such file", "nowhere")
with ordinary_user():
    refused(lambda: save(filepath=str(locked / "a")), "Permission")
refused(lambda: read(filepath=str(there)), "Is a directory")
assert len(names(there)) == 4

# Pictures of the thickness.
broken = there / "kein Bild.png"
broken.write_text("no picture")
counts = len(bpy.data.images), len(cube.active_material.node_tree.nodes)
vary = bpy.ops.nacre.add_thickness
refused(lambda: vary(source="map", filepath=str(broken)), "kein Bild.png: is not a picture")
refused(lambda: vary(source="map", filepath=str(there / "nowhere.png")), "nowhere.png")
assert counts == (len(bpy.data.images), len(cube.active_material.node_tree.nodes))

# The asset library.
before = {kind: set(getattr(bpy.data, kind)) for kind in ("materials", "node_groups", "images")}
for wrong in (locked / "assets", broken / "assets", folder / ("n" * (LONGEST + 1))):
    with ordinary_user() if wrong.parent == locked else contextlib.nullcontext():
        refused(lambda where=wrong: assets.build(where), wrong.name, str(broken), "No such file")
    assert before == {kind: set(getattr(bpy.data, kind)) for kind in before}
assert names(locked) == set()
count, left_out = assets.build(there / "assets 50%.d")
assert (count, left_out) == (1, [])
assert names(there / "assets 50%.d") == {
    assets.BLEND, "blender_assets.cats.txt", "made_of.txt",
}  # fmt: skip

# A .blend of such a name, opened without what it was made from.
blend = there / "Film 1.5 50% ünï.blend"
bpy.ops.wm.save_as_mainfile(filepath=str(blend))
name = cube.active_material.name
bpy.ops.wm.open_mainfile(filepath=str(blend))
assert module("materials.material").missing_tables(bpy.data.materials[name]) == ()
refused(
    lambda: bpy.ops.wm.save_as_mainfile(filepath=str(there / ("n" * LONGEST + ".blend"))), "Cannot"
)
assert not stack.is_stale(bpy.data.materials[name])
extension.unregister()
