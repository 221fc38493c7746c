# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures that appear whole: written aside, then renamed."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Iterator
from pathlib import Path

import bpy

from ..core.faults import ForeseenError
from ..core.whole_file import aside, is_whole

SUFFIXES = {".exr": "OPEN_EXR", ".png": "PNG"}
_LAYERS = "OPEN_EXR_MULTILAYER"


class OutputError(ForeseenError):
    """An output cannot be written; one line for each fault."""


def check(paths: list[Path]) -> None:
    """Refuses, before any work, what could not be written after it."""
    problems = []
    for path in paths:
        if path.suffix.lower() not in SUFFIXES:
            problems.append(f"-o: {path}: must end in .exr or .png")
        elif _unreachable(path):
            problems.append(f"-o: {path}: {_unreachable(path)}")
        elif path.is_dir():
            problems.append(f"-o: {path}: is a folder")
        elif not path.parent.is_dir():
            problems.append(f"-o: {path}: there is no folder {path.parent}")
        elif not os.access(path.parent, os.W_OK):
            problems.append(f"-o: {path}: the folder {path.parent} is not writable")
    if problems:
        raise OutputError("\n".join(problems))


def _unreachable(path: Path) -> str:
    """What the system says against the name itself, such as that it is too long."""
    try:
        path.lstat()
    except (FileNotFoundError, NotADirectoryError):
        return ""
    except (OSError, ValueError) as error:
        return getattr(error, "strerror", None) or str(error)
    return ""


def frame_path(path: Path, frame: int) -> Path:
    """`####` becomes the frame, padded to as many digits; without it the frame goes before the suffix."""
    marks = re.search(r"#+", path.name)
    if marks:
        name = path.name.replace(marks.group(), f"{frame:0{len(marks.group())}d}", 1)
    else:
        name = f"{path.stem}_{frame:04d}{path.suffix}"
    return path.with_name(name)


class Writer:
    """Saves the render result, or another picture; `discard` removes what is half done and may run in
    any thread.

    With layers, an .exr has all passes of the render. Not compressed, core.exr can read it.
    """

    def __init__(self, scene: bpy.types.Scene, *, layers: bool = False, compressed: bool = True):
        self._scene = scene
        self._codec = "ZIP" if compressed else "NONE"
        self._formats = {**SUFFIXES, **({".exr": _LAYERS} if layers else {})}
        self._aside: Path | None = None

    def save(self, path: Path, image: bpy.types.Image | None = None) -> None:
        self._aside = aside(path)
        source = bpy.data.images["Render Result"] if image is None else image
        try:
            with _image_settings(self._scene, self._formats[path.suffix.lower()], self._codec):
                source.save_render(str(self._aside), scene=self._scene)
            if not is_whole(self._aside):
                raise OutputError(f"{path}: could not be written to its end; is the disc full?")
            self._aside.replace(path)
        except (RuntimeError, OSError) as error:
            raise OutputError(f"{path}: could not be written: {error}") from error
        finally:
            self.discard()

    def discard(self) -> None:
        if self._aside is None:
            return
        # Blender makes several files of one name where a render has several views.
        for left in self._aside.parent.glob(f"{self._aside.stem}*"):
            with contextlib.suppress(OSError):
                left.unlink()


@contextlib.contextmanager
def _image_settings(scene: bpy.types.Scene, file_format: str, codec: str) -> Iterator[None]:
    """What the scene's own pictures are saved as is as it was at the end."""
    settings = scene.render.image_settings
    is_png, is_layered = file_format == "PNG", file_format == _LAYERS
    # Each is one of the choices that those before it leave.
    wanted = {
        # Blender 5: the format has to belong to the medium.
        "media_type": "MULTI_LAYER_IMAGE" if is_layered else "IMAGE",
        "file_format": file_format,
        "color_mode": None if is_layered else "RGB",
        "color_depth": "8" if is_png else "32",
        "exr_codec": None if is_png else codec,
    }
    before = {name: getattr(settings, name) for name in wanted if hasattr(settings, name)}
    try:
        for name in before:
            if wanted[name] is not None:
                setattr(settings, name, wanted[name])
        yield
    finally:
        for name, value in before.items():
            setattr(settings, name, value)
