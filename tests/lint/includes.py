# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Which way the C++ sources depend on each other, by their #include lines.

modules   only along the arrows of cpp_tools/cmake/NacreModule.cmake; nothing includes the tool,
          and of the C interface only its own sources and the tests do
folders   of one module, of the tool and of tests/cpp: no circle
files     no circle, where a header and the sources of its name are one: a header whose types are
          wanted below its functions has to be two
sizes     at most MOST_FILES sources and headers in a folder
"""

from __future__ import annotations

import posixpath
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath

MOST_FILES = 25
MODULES = Path("cpp_tools/cmake/NacreModule.cmake")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+["<]([^">]+)[">]', re.M)
SUFFIXES = {".h", ".cpp"}
PUBLIC = "cpp_tools/include/"
# Folders of modules, and those that are one as a whole.
ROOTS = ("cpp_tools/include/nacre/", "cpp_tools/src/")
TOOL, CAPI, TESTS = "tool", "capi", "tests"
WHOLE = {"cpp_tools/apps/nacre/": TOOL, "tests/cpp/": TESTS}

Graph = Mapping[str, set[str]]


def arrows(text: str) -> dict[str, set[str]]:
    """What each module may include of others, by the table of NacreModule.cmake."""
    direct = {
        name: set(depends.replace('""', "").split())
        for name, depends in re.findall(r"^set\(NACRE_DEPENDS_(\w+) ([^)]*)\)", text, re.M)
    }
    reached: dict[str, set[str]] = {}
    for name in re.findall(r"^set\(NACRE_MODULES ([^)]*)\)", text, re.M)[0].split():
        reached[name] = direct[name].union(*(reached[below] for below in direct[name]))
    everything = set(reached)
    return {**reached, CAPI: everything, TOOL: everything, TESTS: {*everything, CAPI}}


class Source:
    """A file and where it stands: in a module, in a folder of it, as a part of a unit."""

    def __init__(self, name: str) -> None:
        self.name = name
        whole = [root for root in WHOLE if name.startswith(root)]
        self.root = whole[0] if whole else next(root for root in ROOTS if name.startswith(root))
        inside = PurePosixPath(name[len(self.root) :])
        if whole:
            self.module = WHOLE[self.root]
        else:
            self.module = inside.parts[0].removesuffix(".h")
            self.root += f"{self.module}/"
            inside = PurePosixPath(*inside.parts[1:]) if len(inside.parts) > 1 else inside
        self.folder = inside.parent.as_posix()
        self.stem = inside.stem


class Sources:
    def __init__(self, root: Path, names: Iterable[str]) -> None:
        self.root = root
        self.files = {name: Source(name) for name in sorted(names)}
        # A public header belongs to the folder of its sources, or else is one of its own.
        homes: dict[tuple[str, str], set[str]] = defaultdict(set)
        for source in self.files.values():
            if not source.name.startswith(PUBLIC):
                homes[source.module, source.stem].add(source.folder)
        for source in self.files.values():
            if source.name.startswith(PUBLIC):
                home = homes[source.module, source.stem]
                source.folder = home.pop() if len(home) == 1 else f"{source.stem}.h"

    def included(self, source: Source) -> Iterator[Source]:
        """Those of ours; what is found nowhere is somebody else's."""
        text = (self.root / source.name).read_text("utf-8", "replace")
        for what in INCLUDE.findall(text):
            beside = posixpath.normpath(PurePosixPath(source.name).parent / what)
            places = [f"{PUBLIC}{what}", beside, f"{source.root}{what}"]
            if source.module == TESTS:  # of the module under test
                module = source.folder.split("/")[0]
                places.append(f"cpp_tools/src/{module}/{what}")
            found = next((self.files[place] for place in places if place in self.files), None)
            if found is not None:
                yield found


def circles(graph: Graph) -> list[list[str]]:
    """One for each node that has not stood in one before; the first node comes again at the end."""
    found: list[list[str]] = []
    done: set[str] = set()

    def visit(node: str, way: list[str]) -> None:
        if node in way:
            found.append([*way[way.index(node) :], node])
            return
        if node in done:
            return
        for below in sorted(graph.get(node, ())):
            visit(below, [*way, node])
        done.add(node)

    for node in sorted(graph):
        visit(node, [])
    return found


def crowded(names: Iterable[str]) -> Iterator[str]:
    folders: dict[str, int] = defaultdict(int)
    for name in names:
        folders[PurePosixPath(name).parent.as_posix()] += 1
    for folder, count in sorted(folders.items()):
        if count > MOST_FILES:
            yield f"{folder}: {count} C++ files; at most {MOST_FILES} in a folder"


def problems(root: Path, tracked: Iterable[str]) -> Iterator[str]:
    names = [
        name
        for name in tracked
        if Path(name).suffix in SUFFIXES and name.startswith((*ROOTS, *WHOLE))
    ]
    yield from crowded(names)
    allowed = arrows((root / MODULES).read_text("utf-8"))
    sources = Sources(root, names)
    units: dict[str, set[str]] = defaultdict(set)
    folders: dict[str, set[str]] = defaultdict(set)
    for source in sources.files.values():
        for other in sources.included(source):
            if source.module != other.module:
                if other.module not in allowed[source.module]:
                    yield f"{source.name}: module {source.module} must not include {other.name}"
                continue
            here, there = f"{source.module}/{source.folder}", f"{other.module}/{other.folder}"
            if here != there:
                folders[here].add(there)
            if (here, source.stem) != (there, other.stem):
                units[f"{here}/{source.stem}"].add(f"{there}/{other.stem}")
    for kind, graph in ("folders", folders), ("files", units):
        for circle in circles(graph):
            yield f"{kind} include each other in a circle: {' -> '.join(circle)}"
