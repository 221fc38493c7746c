# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The extension of the checkout inside Blender, by the driver that the tool starts and under the name
that it gives."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from types import ModuleType

import bpy

from support.paths import DRIVER


def _driver() -> ModuleType:
    spec = importlib.util.spec_from_file_location("nacre_driver", DRIVER)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


PACKAGE = _driver().PACKAGE


def load() -> ModuleType:
    """The package, imported once until forget()."""
    driver = _driver()
    driver.bring_computation()
    return sys.modules.get(PACKAGE) or driver.load_package()


def module(name: str) -> ModuleType:
    """A module of the extension, such as `materials.material`."""
    load()
    return importlib.import_module(f"{PACKAGE}.{name}")


def set_space(name: str) -> None:
    """One of the working spaces of Blender 5 for the file that is open; none: what it has."""
    if name:
        bpy.ops.wm.set_working_color_space(working_space=name, convert_colors=True)


def space_to_xyz() -> list[list[float]]:
    """Of the file's scene-linear space."""
    return [list(row) for row in module("blender.space").of_file()]


def forget() -> None:
    """The next load() imports everything anew, the package that the extension computes with too."""
    for name in [name for name in sys.modules if name.split(".")[0] in (PACKAGE, "nacre")]:
        del sys.modules[name]


def is_off() -> bool:
    """Whether no class, property or handler of it is registered."""
    handlers = [
        handler
        for name in dir(bpy.app.handlers)
        if isinstance(getattr(bpy.app.handlers, name), list)
        for handler in getattr(bpy.app.handlers, name)
    ]
    return (
        not hasattr(bpy.types.Scene, "nacre")
        and not any(name.startswith("NACRE_") for name in dir(bpy.types))
        and not any(_is_ours(getattr(handler, "__module__", None)) for handler in handlers)
    )


def _is_ours(name: str | None) -> bool:
    return str(name).split(".")[0] == PACKAGE
