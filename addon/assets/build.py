# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The library of materials as an asset library of Blender's: one .blend with catalogues, tags and pictures."""

from __future__ import annotations

import contextlib
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import bpy

from ..blender import asset_libraries
from ..core.catalogues import FILE, catalogue_text, thumbnail
from ..core.form import AUTO, NODES, FormError, choose_form
from ..core.library import Library
from ..core.looks import Variant, variants
from ..core.manifest import CompiledMaterial, ManifestError
from ..core.whole_file import write_whole
from ..core.words import synonyms
from ..materials import group as groups
from ..materials import scene as scene_setup
from ..materials.material import create_material
from ..thickness.dress import dress
from .asset import give_picture, mark, only_for_now, write

NAME = "Nacre"
BLEND = "nacre_materials.blend"
_STAMP = "made_of.txt"


def default_folder() -> Path:
    return asset_libraries.own_folder("assets")


def build(folder: Path, tell: Callable[[int, int], None] | None = None) -> tuple[int, list[str]]:
    """Writes the asset library; returns how many materials it has, and what was left out and why.
    `tell` hears after each material how many are done, of how many.

    The open file stays as it is. Materials are nodes where they can be, which works in every engine;
    the others are OSL.
    """
    made: list[bpy.types.Material] = []
    left_out: list[str] = []
    categories: set[str] = set()
    library = Library.default()
    with _undisturbed(), only_for_now():
        offered = variants(library.entries())
        for number, variant in enumerate(offered.values(), 1):
            try:
                compiled = library.load(variant.entry.id)
                made.append(_asset(compiled, variant))
            except (ManifestError, FormError) as error:
                left_out.append(f"{variant.key}: {error}")
            else:
                categories.add(compiled.category)
            if tell:
                tell(number, len(offered))
        folder.mkdir(parents=True, exist_ok=True)
        _forget_what_was_killed(folder)
        write(folder / BLEND, set(made))
    write_whole(folder / FILE, catalogue_text(categories))
    write_whole(folder / _STAMP, _stamp())
    return len(made), left_out


def show(folder: Path) -> None:
    asset_libraries.add(folder, NAME)


def register() -> None:
    if is_built(default_folder()):
        show(default_folder())


def unregister() -> None:
    asset_libraries.remove(default_folder())


def is_built(folder: Path) -> bool:
    return (folder / BLEND).is_file()


def _forget_what_was_killed(folder: Path) -> None:
    an_hour_ago = time.time() - 3600.0
    for path in folder.glob("*.partial.blend"):
        if path.stat().st_mtime < an_hour_ago:
            path.unlink(missing_ok=True)


def is_current(folder: Path) -> bool:
    """Whether it was made of the materials that there are, by this version."""
    try:
        made_of = (folder / _STAMP).read_text("utf-8")
    except OSError:
        return False
    return is_built(folder) and made_of == _stamp()


def _stamp() -> str:
    library = Library.default()
    manifests = ((name, library.root / name / f"{name}.json") for name in library.entries())
    lines = [f"{name} {path.stat().st_size}\n" for name, path in manifests]
    return f"schema {groups.SCHEMA_VERSION}\n{''.join(lines)}"


def delete(folder: Path) -> None:
    """Raises OSError where the folder cannot be changed; it is then still listed."""
    if folder.exists():
        shutil.rmtree(folder)
    asset_libraries.remove(folder)


def _asset(compiled: CompiledMaterial, variant: Variant) -> bpy.types.Material:
    requested = NODES if NODES in compiled.forms else AUTO
    form = choose_form(compiled, requested, scene_setup.renderer(bpy.context.scene))
    material = create_material(compiled, form)
    material.name = variant.name
    if not variant.is_even:
        dress(material, compiled)
    data = mark(
        material,
        category=compiled.category,
        description=compiled.description,
        tags=(*compiled.tags, compiled.kind, compiled.status, *synonyms(variant.entry)),
    )
    data.author = NAME
    data.license = "BSD-3-Clause"
    give_picture(material, thumbnail(variant.key))
    return material


@contextlib.contextmanager
def _undisturbed() -> Iterator[None]:
    """Groups of materials in use are not shared meanwhile, and their names are free for the assets."""
    hidden = {
        block: block[groups.DIGEST]
        for block in (*bpy.data.node_groups, *bpy.data.images)
        if groups.DIGEST in block
    }
    for block in hidden:
        block[groups.DIGEST] = ""
    names = {material: material.name for material in bpy.data.materials if material.is_editable}
    for number, material in enumerate(names):
        material.name = f"Nacre, aside {number}"
    try:
        yield
    finally:
        for block, digest in hidden.items():
            block[groups.DIGEST] = digest
        for material, name in names.items():
            material.name = name
