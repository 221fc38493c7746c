# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders of the extension's own, and those among them that Blender lists as asset libraries."""

from __future__ import annotations

from pathlib import Path

import bpy


def own_folder(name: str) -> Path:
    """For what the extension or its user makes; kept over updates. It may not be there yet."""
    try:
        package = __package__.rpartition(".")[0]
        return Path(bpy.utils.extension_path_user(package, path=name))
    except ValueError:  # not installed as an extension
        return Path(bpy.utils.user_resource("DATAFILES", path=f"nacre_{name}"))


def is_listed(folder: Path) -> bool:
    return _listed(folder) is not None


def add(folder: Path, name: str) -> None:
    """Once."""
    if not is_listed(folder):
        _all().new(name=name, directory=str(folder))


def remove(folder: Path) -> None:
    found = _listed(folder)
    if found is not None:
        _all().remove(found)


def _listed(folder: Path) -> bpy.types.UserAssetLibrary | None:
    return next((library for library in _all() if Path(library.path) == folder), None)


def _all():
    return bpy.context.preferences.filepaths.asset_libraries
