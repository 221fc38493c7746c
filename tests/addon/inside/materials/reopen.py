# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders saved files in a Blender that has never seen the extension, and compares: FOLDER…"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy

from jobs.steps import pixels, render

for folder in map(Path, sys.argv[1:]):
    print(folder)
    bpy.ops.wm.open_mainfile(filepath=str(folder / "saved.blend"))
    assert not any(name.startswith("NACRE") for name in dir(bpy.types))
    render(folder / "without.exr")
    with_it, without = pixels(folder / "with.exr"), pixels(folder / "without.exr")
    assert with_it == without
    colours = [with_it[i : i + 3] for i in range(0, len(with_it), 4)]
    assert len({tuple(colour) for colour in colours}) > 4, "the picture is empty"
    assert any(max(c) - min(c) > 0.02 for c in colours), "the picture has no colour"
