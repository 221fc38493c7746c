# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small pictures as PNG, of pixels as Blender's previews have them."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Sequence


def png(width: int, height: int, pixels: Sequence[float]) -> bytes:
    """`pixels`: RGBA from 0 to 1, bottom row first; written as 8 bits without transparency."""
    levels = bytes(min(max(int(255.0 * value + 0.5), 0), 255) for value in pixels)
    rows = bytearray()
    for row in range(height - 1, -1, -1):
        line = levels[4 * width * row : 4 * width * (row + 1)]
        colours = bytearray(3 * width)
        for channel in range(3):
            colours[channel::3] = line[channel::4]
        rows += b"\0" + colours
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + _chunk(b"IHDR", header)
        + _chunk(b"IDAT", zlib.compress(bytes(rows), 9))
        + _chunk(b"IEND", b"")
    )


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
