# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A material as an asset: what the asset browser says and shows of it, and the file that it is in."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator
from pathlib import Path

import bpy

from ..core.catalogues import catalogue_id
from ..core.whole_file import aside


def mark(
    material: bpy.types.Material, *, category: str, description: str, tags: Iterable[str]
) -> bpy.types.AssetMetaData:
    """`category`: a path in the catalogues; empty: it is in none."""
    material.asset_mark()
    data = material.asset_data
    data.description = description
    if category:
        data.catalog_id = catalogue_id(category)
    for tag in tags:
        data.tags.new(tag, skip_if_exists=True)
    return data


def give_picture(material: bpy.types.Material, file: Path) -> None:
    """Nothing where there is no such file."""
    if file.is_file():
        with bpy.context.temp_override(id=material):
            bpy.ops.ed.lib_id_load_custom_preview(filepath=str(file))


def write(path: Path, materials: set[bpy.types.Material]) -> None:
    """With all that they need; the file is whole, or it is as it was. Raises OSError or RuntimeError."""
    unfinished = aside(path)
    try:
        bpy.data.libraries.write(str(unfinished), materials, fake_user=True, compress=True)
        unfinished.replace(path)
    finally:
        with contextlib.suppress(OSError):
            unfinished.unlink()


def all_blocks() -> set[bpy.types.ID]:
    lists = (p.identifier for p in bpy.data.bl_rna.properties if p.type == "COLLECTION")
    return {block for name in lists for block in getattr(bpy.data, name)}


@contextlib.contextmanager
def only_for_now() -> Iterator[None]:
    """Takes what is made meanwhile out of the open file again."""
    before = all_blocks()
    try:
        yield
    finally:
        bpy.data.batch_remove(all_blocks() - before)
