# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The node graph of a compiled material as data; see cpp_tools/doc/manifest.md, "Graphs"."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from typing import Any

GROUP_INPUT = "input"
GROUP_OUTPUT = "output"


@dataclass(frozen=True)
class Endpoint:
    """One end of a link: a node and its socket by identifier, name or index."""

    node: str
    socket: str

    @classmethod
    def parse(cls, text: str) -> Endpoint:
        node, _, socket = text.partition(".")
        return cls(node, socket)

    def __str__(self) -> str:
        return f"{self.node}.{self.socket}"


@dataclass(frozen=True)
class Node:
    id: str
    type: str
    properties: dict[str, Any] = field(default_factory=dict)
    values: dict[str, Any] = field(default_factory=dict)
    table: str | None = None


@dataclass(frozen=True)
class Graph:
    nodes: tuple[Node, ...]
    links: tuple[tuple[Endpoint, Endpoint], ...]

    @property
    def lets_light_straight_through(self) -> bool:
        return any(node.type == "ShaderNodeBsdfTransparent" for node in self.nodes)

    @property
    def refracts_light(self) -> bool:
        bodies = ("ShaderNodeBsdfGlass", "ShaderNodeBsdfRefraction")
        return any(node.type in bodies for node in self.nodes)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Of the group, in the order in which they are first fed."""
        fed = (target.socket for _, target in self.links if target.node == GROUP_OUTPUT)
        return tuple(dict.fromkeys(fed))

    def depths(self) -> dict[str, int]:
        """Columns for drawing: the longest way from each node to the group's output, which has 0."""
        into: dict[str, list[str]] = {}
        for source, target in self.links:
            into.setdefault(target.node, []).append(source.node)
        depths = {GROUP_OUTPUT: 0}
        pending = [GROUP_OUTPUT]
        while pending:
            node = pending.pop()
            for source in into.get(node, ()):
                if depths.get(source, -1) < depths[node] + 1 <= len(self.nodes) + 1:
                    depths[source] = depths[node] + 1
                    pending.append(source)
        return depths


def parse_graph(
    data: Any, where: str, sockets: Collection[str], tables: Collection[str], problems: list[str]
) -> Graph | None:
    """Reads one graph; appends every fault to `problems` and then returns None."""
    before = len(problems)
    if not isinstance(data, dict):
        problems.append(f"{where}: must be an object with nodes and links (got {data!r})")
        return None
    nodes = _parse_nodes(data.get("nodes"), f"{where}.nodes", tables, problems)
    links = _parse_links(data.get("links"), f"{where}.links", nodes, sockets, problems)
    return Graph(nodes, links) if len(problems) == before else None


def _parse_nodes(
    data: Any, where: str, tables: Collection[str], problems: list[str]
) -> tuple[Node, ...]:
    if not isinstance(data, list):
        problems.append(f"{where}: must be a list (got {data!r})")
        return ()
    nodes: dict[str, Node] = {}
    for index, item in enumerate(data):
        at = f"{where}[{index}]"
        if not isinstance(item, dict) or not all(
            isinstance(item.get(k), str) for k in ("id", "type")
        ):
            problems.append(f"{at}: must be an object with an id and a type (got {item!r})")
            continue
        if item["id"] in nodes or item["id"] in (GROUP_INPUT, GROUP_OUTPUT):
            problems.append(f"{at}.id: must be unique and not input or output (got {item['id']!r})")
        table = item.get("table")
        if table is not None and table not in tables:
            allowed = ", ".join(tables) or "none"
            problems.append(f"{at}.table: must be one of the tables: {allowed} (got {table!r})")
        nodes[item["id"]] = Node(
            item["id"], item["type"], item.get("properties", {}), item.get("values", {}), table
        )
    return tuple(nodes.values())


def _parse_links(
    data: Any,
    where: str,
    nodes: tuple[Node, ...],
    sockets: Collection[str],
    problems: list[str],
) -> tuple[tuple[Endpoint, Endpoint], ...]:
    if not isinstance(data, list):
        problems.append(f"{where}: must be a list (got {data!r})")
        return ()
    ids = {node.id for node in nodes}
    links = []
    for index, item in enumerate(data):
        at = f"{where}[{index}]"
        if (
            not isinstance(item, list)
            or len(item) != 2
            or not all(isinstance(e, str) for e in item)
        ):
            problems.append(f"{at}: must be a pair of node.socket (got {item!r})")
            continue
        source, target = (Endpoint.parse(end) for end in item)
        if source.node not in ids | {GROUP_INPUT}:
            problems.append(f"{at}: no node {source.node!r}")
        if target.node not in ids | {GROUP_OUTPUT}:
            problems.append(f"{at}: no node {target.node!r}")
        if source.node == GROUP_INPUT and source.socket not in sockets:
            allowed = ", ".join(sockets)
            problems.append(f"{at}: input must name a socket: {allowed} (got {source.socket!r})")
        links.append((source, target))
    return tuple(links)
