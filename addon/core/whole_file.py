# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a picture was written to its end; Blender does not say when a disc has filled up."""

from __future__ import annotations

import struct
from pathlib import Path

from .exr import File

_PNG_END = b"\x00\x00\x00\x00IEND\xae\x42\x60\x82"


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
