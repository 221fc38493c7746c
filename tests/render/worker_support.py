# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the scripts that run inside Blender share."""

from __future__ import annotations

import importlib
import importlib.util
import json
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import ModuleType

import bpy

ADDON = Path(__file__).resolve().parents[2] / "addon"


@cache
def load_extension() -> str:
    """Imports the extension from the checkout, once; returns its package's name."""
    spec = importlib.util.spec_from_file_location("nacre_driver", ADDON / "driver.py")
    driver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(driver)
    driver.load_package()
    return driver.PACKAGE


def extension(module: str) -> ModuleType:
    """A module of the extension, such as `nodes.material`."""
    return importlib.import_module(f"{load_extension()}.{module}")


def render_picture(
    scene: bpy.types.Scene, width: int, height: int, samples: int, file: str
) -> None:
    """Every pixel gets all its samples, and nothing is smoothed."""
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.cycles.samples = samples
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    bpy.ops.render.render()
    extension("output").Writer(scene).save(Path(file))


def run_jobs(render: Callable[[dict], None]) -> None:
    """Renders each job of the file that the first argument names."""
    load_extension()  # before a job resets Blender
    for job in json.loads(Path(sys.argv[1]).read_text()):
        render(job)
