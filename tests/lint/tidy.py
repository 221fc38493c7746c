# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over the library and the tool; a source whose preprocessed text passed is skipped.

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


def preprocess(entry: dict[str, str]) -> bytes:
    """The text that the compiler sees, so that a changed header counts and a comment does not."""
    arguments = shlex.split(entry["command"])
    while not Path(arguments[0]).name.startswith(COMPILERS):
        arguments.pop(0)  # a launcher such as ccache
    output = arguments.index("-o")
    del arguments[output : output + 2]
    arguments[arguments.index("-c")] = "-E"
    command = [CLANG, *arguments[1:], "-w"]
    result = subprocess.run(command, cwd=entry["directory"], capture_output=True, check=False)
    return result.stdout if result.returncode == 0 else os.urandom(32)


def check(entry: dict[str, str], passed: Path) -> str | None:
    """What clang-tidy has to say, or None where the source is fine."""
    folders = Path(entry["file"]).relative_to(Path.cwd()).parents
    configs = [file.read_bytes() for f in folders if (file := f / ".clang-tidy").exists()]
    stamp = passed / hashlib.sha256(b"".join([*configs, preprocess(entry)])).hexdigest()
    if stamp.exists():
        return None
    # The build's compiler is GCC, whose warnings and pragmas clang does not all know.
    unknown = [f"--extra-arg=-Wno-unknown-{what}" for what in ("warning-option", "pragmas")]
    command = [CLANG_TIDY, "--quiet", *unknown, "-p", str(passed), entry["file"]]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode == 0:
        stamp.touch()
        return None
    return result.stdout + result.stderr


def sources(entry: dict[str, str]) -> list[dict[str, str]]:
    """The entry, or one for each source that it compiles at a time with others."""
    if not Path(entry["file"]).name.startswith("unity_"):
        return [entry]
    included = re.findall(r'^#include "(.*\.cpp)"$', Path(entry["file"]).read_text("utf-8"), re.M)
    return [
        {**entry, "file": file, "command": entry["command"].replace(entry["file"], file)}
        for file in included
    ]


def main() -> int:
    build = Path(sys.argv[1]).resolve()
    passed = build.parent / "tidy"
    passed.mkdir(exist_ok=True)
    compiled = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    entries = [source for entry in compiled for source in sources(entry)]
    (passed / "compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")
    folders = [Path.cwd() / "cpp_tools" / name for name in ("src", "apps")]
    ours = [e for e in entries if any(Path(e["file"]).is_relative_to(f) for f in folders)]
    failures = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        outcomes = pool.map(lambda entry: check(entry, passed), ours)
        for number, (entry, outcome) in enumerate(zip(ours, outcomes, strict=True), 1):
            name = Path(entry["file"]).relative_to(Path.cwd())
            print(f"[{number}/{len(ours)}] {name}", flush=True)
            if outcome is not None:
                failures += 1
                print(outcome, flush=True)
    print(f"{len(ours)} sources, {failures} with findings")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
