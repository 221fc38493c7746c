# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a picture was written to its end; Blender does not say when a disc has filled up."""

from __future__ import annotations

import struct
from pathlib import Path

_PNG_END = b"\x00\x00\x00\x00IEND\xae\x42\x60\x82"
# Scan lines in a chunk, by the code of the compression (OpenEXR file layout, "compression").
_EXR_LINES = {0: 1, 1: 1, 2: 1, 3: 16, 4: 32, 5: 16, 6: 32, 7: 32, 8: 32, 9: 256}


def is_whole(path: Path) -> bool:
    """For .png and single-part scan-line .exr."""
    data = path.read_bytes()
    if path.suffix.lower() == ".png":
        return data.endswith(_PNG_END)
    try:
        return _exr_is_whole(data)
    except (struct.error, ValueError, KeyError, IndexError):
        return False


def _exr_is_whole(data: bytes) -> bool:
    """Every chunk of the offset table lies inside the file; the table is written last."""
    attributes, position = _exr_header(data)
    _, y_min, _, y_max = struct.unpack("<4i", attributes["dataWindow"])
    lines = _EXR_LINES[attributes["compression"][0]]
    count = -(-(y_max - y_min + 1) // lines)
    offsets = struct.unpack_from(f"<{count}Q", data, position)
    for offset in offsets:
        _, size = struct.unpack_from("<ii", data, offset)
        if offset == 0 or offset + 8 + size > len(data):
            return False
    return True


def _exr_header(data: bytes) -> tuple[dict[str, bytes], int]:
    """Attributes by name, and where the header ends."""
    attributes: dict[str, bytes] = {}
    position = 8  # magic number and version
    while data[position] != 0:
        name_end = data.index(b"\0", position)
        type_end = data.index(b"\0", name_end + 1)
        (size,) = struct.unpack_from("<i", data, type_end + 1)
        start = type_end + 5
        attributes[data[position:name_end].decode("latin-1")] = data[start : start + size]
        position = start + size
    return attributes, position + 1
