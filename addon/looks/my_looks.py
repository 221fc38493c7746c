# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks that a user has saved: a folder with a .blend for each, which is an asset library, too."""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
import time
from dataclasses import dataclass
from pathlib import Path

import bpy
import bpy.utils.previews
from bpy.app.handlers import persistent

from ..blender import asset_libraries
from ..blender.output import OutputError
from ..core.catalogues import FILE, catalogue_text
from ..core.library import Library
from ..core.whole_file import aside, write_whole
from ..materials import group as groups
from ..materials import recipe as recipes
from ..materials import schema
from ..materials.image import save_png
from ..materials.material import group_node
from . import file_names, look_file
from .look_file import LOOK, PRINT

NAME = "Nacre: My Looks"
_LOOK_AGAIN = 0.5  # seconds

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []  # one at most
_loaded: dict[str, int] = {}  # when each picture that is shown was written
_seen: list[tuple[float, tuple[Look, ...]]] = []  # one at most: when, and what was there


@dataclass(frozen=True)
class Look:
    name: str
    file: Path
    stamp: str  # of the file as it is now

    @property
    def picture(self) -> Path:
        return self.file.with_suffix(".png")


def folder() -> Path:
    return asset_libraries.own_folder("looks")


def looks() -> tuple[Look, ...]:
    """By name. The folder is looked at again after a moment, not at each redraw."""
    now = time.monotonic()
    if not _seen or now > _seen[0][0] + _LOOK_AGAIN:
        _seen[:] = [(now, _found())]
    return _seen[0][1]


def _found() -> tuple[Look, ...]:
    found = []
    with contextlib.suppress(OSError):
        for item in os.scandir(folder()):
            is_one = item.name.endswith(".blend") and not item.name.startswith(".")
            if is_one and item.is_file():
                path = Path(item.path)
                found.append(Look(file_names.name_of(path.stem), path, _stamp(path)))
    return tuple(sorted(found, key=lambda look: look.name.casefold()))


def _stamp(path: Path) -> str:
    status = path.stat()
    return f"{path.name} {status.st_size} {status.st_mtime_ns}"


def look(name: str) -> Look:
    _seen.clear()
    found = next((item for item in looks() if file_names.is_same(item.name, name)), None)
    if found is None:
        raise OutputError(f"There is no look “{name}” in {folder()}")
    return found


def has(name: str) -> bool:
    return any(file_names.is_same(item.name, name) for item in looks())


def save(material: bpy.types.Material, name: str, words: str = "", *, replace: bool) -> Look:
    """Under a name of its own, unless it is to replace another."""
    name = file_names.tidy(name)
    if not name:
        raise OutputError("The look needs a name")
    _seen.clear()
    old = next((item for item in looks() if file_names.is_same(item.name, name)), None)
    if old is not None and not replace:
        raise OutputError(f"There is a look “{old.name}” already; choose another name, or Replace")
    try:
        folder().mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{folder()}: cannot be made: {error.strerror}") from error
    path = old.file if old else folder() / f"{file_names.stem(name)}.blend"
    pixels = look_file.write(material, name, path, words)
    _write_picture(path.with_suffix(".png"), pixels)
    _add_catalogue(material)
    _seen.clear()
    show()
    _refresh_browsers()
    return look(name)


def _write_picture(path: Path, pixels: list[float]) -> None:
    """A look is whole without it."""
    unfinished = aside(path)
    size = math.isqrt(len(pixels) // 4)
    with contextlib.suppress(OSError, RuntimeError):
        if size:
            import numpy as np

            save_png(unfinished, np.array(pixels, dtype=np.float32).reshape(size, size, 4))
            unfinished.replace(path)
        else:
            path.unlink()  # of the one that it replaces
    with contextlib.suppress(OSError):
        unfinished.unlink()


def _add_catalogue(material: bpy.types.Material) -> None:
    """Beside those that there are: the user may have made some."""
    entry = Library.default().entries().get(group_node(material).node_tree[groups.MATERIAL])
    if entry is None:
        return
    path = folder() / FILE
    text = path.read_text("utf-8") if path.is_file() else ""
    wanted = catalogue_text([entry.category])
    known = {line.partition(":")[0] for line in text.splitlines()}
    new = [
        line for line in wanted.splitlines() if ":" in line and line.partition(":")[0] not in known
    ]
    if not text:
        write_whole(path, wanted)
    elif new:
        write_whole(path, text.rstrip("\n") + "\n" + "\n".join(new) + "\n")


def remove(name: str) -> None:
    gone = look(name)
    gone.file.unlink()
    with contextlib.suppress(OSError):
        gone.picture.unlink()
    _seen.clear()
    if not looks():
        hide()
    _refresh_browsers()


# ---- Into the file -------------------------------------------------------------------------------


def material_of(wanted: Look) -> bpy.types.Material:
    """The one that is in the file and was not changed, or it is appended."""
    for material in bpy.data.materials:
        is_it = material.library is None and material.get(LOOK) == wanted.stamp
        if is_it and group_node(material) and material.get(PRINT) == fingerprint(material):
            return material
    material = next(iter(look_file.append(wanted.file)))
    adopt(material)
    material[LOOK], material[PRINT] = wanted.stamp, fingerprint(material)
    return material


def adopt(material: bpy.types.Material) -> None:
    """It is this file's now, and an asset of the other."""
    material.asset_clear()
    material.use_fake_user = False


def fingerprint(material: bpy.types.Material) -> str:
    """Of all that one turns and links in it."""
    tree = material.node_tree
    nodes = [_described(node) for node in sorted(tree.nodes, key=lambda node: node.name)]
    links = sorted(
        (link.from_node.name, link.from_socket.identifier, link.to_node.name,
         link.to_socket.identifier)
        for link in tree.links
    )  # fmt: skip
    told = [nodes, links, recipes.recipe(material).digest if recipes.is_edited(material) else ""]
    return hashlib.sha256(json.dumps(told).encode()).hexdigest()


def _described(node: bpy.types.Node) -> list:
    inputs = [
        [socket.identifier, _plain(socket.default_value)]
        for socket in node.inputs
        if hasattr(socket, "default_value")
    ]
    own = [
        str(getattr(node, name, ""))
        for name in ("attribute_name", "mute", "operation", "blend_type")
    ]
    ramp = getattr(node, "color_ramp", None)
    stops = [[stop.position, *stop.color] for stop in ramp.elements] if ramp else []
    return [node.name, node.type, inputs, own, stops]


def _plain(value):
    if isinstance(value, (bool, int, float, str)):
        return value
    return list(value) if hasattr(value, "__len__") else str(getattr(value, "name", value))


def drive(material: bpy.types.Material, scene: bpy.types.Scene) -> None:
    """Lets the frames of this scene run what those of another ran."""
    animation = material.node_tree.animation_data
    for curve in animation.drivers if animation else ():
        for variable in curve.driver.variables:
            for target in variable.targets:
                if target.id_type == "SCENE" and target.id is None:
                    target.id = scene


@persistent
def _after_import(*_arguments) -> None:
    """Of one that was dragged in from the asset browser."""
    for material in bpy.data.materials:
        if groups.MATERIAL in material and material.is_editable and material.node_tree:
            drive(material, bpy.context.scene)


# ---- As an asset library and as pictures -----------------------------------------------------------


def show() -> None:
    """Lists the folder among the asset libraries when there is a look."""
    if looks():
        asset_libraries.add(folder(), NAME)


def hide() -> None:
    asset_libraries.remove(folder())


def _refresh_browsers() -> None:
    """An asset browser reads its library once."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.ui_type == "ASSETS":
                with bpy.context.temp_override(window=window, area=area):
                    if bpy.ops.asset.library_refresh.poll():
                        bpy.ops.asset.library_refresh()


def icon(shown: Look) -> int:
    """0 where there is no picture."""
    try:
        written = shown.picture.stat().st_mtime_ns
    except OSError:
        return 0
    if not _collections:
        _collections.append(bpy.utils.previews.new())
    icons, key = _collections[0], shown.file.name
    if key in icons and _loaded.get(key) != written:
        del icons[key]
    if key not in icons:
        icons.load(key, str(shown.picture), "IMAGE")
        _loaded[key] = written
    return icons[key].icon_id


_HANDLERS = tuple(name for name in schema.HANDLERS if name == "blend_import_post")


def register() -> None:
    _seen.clear()  # of another user folder
    for name in _HANDLERS:
        getattr(bpy.app.handlers, name).append(_after_import)
    show()


def unregister() -> None:
    for name in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(_after_import)
    hide()
    _seen.clear()
    _loaded.clear()
    while _collections:
        bpy.utils.previews.remove(_collections.pop())
