# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Compress the scan lines of OpenEXR files as well as deflate can, which OpenEXR does not try.

    python squeeze_exr.py FILE.exr …

The pixels and all else stay as they are. Files whose chunks are not deflated are left alone.
Source: OpenEXR file layout, https://openexr.com/en/latest/OpenEXRFileLayout.html.
"""

from __future__ import annotations

import struct
import sys
import zlib
from pathlib import Path

_MAGIC = 20000630
_TILED, _MULTI_PART = 0x200, 0x1000
_LINES = {2: 1, 3: 16, 5: 16}  # of a chunk, by compression: ZIPS, ZIP, PXR24
_STRATEGIES = (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FILTERED)


def squeeze(path: Path) -> None:
    data = path.read_bytes()
    magic, version = struct.unpack_from("<II", data)
    if magic != _MAGIC or version & (_TILED | _MULTI_PART):
        return
    attributes, end = _header(data)
    compression = attributes["compression"][0]
    if compression not in _LINES:
        return
    _, first, _, last = struct.unpack("<4i", attributes["dataWindow"])
    count = -(-(last - first + 1) // _LINES[compression])
    offsets = struct.unpack_from(f"<{count}Q", data, end)
    chunks, places, at = [], [], end + 8 * count
    for offset in offsets:
        line, size = struct.unpack_from("<ii", data, offset)
        packed = _smallest(data[offset + 8 : offset + 8 + size])
        chunks.append(struct.pack("<ii", line, len(packed)) + packed)
        places.append(at)
        at += len(chunks[-1])
    path.write_bytes(data[:end] + struct.pack(f"<{count}Q", *places) + b"".join(chunks))


def _header(data: bytes) -> tuple[dict[str, bytes], int]:
    """Attributes, and where what follows them begins."""
    attributes, at = {}, 8
    while data[at]:
        name_end = data.index(b"\0", at)
        kind_end = data.index(b"\0", name_end + 1)
        (size,) = struct.unpack_from("<i", data, kind_end + 1)
        start = kind_end + 5
        attributes[data[at:name_end].decode()] = data[start : start + size]
        at = start + size
    return attributes, at + 1


def _smallest(packed: bytes) -> bytes:
    """What does not get shorter stands as it is."""
    try:
        values = zlib.decompress(packed)
    except zlib.error:
        return packed
    found = [packed]
    for strategy in _STRATEGIES:
        deflate = zlib.compressobj(9, zlib.DEFLATED, 15, 9, strategy)
        found.append(deflate.compress(values) + deflate.flush())
    return min(found, key=len)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        squeeze(Path(name))
