# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are whole or not there: text written aside, and whether a picture was written to its end;
Blender does not say when a disc has filled up."""

from __future__ import annotations

import contextlib
import os
import struct
from pathlib import Path

from .exr import File

_PNG_END = b"\x00\x00\x00\x00IEND\xae\x42\x60\x82"


def aside(path: Path) -> Path:
    """A name beside it for what is not whole yet; short, as the other may be as long as names can be."""
    return path.with_name(f".nacre-{os.getpid()}.partial{path.suffix}")


def write_whole(path: Path, text: str) -> None:
    """As UTF-8. Raises OSError that names `path`, and leaves what was there."""
    unfinished = aside(path)
    try:
        unfinished.write_text(text, "utf-8")
        unfinished.replace(path)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error
    finally:
        with contextlib.suppress(OSError):
            unfinished.unlink()


def is_whole(path: Path) -> bool:
    """For .png and scan-line .exr, of one part or several."""
    data = path.read_bytes()
    if path.suffix.lower() == ".png":
        return data.endswith(_PNG_END)
    try:
        return _exr_is_whole(data)
    except (struct.error, ValueError, KeyError, IndexError):
        return False


def _exr_is_whole(data: bytes) -> bool:
    """Every chunk of the offset tables lies inside the file; the tables are written last."""
    file = File.parse(data)
    return all(
        0 not in part.offsets
        and all(position + size <= len(data) for _, position, size in file.chunks(part))
        for part in file.parts
    )
