# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over the library and the tool; sources whose preprocessed text passed are skipped.

usage: tidy.py BUILD_FOLDER
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

CLANG = "clang++-14"
CLANG_TIDY = "clang-tidy-14"
COMPILERS = ("c++", "g++", "clang++")


# The headers take most of the time: sources are read several at a time. A changed one has its
# neighbours checked again.
BATCH = 8
Entry = dict[str, str]


def arguments(entry: Entry) -> list[str]:
    """The compiler's, without its name, the launcher before it, and files."""
    result = shlex.split(entry["command"])
    while not Path(result[0]).name.startswith(COMPILERS):
        result.pop(0)
    for option in ("-o", "-c"):
        at = result.index(option)
        del result[at : at + 2]
    return result[1:]


def preprocess(entry: Entry) -> bytes:
    """The text that the compiler sees, so that a changed header counts and a comment does not."""
    command = [CLANG, *arguments(entry), "-w", "-E", entry["file"]]
    result = subprocess.run(command, cwd=entry["directory"], capture_output=True, check=False)
    return result.stdout if result.returncode == 0 else os.urandom(32)


def check(entry: Entry, passed: Path) -> str | None:
    """What clang-tidy has to say, or None where the source is fine."""
    config = Path(".clang-tidy").read_bytes()
    stamp = passed / hashlib.sha256(config + preprocess(entry)).hexdigest()
    if stamp.exists():
        return None
    # The build's compiler is GCC, whose warnings and pragmas clang does not all know.
    unknown = [f"-Wno-unknown-{what}" for what in ("warning-option", "pragmas")]
    # A batch includes sources.
    command = [CLANG_TIDY, "--quiet", "--checks=-bugprone-suspicious-include", entry["file"]]
    result = subprocess.run(
        [*command, "--", *arguments(entry), *unknown],
        cwd=entry["directory"],
        capture_output=True,
        text=True,
        check=False,
    )
    if result.returncode == 0:
        stamp.touch()
        return None
    return result.stdout + result.stderr


def check_batch(batch: list[Entry], passed: Path) -> list[str]:
    """What clang-tidy has to say to sources with the same arguments: at a time, or, where they do
    not go together or something is found, one by one."""
    text = "".join(f'#include "{entry["file"]}"\n' for entry in batch)
    file = passed / f"batch_{hashlib.sha256(text.encode()).hexdigest()[:16]}.cpp"
    file.write_text(text, "utf-8")
    if check({**batch[0], "file": str(file)}, passed) is None:
        return []
    return [found for entry in batch if (found := check(entry, passed)) is not None]


def sources(entry: Entry) -> list[Entry]:
    """The entry, or one for each source that it compiles at a time with others."""
    if not Path(entry["file"]).name.startswith("unity_"):
        return [entry]
    included = re.findall(r'^#include "(.*\.cpp)"$', Path(entry["file"]).read_text("utf-8"), re.M)
    return [
        {**entry, "file": file, "command": entry["command"].replace(entry["file"], file)}
        for file in included
    ]


def batches(entries: list[Entry]) -> list[list[Entry]]:
    alike: dict[tuple[str, ...], list[Entry]] = {}
    for entry in sorted(entries, key=lambda entry: entry["file"]):
        alike.setdefault((entry["directory"], *arguments(entry)), []).append(entry)
    return [some[i : i + BATCH] for some in alike.values() for i in range(0, len(some), BATCH)]


def main() -> int:
    build = Path(sys.argv[1]).resolve()
    passed = build.parent / "tidy"
    passed.mkdir(exist_ok=True)
    compiled = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    entries = [source for entry in compiled for source in sources(entry)]
    folders = [Path.cwd() / "cpp_tools" / name for name in ("src", "apps")]
    ours = [e for e in entries if any(Path(e["file"]).is_relative_to(f) for f in folders)]
    failures = done = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        work = batches(ours)
        outcomes = pool.map(lambda batch: check_batch(batch, passed), work)
        for batch, outcome in zip(work, outcomes, strict=True):
            done += len(batch)
            names = [str(Path(entry["file"]).relative_to(Path.cwd())) for entry in batch]
            print(f"[{done}/{len(ours)}] {' '.join(names)}", flush=True)
            failures += len(outcome)
            print("".join(found + "\n" for found in outcome), end="", flush=True)
    print(f"{len(ours)} sources, {failures} with findings")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
