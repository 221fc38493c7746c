# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of other versions: groups of an older schema are brought up to date when they are opened or
appended; those of a newer one render as they are, and are not changed."""

from __future__ import annotations

from collections.abc import Callable

import bpy
from bpy.app.handlers import persistent

from ..core.library import Library
from ..core.manifest import ManifestError
from . import group as groups
from .image import TABLE


def version(block: bpy.types.ID) -> int:
    """Of a group or material; 0 where the property is missing or damaged."""
    found = block.get(groups.SCHEMA)
    return found if isinstance(found, int) and found >= 0 else 0


def refusal(tree: bpy.types.NodeTree) -> str:
    """Why a group of ours must not be changed, or nothing."""
    found = version(tree)
    if found <= groups.SCHEMA_VERSION:
        return ""
    return (
        f"Made by a newer Nacre (schema {found}, this one knows {groups.SCHEMA_VERSION}): it "
        "renders as it is; update the extension to change it"
    )


def migrate() -> list[str]:
    """Takes every group of this file step by step to the present schema; returns their names."""
    moved = []
    for tree in bpy.data.node_groups:
        if groups.MATERIAL not in tree or tree.library is not None:
            continue
        found = version(tree)
        if found >= groups.SCHEMA_VERSION:
            continue
        for step in _STEPS[found:]:
            step(tree)
        tree[groups.SCHEMA] = groups.SCHEMA_VERSION
        moved.append(tree.name)
    return moved


def _state_the_version(_tree: bpy.types.NodeTree) -> None:
    """0 to 1: the first files of all did not say which schema they had."""


def _carry_the_template(tree: bpy.types.NodeTree) -> None:
    """1 to 2: the stack editor needs the template that a group was made from, and to know which table
    an image is. Where the library has another template by now, the material must be assigned again
    to be edited."""
    for node in tree.nodes:
        if node.type == "TEX_IMAGE" and node.image is not None and TABLE not in node.image:
            name = _table_of(node.image, tree[groups.MATERIAL])
            if name and node.image.library is None:
                node.image[TABLE] = name
    if groups.TEMPLATE_TEXT in tree:
        return
    try:
        known = Library.default().load(tree[groups.MATERIAL])
    except ManifestError:
        return
    if known.template_sha256 == tree.get(groups.TEMPLATE):
        tree[groups.TEMPLATE_TEXT] = known.template


def _table_of(image: bpy.types.Image, material_id: str) -> str:
    """`R` of an image that was packed from soap_film_R.exr."""
    stem = bpy.path.basename(image.filepath_raw).removesuffix(".exr")
    return stem.removeprefix(f"{material_id}_") if stem.startswith(f"{material_id}_") else ""


_STEPS: tuple[Callable[[bpy.types.NodeTree], None], ...] = (
    _state_the_version,
    _carry_the_template,
)
assert len(_STEPS) == groups.SCHEMA_VERSION


@persistent
def _after_load(*_arguments) -> None:
    for name in migrate():
        print(f"nacre: {name}: brought up to schema {groups.SCHEMA_VERSION}")


# Appending and linking are told from Blender 4.3 on; before, the next opening of the file does it.
HANDLERS = tuple(
    name for name in ("load_post", "blend_import_post") if hasattr(bpy.app.handlers, name)
)


def register() -> None:
    for name in HANDLERS:
        getattr(bpy.app.handlers, name).append(_after_load)


def unregister() -> None:
    for name in HANDLERS:
        getattr(bpy.app.handlers, name).remove(_after_load)
