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
    """Saves the render result; `discard` removes what is half done and may run in any thread.

    With layers, an .exr has all passes of the render. Not compressed, core.exr can read it.
    """

    def __init__(self, scene: bpy.types.Scene, *, layers: bool = False, compressed: bool = True):
        self._scene = scene
        self._codec = "ZIP" if compressed else "NONE"
        self._formats = {**SUFFIXES, **({".exr": _LAYERS} if layers else {})}
        self._aside: Path | None = None

    def save(self, path: Path) -> None:
        self._aside = aside(path)
        try:
            with _image_settings(self._scene, self._formats[path.suffix.lower()], self._codec):
                bpy.data.images["Render Result"].save_render(str(self._aside), scene=self._scene)
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


def save_view(image: bpy.types.Image, scene: bpy.types.Scene, path: Path) -> None:
    """A picture in the scene's linear space as a PNG, through the scene's view transform."""
    unfinished = aside(path)
    try:
        with _image_settings(scene, "PNG", ""):
            image.save_render(str(unfinished), scene=scene)
        if not is_whole(unfinished):
            raise OutputError(f"{path}: could not be written to its end; is the disc full?")
        unfinished.replace(path)
    except (RuntimeError, OSError) as error:
        raise OutputError(f"{path}: could not be written: {error}") from error
    finally:
        unfinished.unlink(missing_ok=True)


@contextlib.contextmanager
def _image_settings(scene: bpy.types.Scene, file_format: str, codec: str) -> Iterator[None]:
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):  # Blender 5: the format has to belong to the medium
        settings.media_type = "MULTI_LAYER_IMAGE" if file_format == _LAYERS else "IMAGE"
    settings.file_format = file_format
    if file_format != _LAYERS:
        settings.color_mode = "RGB"
    settings.color_depth = "8" if file_format == "PNG" else "32"
    if file_format != "PNG":
        settings.exr_codec = codec
    yield
