# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Which folder of Python may import which, and how many files are in one.

The extension's packages import one way: LOWEST in this order, then features, which make no circle, then
HIGHEST, then the modules beside them. What is in core works without Blender; no code asks for a kind of
material by its name but in that kind's package. No test imports another.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXTENSION = "addon"
LOWEST = ("core", "blender", "materials")
HIGHEST = ("background",)
WITHOUT_BLENDER = ("core",)
OF_BLENDER = {"bpy", "bmesh", "mathutils", "gpu", "bl_ui"}
KINDS = {"film": "films", "grating": "", "glass": ""}  # and their packages, where there are any
SOURCES = ("addon", "tests", "cpp_tools/python")
MOST_FILES = 25
NO_SOURCES = {"fixtures", "__pycache__"}

Package = str
Where = str


def parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text("utf-8"), str(path))


def imported(tree: ast.Module, package: tuple[str, ...]) -> Iterator[tuple[str, int]]:
    """Dotted names of what a module of a package imports, wherever in it, and the lines. What is imported
    from something may be a module of it, and is named as one."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else ()
            start = ".".join((*above, *filter(None, [node.module])))
            yield from ((f"{start}.{alias.name}".strip("."), node.lineno) for alias in node.names)


# ---- Packages of the extension -------------------------------------------------------------------


def arrows(folder: Path) -> dict[tuple[Package, Package], Where]:
    """From package to package of the extension in a folder, each with one place where it is imported."""
    names = {path.parent.name for path in folder.glob("*/__init__.py")}
    found: dict[tuple[Package, Package], Where] = {}
    for path in sorted(folder.rglob("*.py")):
        parts = path.relative_to(folder).parts
        if len(parts) == 1:
            continue  # above all
        package = (EXTENSION, *parts[:-1])
        for name, line in imported(parsed(path), package):
            top, _, rest = name.partition(".")
            target = rest.partition(".")[0]
            if top == EXTENSION and target != parts[0]:
                where = f"{folder.name}/{'/'.join(parts)}:{line}"
                found.setdefault((parts[0], target if target in names else ""), where)
    return found


def height(package: Package) -> int:
    """Features are all as high; the modules beside the packages, which have no name, are above all."""
    if package in LOWEST:
        return LOWEST.index(package)
    if not package:
        return len(LOWEST) + len(HIGHEST) + 1
    return len(LOWEST) + (HIGHEST.index(package) + 1 if package in HIGHEST else 0)


def upward(found: Mapping[tuple[Package, Package], Where]) -> Iterator[str]:
    for (package, target), where in found.items():
        if height(target) > height(package):
            of = target or f"the modules of {EXTENSION}/"
            yield f"{where}: {package} must not import {of}, which is above it"


def circles(found: Iterable[tuple[Package, Package]]) -> Iterator[str]:
    """Those that a walk along the arrows meets."""
    below: dict[Package, list[Package]] = {}
    for package, target in sorted(found):
        below.setdefault(package, []).append(target)
    done: set[Package] = set()

    def walk(package: Package, way: tuple[Package, ...]) -> Iterator[str]:
        if package in way:
            circle = way[way.index(package) :]
            first = circle.index(min(circle))
            around = (*circle[first:], *circle[:first], circle[first])
            yield f"{EXTENSION}: packages import each other: {' <- '.join(reversed(around))}"
        elif package not in done:
            for target in below.get(package, ()):
                yield from walk(target, (*way, package))
            done.add(package)

    for package in sorted(below):
        yield from walk(package, ())


def without_blender(folder: Path) -> Iterator[str]:
    for package in WITHOUT_BLENDER:
        for path in sorted((folder / package).rglob("*.py")):
            for name, line in imported(parsed(path), (EXTENSION, package)):
                if name.partition(".")[0] in OF_BLENDER:
                    where = f"{folder.name}/{path.relative_to(folder).as_posix()}:{line}"
                    yield f"{where}: {package} works without Blender (imports {name})"


def kinds_by_name(folder: Path) -> Iterator[str]:
    """What a material may be asked for is in its manifest, so that another kind needs no code."""
    for path in sorted(folder.rglob("*.py")):
        parts = path.relative_to(folder).parts
        for node in ast.walk(parsed(path)):
            kind = node.value if isinstance(node, ast.Constant) else None
            if isinstance(kind, str) and kind in KINDS and parts[0] != KINDS[kind]:
                where = f"{folder.name}/{'/'.join(parts)}:{node.lineno}"
                yield f"{where}: {kind!r} is a kind; ask the traits of the material"


# ---- Tests, and sizes ----------------------------------------------------------------------------


def tests_of_tests(root: Path) -> Iterator[str]:
    for path in sorted((root / "tests").rglob("*.py")):
        for name, line in imported(parsed(path), ("tests", *path.relative_to(root).parts[1:-1])):
            part = next((part for part in name.split(".") if part.startswith("test_")), None)
            if part is not None and (path.parent / f"{part}.py").is_file():
                yield (
                    f"{path.relative_to(root).as_posix()}:{line}: no test imports another ({part}); what "
                    "they share is in tests/support"
                )


def large_folders(root: Path) -> Iterator[str]:
    for name in SOURCES:
        for folder in [root / name, *(root / name).rglob("*")]:
            where = folder.relative_to(root)
            if not folder.is_dir() or NO_SOURCES & set(where.parts):
                continue
            count = len(list(folder.glob("*.py")))
            if count > MOST_FILES:
                yield f"{where.as_posix()}: {count} files of Python; at most {MOST_FILES} in a folder"


def problems(root: Path) -> list[str]:
    folder = root / EXTENSION
    found = arrows(folder)
    return [
        *(list(upward(found)) or circles(found)),  # an arrow that is wrong makes circles
        *without_blender(folder),
        *kinds_by_name(folder),
        *tests_of_tests(root),
        *large_folders(root),
    ]


def main() -> int:
    found = problems(ROOT)
    print("\n".join([*found, f"imports: {len(found)} problems"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
