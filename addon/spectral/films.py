# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Films where bands are rendered: beside each table of colours one of reflectances, which has all passes
below each other, and is there while they are rendered. The pass moves the place at which it is read."""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

import bpy
import numpy as np

from ..blender.formula import Formula
from ..core.faults import ForeseenError
from ..core.form import NODES
from ..core.manifest import ManifestError
from ..materials import group as groups
from ..materials.image import SIZE, TABLE, fill, image_of_texels, tables_of
from ..materials.material import group_node
from ..materials.recipe import RecipeError, recipe, recipe_of_group
from . import attributes
from .forms import reads_tables
from .groups import choice, end
from .marks import BANDED, BEFORE, MADE
from .plan import Plan
from .report import Remark, Report

_TABLE, _COLUMNS, _ROWS, _STACKED = "table", "columns", "rows", "stacked"
"""Names of the nodes that read the picture of all passes, and that say how they lie in it: the last is 0
where it has one pass alone."""
_ANGLES_DEG = (0.0, 45.0, 75.0)
_HARDLY = 1e-9
MOST_TEXELS = 16384
"""Along an axis, of what every GPU that Blender runs on takes."""


class FilmError(ForeseenError):
    """A film cannot be rendered in bands."""


def has_tables(tree: bpy.types.NodeTree) -> bool:
    """Whether a group is that of a film: of ours, and reads tables."""
    return groups.MATERIAL in tree and reads_tables(tree)


def is_banded(tree: bpy.types.NodeTree) -> bool:
    """Whether its tables are read in bands."""
    return groups.MATERIAL in tree and any(_banded(tree))


def convert(tree: bpy.types.NodeTree, report: Report) -> None:
    """Tables that are read in bands already are left alone, as are films in OSL."""
    if tree.get(groups.FORM) != NODES:
        return
    try:
        recipe_of_group(tree, tree.name)
    except (RecipeError, ManifestError) as error:
        text = f"{error}; its colours are taken for mixtures of three spectra"
        report.remarks.append(Remark("node group", tree.name, text))
        return
    for node in list(tables_of(tree)):
        output, place = node.outputs["Color"], node.inputs["Vector"]
        targets = [link.to_socket for link in output.links]
        if not place.is_linked or any(MADE in target.node for target in targets):
            continue
        banded = tree.nodes.new("ShaderNodeGroup")
        banded[MADE] = True
        banded.location = (node.location.x + 40.0, node.location.y - 60.0)
        banded.hide = True
        banded.node_tree = _reader(tree, node.image)
        tree.links.new(output, banded.inputs[BEFORE])
        tree.links.new(place.links[0].from_socket, banded.inputs["Vector"])
        for target in targets:
            tree.links.new(banded.outputs["Color"], target)
        report.spectra += 1


def _banded(tree: bpy.types.NodeTree) -> Iterator[bpy.types.ShaderNodeGroup]:
    for node in tree.nodes:
        if node.type == "GROUP" and node.node_tree is not None and BANDED in node.node_tree:
            yield node


def _reader(tree: bpy.types.NodeTree, image: bpy.types.Image) -> bpy.types.NodeTree:
    """*Before* without bands; else what the table of all passes has at *Vector*, in its pass."""
    for node in _banded(tree):
        if node.node_tree[BANDED] == image[TABLE]:
            return node.node_tree
    reader = bpy.data.node_groups.new(f"Bands of {image.name}"[:63], "ShaderNodeTree")
    reader[BANDED] = image[TABLE]
    for name, kind in ((BEFORE, "Color"), ("Vector", "Vector")):
        reader.interface.new_socket(name, in_out="INPUT", socket_type=f"NodeSocket{kind}")
    reader.interface.new_socket("Color", in_out="OUTPUT", socket_type="NodeSocketColor")
    formula = Formula(reader)
    inputs = formula.node("NodeGroupInput").outputs
    counts = [_number(formula, name) for name in (_COLUMNS, _ROWS, _STACKED)]
    number = attributes.number(formula, attributes.PASS)
    table = _cell(formula, inputs["Vector"], number, counts, _size(image))
    table.name = _TABLE
    end(formula, choice(formula, inputs[BEFORE], table.outputs["Color"]))
    return reader


def _cell(
    formula: Formula,
    vector: bpy.types.NodeSocket,
    number: bpy.types.NodeSocket,
    counts: Sequence[bpy.types.NodeSocket],
    size: tuple[int, int],
) -> bpy.types.ShaderNodeTexImage:
    """The node that reads the table of a pass in the picture of all of them."""
    place = formula.node("ShaderNodeSeparateXYZ")
    formula.put(vector, place.inputs[0])
    columns, rows, stacked = counts
    number = formula.number("MULTIPLY", number, stacked)
    column = formula.number(
        "FLOOR", formula.number("DIVIDE", formula.number("ADD", number, 0.5), rows)
    )
    row = formula.number("SUBTRACT", number, formula.number("MULTIPLY", column, rows))
    moved = formula.node("ShaderNodeCombineXYZ")
    for axis, cell, cells in ((0, column, columns), (1, row, rows)):
        edge = 0.5 / size[axis]  # centres of the outer texels: no other pass is mixed in
        held = formula.number("MAXIMUM", place.outputs[axis], edge)
        within = formula.number("MINIMUM", held, 1.0 - edge)
        at = formula.number("DIVIDE", formula.number("ADD", cell, within), cells)
        formula.put(at, moved.inputs[axis])
    table = formula.node("ShaderNodeTexImage", interpolation="Linear", extension="EXTEND")
    table.name = _TABLE
    formula.put(moved.outputs[0], table.inputs["Vector"])
    return table


def read_by_channel(
    reader: bpy.types.NodeTree,
    numbers: Sequence[bpy.types.NodeSocket],
    masks: Sequence[bpy.types.NodeSocket],
) -> bpy.types.NodeSocket:
    """What a reader has in three bands that are of different passes: for each the number of the pass, and 1 in
    the channel that it has there, 0 in the others. Once the picture of all passes is in place."""
    formula, nodes = Formula(reader), reader.nodes
    counts = [nodes[name].outputs[0] for name in (_COLUMNS, _ROWS, _STACKED)]
    image = nodes[_TABLE].image
    size = tuple(
        round(side / count.default_value)
        for side, count in zip(image.size, counts[:2], strict=True)
    )
    vector = next(node for node in nodes if node.type == "GROUP_INPUT").outputs["Vector"]
    together = formula.node("ShaderNodeCombineXYZ")
    for number, mask, channel in zip(numbers, masks, together.inputs, strict=True):
        table = _cell(formula, vector, number, counts, size)
        table.image = image
        formula.put(formula.vector("DOT_PRODUCT", table.outputs["Color"], mask), channel)
    return together.outputs[0]


def links_of_table(
    reader: bpy.types.NodeTree,
) -> list[tuple[bpy.types.NodeSocket, bpy.types.NodeSocket]]:
    """From the picture of all passes to what reads it."""
    output = reader.nodes[_TABLE].outputs["Color"]
    return [(link.from_socket, link.to_socket) for link in output.links]


def _number(formula: Formula, name: str) -> bpy.types.NodeSocket:
    node = formula.node("ShaderNodeValue")
    node.name = node.label = name
    node.outputs[0].default_value = 1.0
    return node.outputs[0]


def _size(image: bpy.types.Image) -> tuple[int, int]:
    width, height = image.get(SIZE, image.size)
    return int(width), int(height)


@dataclass(frozen=True)
class Film:
    """A group whose tables are read in bands, and what it is made from at present."""

    tree: bpy.types.ShaderNodeTree
    template: str

    @property
    def sizes(self) -> dict[str, tuple[int, int]]:
        """(height, width) by table."""
        found = {}
        for node in _banded(self.tree):
            image = node.inputs[BEFORE].links[0].from_node.image
            width, height = _size(image)
            found[image[TABLE]] = (height, width)
        return found

    @property
    def optical_thickness_nm(self) -> float:
        import nacre

        with _told():
            return nacre.optical_thickness(self.template, self.tree.name)


@lru_cache(maxsize=64)
def _fringes(template: str, name: str) -> np.ndarray:
    """Reflectances (N, 471) that bands have to show, head on and from aside. Some stacks take seconds, and
    each lamp that changes asks again. Raises FilmError."""
    import nacre

    with _told():
        return np.concatenate(
            [nacre.film_fringes(template, file=name, angle_deg=angle) for angle in _ANGLES_DEG]
        )


@contextlib.contextmanager
def _told() -> Iterator[None]:
    import nacre

    try:
        yield
    except nacre.NacreError as error:
        raise FilmError(str(error)) from error


def films() -> list[Film]:
    """All of the file that are in use."""
    edited = {}
    for material in bpy.data.materials:
        node = group_node(material)
        if node is not None and is_banded(node.node_tree):
            edited[node.node_tree] = recipe(material).template
    return [
        Film(tree, edited.get(tree) or recipe_of_group(tree, tree.name).template)
        for tree in bpy.data.node_groups
        if tree.users and is_banded(tree)
    ]


def fringes() -> tuple[list[float], np.ndarray]:
    """What bands are chosen by: optical thicknesses and reflectances (…, 471). Thicknesses differ hardly, so
    that each has to be right, and not their mean. Raises FilmError."""
    thicknesses: list[float] = []
    reflectances = [np.empty((0, 471))]
    for film in {film.template: film for film in films()}.values():
        thickness_nm = film.optical_thickness_nm
        if thickness_nm > 0.0:
            rows = _fringes(film.template, film.tree.name)
            apart = np.arange(len(thicknesses), len(thicknesses) + len(rows))
            thicknesses += list(thickness_nm * (1.0 + _HARDLY * apart))
            reflectances.append(rows)
    return thicknesses, np.concatenate(reflectances)


def digest() -> str:
    """Of what all films are made from."""
    found = hashlib.sha256()
    for film in sorted(films(), key=lambda film: film.tree.name):
        found.update(f"{film.tree.name}\0{film.template}\0".encode())
    return found.hexdigest()


@contextlib.contextmanager
def in_bands(plan: Plan, *, at_once: bool) -> Iterator[Callable[[int], None]]:
    """Tables are in place: those of all passes `at_once`, or those of the pass that what is yielded was
    called with last. Raises FilmError."""
    made: list[tuple[bpy.types.Image, np.ndarray]] = []
    seen: set[bpy.types.NodeTree] = set()

    def show(number: int) -> None:
        for image, texels in made if not at_once else ():
            fill(image, texels[plan.triple(number)])

    try:
        for film in films():
            seen |= _readers_of_its_own(film.tree, seen)
            for name, texels in _tables_of_passes(film, plan).items():
                shown = _in_columns(texels) if at_once else texels[0]
                image = image_of_texels(f"{film.tree.name} {name} in bands", shown)
                made.append((image, texels))
                for reader in _readers(film.tree):
                    if reader[BANDED] == name:
                        _put(reader, image, texels.shape, at_once=at_once)
        yield show
    finally:
        for image, _ in made:  # nodes that have it have none then
            bpy.data.images.remove(image)


def _readers_of_its_own(
    tree: bpy.types.NodeTree, others: set[bpy.types.NodeTree]
) -> set[bpy.types.NodeTree]:
    """Groups that read its tables; one that was copied shares them with what it is a copy of."""
    copies = {shared: shared.copy() for shared in _readers(tree) & others}
    for node in _banded(tree):
        node.node_tree = copies.get(node.node_tree, node.node_tree)
    return _readers(tree)


def _readers(tree: bpy.types.NodeTree) -> set[bpy.types.NodeTree]:
    return {node.node_tree for node in _banded(tree)}


def _tables_of_passes(film: Film, plan: Plan) -> dict[str, np.ndarray]:
    """(P, height, width, 3) by table; computed once for all frames of a plan."""
    import nacre

    sizes = film.sizes
    key = (film.template, tuple(sorted(sizes.items())))
    if key not in plan.kept:
        passes = [plan.indices(number) for number in range(plan.triples)]
        with _told():
            plan.kept[key] = nacre.band_tables(
                film.template, plan.bands, passes, sizes, film.tree.name
            )
    return plan.kept[key]


def _put(
    reader: bpy.types.NodeTree, image: bpy.types.Image, shape: tuple[int, ...], *, at_once: bool
) -> None:
    """`shape`: of the tables of all passes."""
    _, height, width, _ = shape
    nodes = reader.nodes
    nodes[_TABLE].image = image
    nodes[_COLUMNS].outputs[0].default_value = image.size[0] / width
    nodes[_ROWS].outputs[0].default_value = image.size[1] / height
    nodes[_STACKED].outputs[0].default_value = float(at_once)


def _in_columns(texels: np.ndarray) -> np.ndarray:
    """(height, width, 3) with all passes from the bottom up, where v begins, then the next column of
    them."""
    passes, height, width, channels = texels.shape
    columns = -(-passes * height // MOST_TEXELS)
    rows = -(-passes // columns)
    cells = np.zeros((columns * rows, height, width, channels), np.float32)
    cells[:passes] = texels
    grid = cells.reshape(columns, rows, height, width, channels)[:, ::-1].transpose(1, 2, 0, 3, 4)
    return grid.reshape(rows * height, columns * width, channels)
