# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""glTF files as anybody may read them."""

from __future__ import annotations

import base64
import json
import struct


def read_gltf(path):
    """The document and the bytes of its buffer."""
    data = path.read_bytes()
    if path.suffix == ".gltf":
        document = json.loads(data)
        head, _, text = document["buffers"][0]["uri"].partition(",")
        assert head == "data:application/octet-stream;base64"
        return document, base64.b64decode(text)
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    rest, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0"
    assert 28 + size + rest == len(data)
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def export_gltf(nacre, tmp_path, *arguments):
    path = tmp_path / "x.gltf"
    nacre.ok("export", "gltf", *arguments, "-o", path)
    return read_gltf(path)[0]["materials"]
