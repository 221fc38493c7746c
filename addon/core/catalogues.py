# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Catalogues of an asset library: a path in the tree and an identifier that never changes."""

from __future__ import annotations

import uuid
from collections.abc import Iterable
from pathlib import Path

from .looks import picture_name

FILE = "blender_assets.cats.txt"
_NAMESPACE = uuid.UUID("5f0d6f4e-6a55-4f3c-9d3e-3f0b8b8f9a51")


def catalogue_id(category: str) -> str:
    """The same for the same path, on every machine."""
    return str(uuid.uuid5(_NAMESPACE, _path(category)))


def _path(category: str) -> str:
    """As Blender would clean it up: a colon ends a field of the file, and no part is empty."""
    parts = (part.strip() for part in category.replace(":", "-").split("/"))
    return "/".join(part for part in parts if part) or "-"


def catalogue_text(categories: Iterable[str]) -> str:
    """Of `blender_assets.cats.txt`: every catalogue and those above it, in order."""
    paths = {
        "/".join(path.split("/")[: depth + 1])
        for path in map(_path, categories)
        for depth in range(path.count("/") + 1)
    }
    lines = ["# Written by Nacre.", "", "VERSION 1", ""]
    lines += [f"{catalogue_id(path)}:{path}:{path.replace('/', '-')}" for path in sorted(paths)]
    return "\n".join(lines) + "\n"


def thumbnail(key: str) -> Path:
    """The picture of a variant that comes along, 256 x 256; it may be missing."""
    return Path(__file__).resolve().parent.parent / "thumbnails" / f"{picture_name(key)}.jpg"
