# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""File rules: licence lines, UTF-8, LF line ends, a final newline, and sizes; for C++ includes.py."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import includes

BINARY = {".exr", ".png", ".webp", ".jpg", ".blend", ".tx"}
SOURCE = {".cpp", ".h", ".osl", ".py", ".cmake"}
SOURCE_NAMES = {"CMakeLists.txt", "dev", "run"}
MAX_LINES = {".h": 250, ".cpp": 500, ".osl": 250, ".py": 500}
MAX_BYTES = 2_000_000

LICENCES = {"osl": "BSD-3-Clause", "addon": "GPL-3.0-or-later"}
DEFAULT_LICENCE = "Apache-2.0"


def tracked_files() -> list[Path]:
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listing = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return [path for name in listing.split("\0") if name and (path := Path(name)).is_file()]


def licence_problems(path: Path, lines: list[str]) -> Iterator[str]:
    head = "\n".join(lines[:5])
    folder = "osl" if path.suffix == ".osl" else path.parts[0]
    licence = LICENCES.get(folder, DEFAULT_LICENCE)
    if "SPDX-FileCopyrightText: Nacre contributors" not in head:
        yield "no 'SPDX-FileCopyrightText: Nacre contributors' in the first five lines"
    if f"SPDX-License-Identifier: {licence}" not in head:
        yield f"no 'SPDX-License-Identifier: {licence}' in the first five lines"


def problems(path: Path) -> Iterator[str]:
    data = path.read_bytes()
    if len(data) > MAX_BYTES:
        yield f"{len(data)} bytes; at most {MAX_BYTES}"
    if path.suffix in BINARY or not data:
        return
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        yield f"not UTF-8: {error}"
        return
    if "\r" in text:
        yield "carriage returns; lines end with LF"
    if not text.endswith("\n"):
        yield "no newline at the end"
    lines = text.splitlines()
    if path.suffix in SOURCE or path.name in SOURCE_NAMES:
        yield from licence_problems(path, lines)
    limit = MAX_LINES.get(path.suffix)
    if limit and len(lines) > limit:
        yield f"{len(lines)} lines; at most {limit} in a {path.suffix} file"


def main() -> int:
    files = tracked_files()
    found = [f"{path}: {problem}" for path in files for problem in problems(path)]
    found += includes.problems(Path(), map(Path.as_posix, files))
    print("\n".join([*found, f"{len(files)} files, {len(found)} problems"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
