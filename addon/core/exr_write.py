# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenEXR files with as many channels as one likes, written a few scan lines at a time: Blender writes
none but its own layers. Scan lines, 32-bit floats, ZIP compression.
Source: OpenEXR file layout, https://openexr.com/en/latest/OpenEXRFileLayout.html."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import BinaryIO

import numpy as np

from .exr import LINES_OF_ZIP
from .whole_file import aside

Attribute = str | Sequence[float]
"""Text, or numbers: two are a v2f, eight chromaticities, others a vector of floats."""

_MAGIC, _VERSION, _LONG_NAMES = 20000630, 2, 0x400
_LONGEST_SHORT_NAME, _LONGEST_NAME = 31, 255
_FLOAT, _ZIP = 2, 3
# Higher levels take three times as long for 2 %.
_LEVEL = 4


class ExrWriter:
    """A file that appears when the last scan line is in it, or not at all.

        with ExrWriter(path, 64, 32, ["B", "G", "R"], {"comments": "a test"}) as writer:
            writer.append(rows)  # float32 (rows, width, channels), from the top

    `channels` may be in any order; a file has them sorted. Raises OSError that names the path, and
    ValueError for names that no file can have.
    """

    def __init__(
        self,
        path: Path,
        width: int,
        height: int,
        channels: Sequence[str],
        attributes: Mapping[str, Attribute],
    ) -> None:
        names = [*channels, *attributes]
        if width < 1 or height < 1 or not channels or len(set(channels)) != len(channels):
            raise ValueError(f"{path}: {width} x {height} pixels of {list(channels)}")
        if bad := [name for name in names if not 0 < len(name.encode()) <= _LONGEST_NAME]:
            raise ValueError(f"{path}: names have 1 to {_LONGEST_NAME} bytes (got {bad[0]!r})")
        self._path, self._width, self._height = path, width, height
        self._order = sorted(range(len(channels)), key=lambda index: channels[index].encode())
        self._header = _header(width, height, sorted(channels, key=str.encode), attributes)
        self._file: BinaryIO | None = None
        self._offsets: list[int] = []
        self._waiting: list[np.ndarray] = []
        self._rows = 0

    def __enter__(self) -> ExrWriter:
        self._guarded(self._begin)
        return self

    def append(self, rows: np.ndarray) -> None:
        """float32 (rows, width, channels), below those that are there."""
        if rows.ndim != 3 or rows.shape[1:] != (self._width, len(self._order)):
            raise ValueError(f"{self._path}: rows of {rows.shape}")
        self._waiting.append(rows.astype("<f4", copy=False))
        self._rows += len(rows)
        if self._rows > self._height:
            raise ValueError(f"{self._path}: more than {self._height} rows")
        self._guarded(lambda: self._write(whole_chunks_only=self._rows < self._height))

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        unfinished = aside(self._path)
        try:
            if kind is None:
                if self._rows != self._height:
                    raise ValueError(f"{self._path}: {self._rows} rows of {self._height}")
                self._guarded(self._end)
                self._guarded(lambda: unfinished.replace(self._path))
        finally:
            if self._file is not None:
                self._file.close()
            unfinished.unlink(missing_ok=True)

    def _guarded(self, step: object) -> None:
        try:
            step()  # type: ignore[operator]
        except OSError as problem:
            raise OSError(problem.errno, problem.strerror, str(self._path)) from problem

    def _begin(self) -> None:
        self._file = aside(self._path).open("wb")
        self._file.write(self._header)
        self._file.write(bytes(8 * self._chunks()))

    def _chunks(self) -> int:
        return -(-self._height // LINES_OF_ZIP)

    def _write(self, *, whole_chunks_only: bool) -> None:
        rows = np.concatenate(self._waiting)
        keep = len(rows) % LINES_OF_ZIP if whole_chunks_only else 0
        for start in range(0, len(rows) - keep, LINES_OF_ZIP):
            self._write_chunk(rows[start : start + LINES_OF_ZIP])
        self._waiting = [rows[len(rows) - keep :]]

    def _write_chunk(self, rows: np.ndarray) -> None:
        assert self._file is not None
        # A line has the values of one channel after those of another.
        data = np.ascontiguousarray(rows[:, :, self._order].transpose(0, 2, 1)).tobytes()
        packed = compressed(data)
        first_line = LINES_OF_ZIP * len(self._offsets)
        self._offsets.append(self._file.tell())
        self._file.write(struct.pack("<ii", first_line, len(packed)) + packed)

    def _end(self) -> None:
        assert self._file is not None
        self._file.seek(len(self._header))
        self._file.write(struct.pack(f"<{len(self._offsets)}Q", *self._offsets))
        self._file.close()


def compressed(data: bytes) -> bytes:
    """As ZIP has it: even bytes before odd ones, differences of neighbours, deflated; or the data
    themselves where that is no shorter."""
    values = np.frombuffer(data, np.uint8)
    split = np.concatenate([values[::2], values[1::2]])
    split[1:] = split[1:] - split[:-1] + np.uint8(128)
    packed = zlib.compress(split.tobytes(), _LEVEL)
    return packed if len(packed) < len(data) else data


def _header(
    width: int, height: int, channels: Sequence[str], attributes: Mapping[str, Attribute]
) -> bytes:
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    listed = b"".join(_text(name) + struct.pack("<iB3xii", _FLOAT, 0, 1, 1) for name in channels)
    fixed = {
        "channels": ("chlist", listed + b"\0"),
        "compression": ("compression", bytes([_ZIP])),
        "dataWindow": ("box2i", window),
        "displayWindow": ("box2i", window),
        "lineOrder": ("lineOrder", b"\0"),
        "pixelAspectRatio": ("float", struct.pack("<f", 1.0)),
        "screenWindowCenter": ("v2f", struct.pack("<2f", 0.0, 0.0)),
        "screenWindowWidth": ("float", struct.pack("<f", 1.0)),
    }
    entries = fixed | {name: _attribute(name, value) for name, value in attributes.items()}
    names = [*channels, *entries]
    flags = _LONG_NAMES if max(len(name.encode()) for name in names) > _LONGEST_SHORT_NAME else 0
    head = struct.pack("<II", _MAGIC, _VERSION | flags)
    return (
        head
        + b"".join(
            _text(name) + _text(kind) + struct.pack("<i", len(data)) + data
            for name, (kind, data) in entries.items()
        )
        + b"\0"
    )


def _text(text: str) -> bytes:
    return text.encode() + b"\0"


def _attribute(name: str, value: Attribute) -> tuple[str, bytes]:
    if isinstance(value, str):
        return "string", value.encode()
    kinds = {1: "float", 2: "v2f", 8: "chromaticities"}
    return kinds.get(len(value), "floatvector"), struct.pack(f"<{len(value)}f", *value)
