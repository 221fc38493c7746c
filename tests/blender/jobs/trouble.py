# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What goes wrong in a Blender, on demand: for the tests of the harness."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import bpy

from . import extension


def which() -> int:
    """The process."""
    return os.getpid()


def die(number: int) -> None:
    print("last words", flush=True)
    os.kill(os.getpid(), number)


def leave(status: int) -> None:
    os._exit(status)


def fail() -> None:
    print("said before")
    print("complained before", file=sys.stderr)
    raise ValueError("no such film")


def sleep(seconds: float) -> None:
    time.sleep(seconds)


def stay_registered() -> None:
    extension.load().register()


def leave_handler() -> None:
    bpy.app.handlers.load_post.append(extension.module("films.live").finish_all)


def surroundings() -> dict:
    return {
        "variable": os.environ.get("NACRE_TEST_VARIABLE"),
        "folder": str(Path.cwd()),
        "arguments": sys.argv[1:],
        "path": [entry for entry in sys.path if "nacre-test" in entry],
        "objects": sorted(item.name for item in bpy.data.objects),
        "asset libraries": [
            item.name for item in bpy.context.preferences.filepaths.asset_libraries
        ],
        "modules": sorted(name for name in sys.modules if name.startswith(extension.PACKAGE)),
    }


def paint(file: str, red: float, number: int = 0) -> None:
    """One colour, unless a signal ends the process first."""
    if number:
        die(number)
    image = bpy.data.images.new("paint", 4, 4, float_buffer=True, is_data=True)
    image.pixels.foreach_set([red, 0.0, 0.0, 1.0] * 16)
    image.file_format = "OPEN_EXR"
    image.filepath_raw = file
    image.save()
