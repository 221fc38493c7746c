# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The asset library is made by a Blender of its own, says how far it is, and is made again when the
materials are others."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import bpy

from jobs.extension import load, module
from jobs.steps import refused

extension = load()
extension.register()
assets = module("assets.build")
build = module("assets.process")
library = module("core.library").Library
folder = Path(sys.argv[1]) / "assets"
libraries = bpy.context.preferences.filepaths.asset_libraries
listed = len(libraries)


def wait() -> set:
    """What progress was shown."""
    seen = set()
    end = time.monotonic() + 120.0
    while build.progress() is not None:
        assert time.monotonic() < end
        seen.add(build.progress())
        build.look()
        time.sleep(0.02)
    return seen


# In background nothing begins by itself, and nothing is there.
assert build.progress() is None
assert build.result() == ""
assert not assets.is_current(folder)
refused(bpy.ops.nacre.open_assets, "poll()")

build.begin(folder)
build.begin(folder)  # which is one job all the same
assert len(build._jobs) == 1
blocks = len(bpy.data.materials)
seen = wait()
count = len(library.default().entries())
assert {total for _, total in seen} <= {0, count}
assert len(seen) > 1, seen
assert build.result() == f"{count} materials are ready", build.result()
assert assets.is_built(folder)
assert assets.is_current(folder)
assert len(libraries) == listed + 1
assert len(bpy.data.materials) == blocks
assert {path.name for path in folder.iterdir()} == {
    "nacre_materials.blend", "blender_assets.cats.txt", "made_of.txt",
}  # fmt: skip
with bpy.data.libraries.load(str(folder / assets.BLEND), assets_only=True) as (source, _):
    assert len(source.materials) == count
build.dismiss()
assert build.result() == ""

# Other materials, or a stamp that cannot be read: it is not current any more.
stamp = folder / "made_of.txt"
text = stamp.read_text("utf-8")
stamp.write_text(text + "tin 12\n", "utf-8")
assert not assets.is_current(folder)
stamp.write_text(text, "utf-8")
assert assets.is_current(folder)
stamp.unlink()
assert not assets.is_current(folder)

# What an earlier one left when it was killed goes; what another may be writing stays.
old, new = (folder / f"{assets.BLEND}.{number}.partial.blend" for number in (1, 2))
for path in (old, new):
    path.write_bytes(b"part")
os.utime(old, (0.0, 0.0))
assets._forget_what_was_killed(folder)
assert not old.exists()
assert new.exists()

# A folder that cannot be made: the reason is told, what was there is left alone.
blocked = Path(sys.argv[1]) / "blocked"
blocked.write_text("mine", "utf-8")
build.begin(blocked)
wait()
assert build.result().startswith("The asset library was not made: "), build.result()
assert "Exists" in build.result() or "exist" in build.result() or "directory" in build.result()
assert blocked.read_text("utf-8") == "mine"

# Ended with the extension: no process goes on.
build.begin(folder)
process = build._jobs[0].process
extension.unregister()
assert process.poll() is not None
