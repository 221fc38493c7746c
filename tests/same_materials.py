# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Whether two builds compile the same materials: shaders and tables byte for byte, manifests but for
fields that were added.

    python3 tests/same_materials.py BEFORE/share/nacre/materials AFTER/share/nacre/materials

Where a shader's text differs and both have been compiled (.oso), the instructions are compared: what
the renderer runs, without names of files and numbers of lines.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

# What oslc says of where an instruction stood.
_HINTS = re.compile(r"\s*%(filename|line)\{[^}]*\}")


def added(before: Any, after: Any, where: str = "") -> Iterator[str]:
    """Paths at which `after` has what `before` has not; changes begin with `!`."""
    if isinstance(before, dict) and isinstance(after, dict):
        for key in before.keys() - after.keys():
            yield f"!{where}/{key} is gone"
        for key in after.keys() - before.keys():
            yield f"{where}/{key}"
        for key in before.keys() & after.keys():
            yield from added(before[key], after[key], f"{where}/{key}")
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        for one, other in zip(before, after, strict=True):
            yield from added(one, other, f"{where}[]")
    elif before != after:
        yield f"!{where} was {before!r}, is {after!r}"


def _instructions(path: Path) -> str:
    return _HINTS.sub("", path.read_text())


def _same_program(before: Path, after: Path) -> bool:
    compiled = [path.with_suffix(".oso") for path in (before, after)]
    return all(path.is_file() for path in compiled) and _instructions(compiled[0]) == _instructions(
        compiled[1]
    )


def differences(before: Path, after: Path, fields: Counter[str]) -> Iterator[str]:
    """One line each; `fields` counts what manifests have gained."""
    for folder in (before, after):
        if not folder.is_dir():
            sys.exit(f"{folder}: no such folder")
    names = [{p.relative_to(d) for p in d.rglob("*") if p.is_file()} for d in (before, after)]
    known = {path.parts[0] for path in names[0]}
    for name in sorted(names[0] ^ names[1]):
        if name.parts[0] in known:
            yield f"{name}: only {'before' if name in names[0] else 'after'}"
    for name in sorted(names[0] & names[1]):
        one, other = before / name, after / name
        if name.suffix == ".json":
            for path in added(json.loads(one.read_text()), json.loads(other.read_text())):
                if path.startswith("!"):
                    yield f"{name}: {path[1:]}"
                else:
                    fields[path] += 1
        elif name.suffix == ".oso":
            if _instructions(one) != _instructions(other):
                yield f"{name}: other instructions"
        elif one.read_bytes() != other.read_bytes() and not (
            name.suffix == ".osl" and _same_program(one, other)
        ):
            yield f"{name}: other bytes"


def main(arguments: list[str]) -> int:
    if len(arguments) != 2:
        sys.exit(__doc__)
    before, after = map(Path, arguments)
    fields: Counter[str] = Counter()
    found = list(differences(before, after, fields))
    kept, now = ({path.name for path in folder.iterdir()} for folder in (before, after))
    print("\n".join(found) if found else f"{len(kept)} materials are the same")
    if now - kept:
        print(f"  new: {', '.join(sorted(now - kept))}")
    for path, count in sorted(fields.items()):
        print(f"  manifests have gained {path} ({count})")
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
