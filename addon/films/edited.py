# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stack that a material carries: stored as the text of its template, compiled while it is edited.

Each edit puts quick tables into the material's own images at once. The whole material, with stated
errors, fits and shader, is compiled aside a moment later (`finish`, or the timer of live.py).
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from functools import lru_cache, partial

import bpy

from ..blender import space
from ..core.computation import library_problem
from ..core.faults import RecipeError
from ..core.light import FIRST_NM, LAST_NM
from ..core.manifest import CompiledMaterial, ManifestError
from ..materials import group as groups
from ..materials import schema
from ..materials.image import TABLE, fill
from ..materials.material import asked_form, group_node
from ..materials.recipe import (
    Recipe,
    compile_recipe,
    is_edited,
    put_in_place,
    recipe,
    set_recipe,
)
from . import media as keys
from .stack import Stack, StackError, parse_medium, read_stack, write_template


def media() -> list[tuple[str, str]]:
    """Key and name of what can be a medium: air, and the library; nothing without the package."""
    if library_problem():
        return []
    import nacre

    keys = nacre.library.keys()
    return [("air", ""), *((key, _name_of(key)) for key in keys)]


def _name_of(key: str) -> str:
    """As it is now: a file of the user's own may be edited at any time."""
    import nacre

    try:
        return nacre.library.medium(key).name
    except nacre.NacreError:  # a file of the user's own that cannot be read; choosing it says why
        return ""


def meant(text: str) -> str:
    """The key that was meant by a name, as typed: `copper`, `Water`, `cu`, `fe/johnson`; the text itself
    where it is something else, or could mean several things."""
    try:
        medium = parse_medium(text)
    except StackError:
        return text
    return keys.meant(medium["medium"], media()) if "medium" in medium else text


def medium_name(text: str) -> str:
    """What a list shows of a medium: its name in the library, or what was typed."""
    is_key = "/" in text and not text.startswith("sellmeier")
    return (_name_of(text) if is_key and not library_problem() else "") or text


def stack_of(material: bpy.types.Material) -> Stack:
    return read_stack(recipe(material).template)


def damage(material: bpy.types.Material) -> str:
    """What is wrong with the stored stack, or nothing."""
    try:
        wanted = recipe(material)
    except RecipeError as error:
        return str(error)
    return _damage(wanted.template) or _unknown_light(wanted.conditions.illuminant)


def _unknown_light(name: str) -> str:
    if library_problem():
        return ""
    import nacre

    try:
        nacre.illuminant(name)
    except nacre.NacreError as error:
        return str(error)
    return ""


@lru_cache(maxsize=64)
def _damage(template: str) -> str:
    try:
        read_stack(template)
    except StackError as error:
        return str(error)
    return ""


def set_stack(material: bpy.types.Material, stack: Stack) -> None:
    before = recipe(material)
    set_recipe(material, Recipe(write_template(stack), before.conditions))


def is_stale(material: bpy.types.Material) -> bool:
    """Whether the nodes were compiled from another recipe, or hold quick tables."""
    node = group_node(material)
    if not is_edited(material) or node is None:
        return False
    try:
        wanted = recipe(material)
    except RecipeError:
        return False
    if node.node_tree.get(groups.RECIPE) == wanted.digest:
        return False  # the usual case, told without reading the template
    return not damage(material) and not schema.refusal(node.node_tree)


def preview(material: bpy.types.Material) -> bool:
    """Puts quick tables into the material's images. False where the edit changes more than
    texels, which `finish` is needed for."""
    wanted = recipe(material)
    if not _same_shape(material, wanted):
        return False
    images = _images(_own_group(material))
    if images is None:
        return False
    matrix = space.to_file()
    for name, texels in _quick_tables(wanted, _sizes(images), material.name).items():
        fill(images[name], texels, matrix)
        space.state(images[name])
    return True


def preview_task(material: bpy.types.Material) -> Callable[[], object] | None:
    """What `preview` computes, for another thread."""
    images = _images(group_node(material).node_tree)
    if images is None:
        return None
    return partial(_quick_tables, recipe(material), _sizes(images), material.name)


def known(material: bpy.types.Material) -> tuple[str, Recipe] | None:
    """What the colours of a film depend on: the library's entries at present, and the recipe. None
    where they cannot be computed; the panel says what is wrong with an edit."""
    if library_problem():
        return None
    try:
        wanted = recipe(material)
        return library_digest(wanted), wanted
    except (RecipeError, ManifestError, ValueError):
        return None


def library_digest(wanted: Recipe) -> str:
    """Of what the library has at present for the names in a recipe, where a user may edit entries."""
    import nacre

    found = hashlib.sha256()
    for look_up in (
        *(partial(_indices, key) for key in _media_of(wanted.template)),
        lambda: nacre.illuminant(wanted.conditions.illuminant),
    ):
        try:
            found.update(look_up().tobytes())
        except nacre.NacreError as error:  # what cannot be read now may be mended
            found.update(str(error).encode())
    return found.hexdigest()


@lru_cache(maxsize=64)
def _media_of(template: str) -> tuple[str, ...]:
    """The keys of the library that a film is made of."""
    stack = read_stack(template)
    texts = {stack.ambient, stack.substrate, *(layer.medium for layer in stack.layers)}
    keys = {parse_medium(text).get("medium") for text in texts}
    return tuple(sorted(keys - {None, "air", "vacuum"}))


def _indices(key: str):
    import numpy as np  # here as wherever texels are made: some distributions' Blender has none

    import nacre

    medium = nacre.library.medium(key)
    grid = np.arange(FIRST_NM, LAST_NM + 1.0)
    return medium.index(np.clip(grid, *medium.range_nm))


def _quick_tables(wanted: Recipe, sizes: Mapping[str, tuple[int, int]], name: str):
    import nacre

    return nacre.preview_tables(wanted.template, sizes, name, **wanted.conditions._asdict())


def _images(tree: bpy.types.ShaderNodeTree) -> dict[str, bpy.types.Image] | None:
    """By table; None where one is missing or not known."""
    images = {node.image for node in tree.nodes if node.type == "TEX_IMAGE"}
    if not all(image is not None and TABLE in image for image in images):
        return None
    return {image[TABLE]: image for image in images}


def _sizes(images: Mapping[str, bpy.types.Image]) -> dict[str, tuple[int, int]]:
    return {name: (image.size[1], image.size[0]) for name, image in images.items()}


def apply(material: bpy.types.Material, compiled: CompiledMaterial, made_from: Recipe) -> None:
    """Puts what was compiled in place; values and links are kept."""
    old = group_node(material).node_tree
    put_in_place(material, compiled, made_from, asked_form(material))
    if old != group_node(material).node_tree and old.users == 0:
        groups.remove(old)


def finish(material: bpy.types.Material) -> None:
    """Compiles, at once, what is stale."""
    if is_stale(material):
        wanted = recipe(material)
        apply(material, compile_recipe(wanted, material.name), wanted)


def _same_shape(material: bpy.types.Material, wanted: Recipe) -> bool:
    """Whether only texels differ between the compiled text and the wanted one."""
    tree = group_node(material).node_tree
    try:
        old = read_stack(tree.get(groups.TEMPLATE_TEXT, ""))
    except StackError:
        return False
    new = read_stack(wanted.template)
    return (
        (old.varying is None) == (new.varying is None)
        and (new.varying is None or old.range_nm == new.range_nm)
        and old.rest == new.rest
        and (old.ambient == old.substrate) == (new.ambient == new.substrate)
    )


def _own_group(material: bpy.types.Material) -> bpy.types.ShaderNodeTree:
    """The material's group, with images, for it alone and not to be found for others."""
    node = group_node(material)
    tree = node.node_tree
    if not _is_alone(tree):
        tree = tree.copy()
        node.node_tree = tree
        tree[groups.DIGEST] = ""
        copies: dict[bpy.types.Image, bpy.types.Image] = {}
        for inner in tree.nodes:
            if inner.type == "TEX_IMAGE" and inner.image is not None:
                if inner.image not in copies:
                    copies[inner.image] = inner.image.copy()
                    copies[inner.image][groups.DIGEST] = ""
                inner.image = copies[inner.image]
    tree[groups.RECIPE] = ""
    return tree


def _is_alone(tree: bpy.types.ShaderNodeTree) -> bool:
    """Whether nothing else uses the group or its images, nor would find them by their digests."""
    if tree.get(groups.DIGEST) or tree.users > 1 or tree.library is not None:
        return False
    used = [node.image for node in tree.nodes if node.type == "TEX_IMAGE" and node.image]
    return all(
        not image.get(groups.DIGEST) and image.library is None and image.users <= used.count(image)
        for image in used
    )
