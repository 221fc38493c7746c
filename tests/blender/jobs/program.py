# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Programs that would else have a Blender of their own."""

from __future__ import annotations

import runpy
import sys
from pathlib import Path

import bpy

from . import extension


def script(file: str, arguments: list[str]) -> None:
    """Runs a script, whose own asserts decide, with its folder first on the module path."""
    sys.argv[:] = [file, *arguments]
    folder = str(Path(file).parent)
    # Scripts of one folder share a module; it holds no state, but belongs to this request alone.
    before = set(sys.modules)
    sys.path.insert(0, folder)
    try:
        runpy.run_path(file, run_name="__main__")
    finally:
        for name in set(sys.modules) - before:
            if str(getattr(sys.modules[name], "__file__", "")).startswith(folder):
                del sys.modules[name]


def save_scene(file: str) -> None:
    """A cube of oil in the light of a new file, as a user may have it."""
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    extension.load().register()
    try:
        bpy.ops.nacre.assign_material(material="oil_on_water")
        bpy.ops.wm.save_as_mainfile(filepath=file)
    finally:
        extension.load().unregister()


def render(arguments: list[str]) -> int:
    """`driver.py render ARGUMENTS`; its exit status."""
    return extension.module("background.render").main(["render", *arguments])
