# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Which films go through every form, roughness and Blender, and which through one of them.

Most films are the same program with other tables. Their shape is what is left of a compiled program
once numbers, texts and the count of its lobes are taken away; each shape has one film that stands for
it. NACRE_SOAK=1 makes every film a representative.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from functools import cache
from itertools import product

from blender.harness import VERSIONS
from support.paths import manifest, materials_folder
from support.truth import layers_of, material_template, thicknesses, varied

FORMS = ("osl", "nodes")
_NUMBER = re.compile(r"(?<![A-Za-z])\d+(\.\d*)?(e[-+]?\d+)?")


def versions() -> tuple[str, ...]:
    """Of the Blenders that are there; all where none is named, whose tests then say so."""
    return tuple(version for version, name in VERSIONS.items() if os.environ.get(name)) or (
        *VERSIONS,
    )


@cache
def films() -> tuple[str, ...]:
    """Compiled materials of that kind, by name."""
    folders = sorted(materials_folder().glob("*/*.json"))
    names = [file.stem for file in folders if file.stem == file.parent.name]
    found = tuple(name for name in names if manifest(name)["kind"] == "film")
    assert found, f"{materials_folder()} holds no compiled films; ./dev setup makes them"
    return found


@cache
def program(material: str) -> str:
    return (materials_folder() / material / f"{material}.osl").read_text("utf-8")


def program_shape(text: str) -> list[str]:
    """Lines of the shader itself without metadata, names and numbers; equal ones in a row, as lobes
    and their tables are, count once."""
    body = text[re.search(r"^shader ", text, re.M).start() :]
    body = re.sub(r"\[\[.*?\]\],?", "", body, flags=re.S)
    body = re.sub(r"^shader \w+", "shader", body)
    body = re.sub(r'"[^"]*"', '""', body)
    lines: list[str] = []
    for line in _NUMBER.sub("#", body).replace("-#", "#").splitlines():
        text = line.strip().rstrip(",")
        if text and (not lines or lines[-1] != text):
            lines.append(text)
    return lines


def _graph_shape(graph: dict | None) -> list:
    """Kinds of nodes and of links between them; sizes of tables are in the names."""
    if graph is None:
        return []

    def kind(text: str) -> str:
        return re.sub(r"\d+", "#", text)

    nodes = {
        json.dumps([node["type"], kind(node["id"]), node.get("properties")], sort_keys=True)
        for node in graph["nodes"]
    }
    links = {(kind(start), kind(end)) for start, end in graph["links"]}
    return [sorted(nodes), sorted(links)]


@cache
def shape(material: str) -> str:
    """Of its program and of its node graph, as a hash."""
    parts = [
        program_shape(program(material)),
        _graph_shape(manifest(material)["graphs"].get("nodes")),
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:12]


def lobes(material: str) -> int:
    schlick = manifest(material).get("schlick")
    return len(schlick["exponents"]) if schlick else 0


def coherent_nm(material: str) -> float:
    """Thickness of its coherent layers at the end of their range."""
    template = material_template(material)
    axis = varied(template)
    layers = zip(layers_of(template), thicknesses(template, axis and axis["max"]), strict=True)
    return sum(nm for layer, nm in layers if layer.get("coherent", True))


def representatives() -> dict[str, str]:
    """Films that go through the full product, and why."""
    return dict.fromkeys(films(), "all do") if os.environ.get("NACRE_SOAK") else chosen()


@cache
def chosen() -> dict[str, str]:
    """Those that stand for the others: where the truth is stored, there is that of them."""
    found: dict[str, str] = {}
    for name in sorted(films(), key=lambda name: (-lobes(name), name)):
        if shape(name) not in map(shape, found):
            found[name] = "most lobes of its shape"
    for why, measure in (
        ("most lobes", lobes),
        ("thickest", coherent_nm),
        ("furthest out of gamut", lambda name: -manifest(name)["gamut"]["lowest"]),
    ):
        found.setdefault(max(films(), key=measure), why)
    return found


def number(*words: object) -> int:
    """The same for the same words on every machine."""
    text = "/".join(map(str, words))
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:6], "big")


def ways(material: str, quantity: str, *more: tuple) -> list[tuple]:
    """(version, form, …) that a film is held to for a quantity: all of `more` too if it is a
    representative, else one of each, by a hash of both names."""
    if material in representatives():
        return list(product(VERSIONS, FORMS, *more))
    choices = (versions(), FORMS, *more)
    return [
        tuple(some[number(material, quantity, at) % len(some)] for at, some in enumerate(choices))
    ]
