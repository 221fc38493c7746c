# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A look as a file: a .blend with one wave material and all that it needs, marked as an asset."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import bpy

from ..assets import asset
from ..blender.output import OutputError
from ..core.catalogues import thumbnail
from ..core.library import Library
from ..core.words import synonyms
from ..films import edited
from ..materials import group as groups
from ..materials import schema
from ..materials.material import belongs_here, group_node, kind, missing_tables
from ..variations import pictures
from ..viewer import views
from ..viewer.fields import SHADED

LOOK, PRINT = "nacre_look", "nacre_look_print"
"""Custom properties of a material that came from a look; see my_looks."""

PICTURE = 256
_CARRIED = ("node_groups", "images", "texts", "actions", "materials")
_MAGIC = (b"BLENDER", b"\x28\xb5\x2f\xfd", b"\x1f\x8b")  # plain, Zstandard, gzip


# ---- Writing -------------------------------------------------------------------------------------


def write(material: bpy.types.Material, name: str, path: Path, words: str = "") -> list[float]:
    """Whole, or not at all; returns the pixels of its picture. `words`: its description."""
    _must_be_whole(material)
    if not path.parent.is_dir():
        raise OutputError(f"{path}: there is no folder {path.parent}")
    with _lone_copy(material) as (copy, called):
        called(name)
        _mark(copy, material, words)
        try:
            asset.write(path, {copy})
        except (OSError, RuntimeError) as error:
            raise OutputError(f"{path}: could not be written: {_reason(error)}") from error
        return list(copy.preview.image_pixels_float)


def _reason(error: Exception) -> str:
    """Of an operator or `libraries`, which say what kind of report it was."""
    return getattr(error, "strerror", None) or str(error).removeprefix("Error: ").strip()


def _must_be_whole(material: bpy.types.Material) -> None:
    refusal = schema.refusal(group_node(material).node_tree)
    if refusal:
        raise OutputError(refusal)
    if belongs_here(material):
        edited.finish(material)
    missing = missing_tables(material)
    if missing:
        raise OutputError(
            f"{material.name}: its tables are missing: {', '.join(missing)}; Rebuild Material first"
        )


@contextlib.contextmanager
def _lone_copy(material: bpy.types.Material) -> Iterator[tuple]:
    """A copy that leads to nothing else in the file, and what gives it a name, which another may have."""
    shown = views.shown()
    if shown != SHADED:
        views.show(bpy.context.scene, SHADED)
    renamed: list[tuple[bpy.types.Material, str]] = []

    def called(name: str) -> None:
        holder = bpy.data.materials.get((name, None))
        if holder is not None and holder != copy:
            renamed.append((holder, name))
            holder.name = f"{name[:40]} (while a look is saved)"
        copy.name = name

    try:
        # Only now: Blender may put new blocks where those of the view were.
        with asset.only_for_now():
            copy = material.copy()
            for stated in (LOOK, PRINT):
                if stated in copy:
                    del copy[stated]
            let_go(copy.node_tree)
            _pack(copy.node_tree)
            yield copy, called
    finally:
        for holder, name in renamed:
            holder.name = name
        if shown != SHADED:
            views.show(bpy.context.scene, shown)


def let_go(tree: bpy.types.NodeTree) -> None:
    """Of objects and scenes, which would come along with everything in them."""
    for node in tree.nodes:
        if node.type == "TEX_COORD":
            node.object = None
    for curve in tree.animation_data.drivers if tree.animation_data else ():
        for variable in curve.driver.variables:
            for target in variable.targets:
                if variable.type == "SINGLE_PROP" or target.id_type == "OBJECT":
                    target.id = None


def _pack(tree: bpy.types.NodeTree) -> None:
    """Pictures that lie elsewhere, as copies: those of the file stay as they are."""
    for node in tree.nodes:
        if node.type == "GROUP" and node.node_tree is not None:
            if node.node_tree.library is not None:
                raise OutputError(
                    f"{node.node_tree.name} is linked from another file: make it local first"
                )
            if _has_loose_images(node.node_tree):
                node.node_tree = node.node_tree.copy()
                _pack(node.node_tree)
        elif node.type == "TEX_IMAGE" and _is_loose(node.image):
            node.image = _packed(node.image)


def _has_loose_images(tree: bpy.types.NodeTree) -> bool:
    return any(
        (node.type == "TEX_IMAGE" and _is_loose(node.image))
        or (node.type == "GROUP" and node.node_tree and _has_loose_images(node.node_tree))
        for node in tree.nodes
    )


def _is_loose(image: bpy.types.Image | None) -> bool:
    return image is not None and (image.packed_file is None or image.library is not None)


def _packed(image: bpy.types.Image) -> bpy.types.Image:
    if image.source in ("SEQUENCE", "MOVIE", "TILED"):
        raise OutputError(f"{image.name}: sequences, movies and tiles do not fit into one file")
    copy = image.copy()
    if copy.packed_file is None:
        try:
            copy.pack()
        except RuntimeError as error:
            raise OutputError(f"{image.name}: {error}") from error
    if copy.packed_file is None:
        raise OutputError(f"{image.name}: the picture cannot be read from {image.filepath}")
    copy.filepath_raw = f"//{bpy.path.basename(image.filepath_raw) or image.name}"
    return copy


def _mark(copy: bpy.types.Material, material: bpy.types.Material, words: str) -> None:
    entry = Library.default().entries().get(group_node(copy).node_tree[groups.MATERIAL])
    own = (*entry.tags, *synonyms(entry)) if entry else ()
    asset.mark(
        copy,
        category=entry.category if entry else "",
        description=words or (entry.description if entry else ""),
        tags=dict.fromkeys(filter(None, (kind(copy), "Nacre", *own))),
    )
    _give_picture(copy, material)


def _give_picture(copy: bpy.types.Material, material: bpy.types.Material) -> None:
    """What has layers is drawn; others have the picture of the library's material."""
    shown = pictures.subject(material)
    preview = copy.preview_ensure()
    if shown is not None:
        with contextlib.suppress(ValueError):  # an edit that cannot be computed
            pixels = pictures.draw(shown, PICTURE)
            preview.image_size = PICTURE, PICTURE
            preview.image_pixels_float.foreach_set(pixels.ravel())
            return
    asset.give_picture(copy, thumbnail(group_node(copy).node_tree[groups.MATERIAL]))


# ---- Reading -------------------------------------------------------------------------------------


def append(path: Path) -> dict[bpy.types.Material, str]:
    """The wave materials of a file, and what they are called there. Raises OutputError, and leaves
    nothing, where there is none, or one that is newer than this version."""
    _must_be_blend(path)
    before = asset.all_blocks()
    try:
        with bpy.data.libraries.load(str(path), link=False) as (source, target):
            names = list(source.materials)
            target.materials = list(names)
        found = zip(names, target.materials, strict=True)
        named = {m: name for name, m in found if m is not None and group_node(m) is not None}
        wanted = list(named)
        if not wanted:
            raise OutputError(f"{path}: there is no wave material in it")
        for material in wanted:
            refusal = schema.refusal(group_node(material).node_tree)
            if refusal:
                raise OutputError(f"{path}: {material.name}: {refusal}")
    except (OSError, RuntimeError, OutputError) as error:
        bpy.data.batch_remove(asset.all_blocks() - before)
        if isinstance(error, OutputError):
            raise
        raise OutputError(f"{path}: cannot be read: {_reason(error)}") from error
    for material in wanted:
        let_go(material.node_tree)
        _share(material, before)
    sweep(before, set(wanted))
    return named


def _must_be_blend(path: Path) -> None:
    try:
        with path.open("rb") as file:
            start = file.read(7)
    except (OSError, ValueError) as error:
        raise OutputError(f"{path}: cannot be read: {_reason(error)}") from error
    if not start.startswith(_MAGIC):
        raise OutputError(f"{path}: is not a .blend file")


def _share(material: bpy.types.Material, before: set[bpy.types.ID]) -> None:
    """The group of the file where it is the same, so that its tables are there once."""
    node = group_node(material)
    tree = node.node_tree
    for other in bpy.data.node_groups:
        if other not in before or other.library is not None or not tree.get(groups.DIGEST):
            continue
        names = (groups.DIGEST, groups.FORM, groups.SCHEMA, groups.RECIPE)
        if all(other.get(name) == tree.get(name) for name in names):
            images = (n.image for n in other.nodes if n.type == "TEX_IMAGE")
            if not any(map(_is_loose, images)):
                node.node_tree = other
                return


def sweep(before: set[bpy.types.ID], wanted: set[bpy.types.Material]) -> None:
    """Takes out what came along and belongs to none of the materials."""
    carried = {id_ for kind_ in _CARRIED for id_ in getattr(bpy.data, kind_)}
    bpy.data.batch_remove((asset.all_blocks() - before) - carried)
    while True:
        left = [
            block
            for block in asset.all_blocks() - before - wanted
            if block.users - block.use_fake_user <= 0 or isinstance(block, bpy.types.Material)
        ]
        if not left:
            return
        bpy.data.batch_remove(left)
