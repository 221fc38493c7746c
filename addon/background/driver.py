# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `render …`, or `assets FOLDER`, where the extension is not installed.

python driver.py render …                       with the bpy wheel
blender -b --factory-startup --python driver.py -- render …
"""

from __future__ import annotations

import contextlib
import ctypes
import importlib.util
import os
import sys
from pathlib import Path

PACKAGE = "nacre_extension"


def bring_computation() -> None:
    """Lets the Python package `nacre` be found that the tool has beside the extension's folder, before any other
    one of another version. An installed extension has it as a wheel."""
    # Not resolved: in a build tree this folder is a link into the checkout, its neighbours are not.
    folder = Path(__file__).absolute().parents[2] / "python"
    if folder.is_dir() and str(folder) not in sys.path:
        sys.path.insert(0, str(folder))


def load_package(name: str = PACKAGE):
    """Imports the extension's folder under a name of its own, without touching sys.path."""
    folder = Path(__file__).resolve().parents[1]
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def _arguments() -> list[str]:
    """What follows `--`, which Blender leaves alone; all arguments where Python runs the file."""
    if "--" in sys.argv:
        return sys.argv[sys.argv.index("--") + 1 :]
    return sys.argv[1:]


def _import_bpy():
    """Imported first, the wheel sets up its module search path. What it says of a colour config
    meanwhile goes to standard error: the other is for reports alone."""
    kept = os.dup(1)
    os.dup2(2, 1)
    try:
        import bpy

        with contextlib.suppress(OSError, TypeError, AttributeError):  # what C still holds of it
            ctypes.CDLL(None).fflush(None)
    finally:
        os.dup2(kept, 1)
        os.close(kept)
    return bpy


def main() -> None:
    bpy = _import_bpy()
    bring_computation()
    load_package()
    arguments = _arguments()
    if arguments[:1] == ["assets"]:
        status = importlib.import_module(f"{PACKAGE}.background.asset_job").main(arguments[1:])
    else:
        status = importlib.import_module(f"{PACKAGE}.background.render").main(arguments)
    sys.stdout.flush()
    sys.stderr.flush()
    if bpy.app.binary_path:
        # Blender itself would go on and end with status 0.
        os._exit(status)
    sys.exit(status)


if __name__ == "__main__":
    main()
