# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenEXR files as far as the extension reads them itself: headers, chunks, and the pixels of
scan-line files with channels of 32 bits, not compressed or ZIP. Blender gives no other way to the
layers of a render. Source: OpenEXR file layout, https://openexr.com/en/latest/OpenEXRFileLayout.html."""

from __future__ import annotations

import struct
import zlib
from array import array
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from .faults import ForeseenError

Attributes = dict[str, bytes]

_MULTI_PART = 0x1000
LINES_OF_ZIP = 16
# Scan lines in a chunk, by the code of the compression ("compression").
_LINES = {0: 1, 1: 1, 2: 1, 3: LINES_OF_ZIP, 4: 32, 5: 16, 6: 32, 7: 32, 8: 32, 9: 256}
_FLOAT = 2
_NONE, _DEFLATED = 0, (2, 3)
_LONGEST_HEADER = 1 << 16


class ExrError(ForeseenError):
    """A file is not what is read here."""


@dataclass(frozen=True)
class Part:
    attributes: Attributes
    offsets: tuple[int, ...]  # of its chunks in the file


@dataclass(frozen=True)
class File:
    data: bytes
    parts: tuple[Part, ...]
    multi_part: bool

    @classmethod
    def parse(cls, data: bytes) -> File:
        """Raises struct.error, ValueError, KeyError or IndexError where the data end too early."""
        multi_part = bool(struct.unpack_from("<I", data, 4)[0] & _MULTI_PART)
        headers, position = [], 8  # magic number and version
        while True:
            attributes, position = _header(data, position)
            headers.append(attributes)
            if not multi_part:
                break
            if data[position] == 0:  # an empty header ends the list
                position += 1
                break
        parts = []
        for attributes in headers:
            count = _chunk_count(attributes)
            parts.append(Part(attributes, struct.unpack_from(f"<{count}Q", data, position)))
            position += 8 * count
        return cls(data, tuple(parts), multi_part)

    def chunks(self, part: Part) -> Iterator[tuple[int, int, int]]:
        """First scan line, place of the pixels in the file, and their size in bytes."""
        for offset in part.offsets:
            start = offset + (4 if self.multi_part else 0)
            line, size = struct.unpack_from("<ii", self.data, start)
            yield line, start + 8, size


def size_of(path: Path) -> tuple[int, int]:
    """Width and height. Raises ExrError."""
    try:
        attributes, _ = _header(path.read_bytes()[:_LONGEST_HEADER], 8)
        x_min, y_min, x_max, y_max = struct.unpack("<4i", attributes["dataWindow"])
    except (struct.error, ValueError, KeyError, IndexError) as error:
        raise ExrError(f"{path}: cannot be read: {error!r}") from error
    return x_max - x_min + 1, y_max - y_min + 1


@dataclass(frozen=True)
class Picture:
    """Attributes of the first part; values of all channels by name, row by row from the top."""

    width: int
    height: int
    attributes: Attributes
    channels: dict[str, array]


def read_picture(path: Path) -> Picture:
    """Raises ExrError, OSError."""
    data = path.read_bytes()
    try:
        file = File.parse(data)
        channels: dict[str, array] = {}
        for part in file.parts:
            channels |= _read_part(file, part)
        attributes = file.parts[0].attributes
        x_min, y_min, x_max, y_max = struct.unpack("<4i", attributes["dataWindow"])
    except (struct.error, ValueError, KeyError, IndexError) as error:
        raise ExrError(f"{path}: cannot be read: {error!r}") from error
    return Picture(x_max - x_min + 1, y_max - y_min + 1, attributes, channels)


def read_channels(path: Path) -> dict[str, array]:
    """Values of all channels. Names are without the view layer in front: `Combined.R`, `nacre_uv.G`.
    Raises ExrError, OSError."""
    channels = read_picture(path).channels
    return {".".join(name.split(".")[-2:]): values for name, values in channels.items()}


def _read_part(file: File, part: Part) -> dict[str, array]:
    compression = part.attributes["compression"][0]
    if compression not in (_NONE, *_DEFLATED):
        raise ValueError(f"compression {compression}")
    x_min, _, x_max, y_max = struct.unpack("<4i", part.attributes["dataWindow"])
    row = 4 * (x_max - x_min + 1)
    names = _channel_names(part.attributes["channels"])
    # The name of a part is that of the layer: ViewLayer.nacre_uv
    layer = part.attributes.get("name", b"").rstrip(b"\0").decode()
    found = {name: array("f") for name in names}
    for y, position, size in sorted(file.chunks(part)):
        data = file.data[position : position + size]
        expected = row * len(names) * min(_LINES[compression], y_max - y + 1)
        if compression in _DEFLATED and size != expected:  # what would not get shorter is as it was
            data = _inflated(data, expected)
        if len(data) != expected:
            raise ValueError("chunk of another size")
        for start in range(0, len(data), row):
            found[names[start // row % len(names)]].frombytes(data[start : start + row])
    return {f"{layer}.{name}" if file.multi_part else name: v for name, v in found.items()}


def _inflated(data: bytes, most: int) -> bytes:
    """The inverse of exr_write.compressed()."""
    import numpy as np  # some distributions' Blender comes without it; files of renders do not need it

    try:
        deflated = zlib.decompressobj().decompress(data, most)
    except zlib.error as error:
        raise ValueError(str(error)) from error
    values = np.cumsum(np.frombuffer(deflated, np.uint8), dtype=np.uint8)
    values[1::2] -= np.uint8(128)
    half = -(-len(values) // 2)
    split = np.empty_like(values)
    split[::2], split[1::2] = values[:half], values[half:]
    return split.tobytes()


def _channel_names(data: bytes) -> list[str]:
    names, position = [], 0
    while data[position] != 0:
        end = data.index(b"\0", position)
        (kind,) = struct.unpack_from("<i", data, end + 1)
        if kind != _FLOAT:
            raise ValueError("channels of another type than float")
        names.append(data[position:end].decode())
        position = end + 17  # type, linearity, two samplings
    return names


def _chunk_count(attributes: Attributes) -> int:
    _, y_min, _, y_max = struct.unpack("<4i", attributes["dataWindow"])
    return -(-(y_max - y_min + 1) // _LINES[attributes["compression"][0]])


def _header(data: bytes, position: int) -> tuple[Attributes, int]:
    """Attributes by name, and where the header ends."""
    attributes: Attributes = {}
    while data[position] != 0:
        name_end = data.index(b"\0", position)
        type_end = data.index(b"\0", name_end + 1)
        (size,) = struct.unpack_from("<i", data, type_end + 1)
        start = type_end + 5
        attributes[data[position:name_end].decode("latin-1")] = data[start : start + size]
        position = start + size
    return attributes, position + 1
