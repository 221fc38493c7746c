# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over the library and the tool. Sources that passed as they are, with all that they
include of ours, stand in tidy_passed.txt and are skipped; outside CI those that pass are added.

usage: tidy.py BUILD_FOLDER [--all]

  --all  skips nothing and writes tidy_passed.txt anew
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

CLANG_TIDY = ("clang-tidy-14", "--quiet", "--checks=-bugprone-suspicious-include")
COMPILERS = ("c++", "g++", "clang++")
PASSED = Path("tests/lint/tidy_passed.txt")
FOLDERS = ("cpp_tools/src", "cpp_tools/apps")

# The headers take most of the time: sources are read several at a time.
BATCH = 12
INCLUDE = re.compile(r"^[ \t]*#[ \t]*(?:include|include_next|import)\b(.*)$", re.M)
NAMED = re.compile(r"""\s*["<]([^">]+)[">]""")
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


class Contents:
    """Hashes of sources with what they include.

    Two headers of one name count both, wherever they lie: which of them a compiler takes depends on
    its arguments, and one too many costs a check where one too few would hide a change.
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        self.texts: dict[Path, bytes] = {}
        self.by_name: dict[str, list[Path]] = {}
        for folder in (*FOLDERS, "cpp_tools/include"):
            for file in filter(Path.is_file, (root / folder).rglob("*")):
                self.by_name.setdefault(file.name, []).append(file)
        config = (root / ".clang-tidy").read_bytes()
        self.rules = hashlib.sha256(config + " ".join(CLANG_TIDY).encode()).digest()

    def text(self, file: Path) -> bytes:
        if file not in self.texts:
            self.texts[file] = file.read_bytes()
        return self.texts[file]

    def included(self, file: Path) -> set[Path]:
        """Files of ours that `file` may mean; a name that a macro makes may be any."""
        result: set[Path] = set()
        for what in INCLUDE.findall(self.text(file).decode("utf-8", "replace")):
            if not (named := NAMED.match(what)):
                return {one for files in self.by_name.values() for one in files}
            result.update(self.by_name.get(Path(named[1]).name, ()))
        return result

    def hash(self, source: Path) -> str:
        everything, ahead = {source}, [source]
        while ahead:
            new = self.included(ahead.pop()) - everything
            everything |= new
            ahead.extend(new)
        digest = hashlib.sha256(self.rules)
        for file in sorted(everything):
            name = file.relative_to(self.root).as_posix()
            digest.update(f"{name}\0{len(self.text(file))}\0".encode() + self.text(file))
        return digest.hexdigest()[:32]


def read_passed(file: Path) -> set[tuple[str, str]]:
    """Hashes and sources. A source may stand there twice, as after a merge."""
    if not file.exists():
        return set()
    lines = (line.split(maxsplit=1) for line in file.read_text("utf-8").splitlines())
    return {(line[0], line[1]) for line in lines if len(line) == 2}


def write_passed(file: Path, hashes: dict[str, str], good: Iterable[str]) -> None:
    """Only sources that are there, each once: as it is now."""
    file.write_text("".join(f"{hashes[name]} {name}\n" for name in sorted(good)), "utf-8")


def check(entry: Entry) -> str | None:
    """What clang-tidy has to say, or None where the source is fine."""
    # The build's compiler is GCC, whose warnings and pragmas clang does not all know.
    unknown = [f"-Wno-unknown-{what}" for what in ("warning-option", "pragmas")]
    # A batch includes sources.
    result = subprocess.run(
        [*CLANG_TIDY, entry["file"], "--", *arguments(entry), *unknown],
        cwd=entry["directory"],
        capture_output=True,
        text=True,
        check=False,
    )
    return result.stdout + result.stderr if result.returncode else None


def check_batch(batch: list[Entry], folder: Path) -> dict[str, str]:
    """What clang-tidy has to say to sources with the same arguments: at a time, or, where they do
    not go together or something is found, one by one."""
    if len(batch) > 1:
        text = "".join(f'#include "{entry["file"]}"\n' for entry in batch)
        file = folder / f"batch_{hashlib.sha256(text.encode()).hexdigest()[:16]}.cpp"
        file.write_text(text, "utf-8")
        if check({**batch[0], "file": str(file)}) is None:
            return {}
    return {entry["file"]: found for entry in batch if (found := check(entry)) is not None}


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


def ours(build: Path, root: Path) -> dict[str, Entry]:
    """By name below `root`, each source once."""
    compiled = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    folders = [root / name for name in FOLDERS]
    entries = (source for entry in compiled for source in sources(entry))
    return {
        Path(entry["file"]).relative_to(root).as_posix(): entry
        for entry in entries
        if any(Path(entry["file"]).is_relative_to(folder) for folder in folders)
    }


def main() -> int:
    root, build = Path.cwd(), Path(sys.argv[1]).resolve()
    everything = sys.argv[2:] == ["--all"]
    folder = build.parent / "tidy"
    folder.mkdir(exist_ok=True)
    entries, contents = ours(build, root), Contents(root)
    hashes = {name: contents.hash(root / name) for name in entries}
    before = set() if everything else read_passed(PASSED)
    good = {name for name in entries if (hashes[name], name) in before}
    passed_now: set[str] = set()
    failures = done = 0
    work = batches([entry for name, entry in entries.items() if name not in good])
    print(f"{len(entries) - len(good)} of {len(entries)} sources are to be checked", flush=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        outcomes = pool.map(lambda batch: check_batch(batch, folder), work)
        for batch, found in zip(work, outcomes, strict=True):
            done += len(batch)
            names = [Path(entry["file"]).relative_to(root).as_posix() for entry in batch]
            print(f"[{done}/{len(entries) - len(good)}] {' '.join(names)}", flush=True)
            print("".join(text + "\n" for text in found.values()), end="", flush=True)
            failures += len(found)
            good_now = [e["file"] for e in batch if e["file"] not in found]
            passed_now.update(Path(name).relative_to(root).as_posix() for name in good_now)
    if everything or not os.environ.get("CI"):
        write_passed(PASSED, hashes, good | passed_now)
    print(f"{len(entries)} sources, {failures} with findings")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
