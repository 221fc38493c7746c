#!/usr/bin/env python3
# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Whether the tests find faults: makes those of mutants.toml, one at a time, in a checkout of its own.

usage: run.py [--at COMMIT] [--likely | --everything] [--check] [NAME…]

Runs the tests that are named with each fault, up to the first that fails; where none does, all tests,
unless only the --likely ones are asked for. It takes an hour and so is no part of CI, which asks
--check: whether each fault can still be made. The checkouts, in build/mutants/, are kept for the next
time.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import subprocess
import sys
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SHOWN = 3  # of the tests that find a fault, by name


@dataclass(frozen=True)
class Mutant:
    name: str
    file: str
    before: str
    after: str
    tests: tuple[str, ...]

    def problem(self, root: Path) -> str:
        """Why it cannot be made there, or nothing."""
        try:
            text = (root / self.file).read_text("utf-8")
        except OSError as error:
            return str(error)
        found = text.count(self.before)
        if found == 1 and self.before != self.after:
            return ""
        return f"{self.file}: must have once what is changed (found {found} times)"

    def apply(self, root: Path) -> None:
        path = root / self.file
        path.write_text(path.read_text("utf-8").replace(self.before, self.after), "utf-8")


def mutants() -> list[Mutant]:
    entries = tomllib.loads((HERE / "mutants.toml").read_text("utf-8"))
    return [
        Mutant(name, entry["file"], entry["before"], entry["after"], tuple(entry["tests"]))
        for name, entry in entries.items()
    ]


def checkout(commit: str) -> Path:
    """A worktree of the commit."""
    full = _git("rev-parse", "--verify", f"{commit}^{{commit}}")
    folder = ROOT / "build" / "mutants" / full[:12]
    if not folder.exists():
        _git("worktree", "prune")
        _git("worktree", "add", "--detach", str(folder), full)
    _git("-C", str(folder), "checkout", "--quiet", "--", ".")
    return folder


def _git(*arguments: str) -> str:
    done = subprocess.run(
        ["git", *arguments], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True
    )
    return done.stdout.strip()


@dataclass(frozen=True)
class Outcome:
    status: str  #: found, lived or not built
    by: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        more = f" and {len(self.by) - SHOWN} more" if len(self.by) > SHOWN else ""
        return f"{self.status}{': ' if self.by else ''}{', '.join(self.by[:SHOWN])}{more}"


def run_tests(folder: Path, arguments: list[str], log: Path) -> Outcome:
    """One call of ./dev test."""
    names = {name: value for name, value in os.environ.items() if not name.startswith("NACRE")}
    with log.open("a", encoding="utf-8") as stream:
        start = stream.tell()
        status = subprocess.run(
            ["./dev", "test", *arguments],
            cwd=folder,
            stdout=stream,
            stderr=stream,
            env=names,
            check=False,
        ).returncode
    printed = log.read_text("utf-8", "replace").encode("utf-8")[start:].decode("utf-8", "replace")
    if status == 0:
        return Outcome("lived")
    # Steps come before the parts, and where one fails no part is run.
    if re.search(r"^ +(packages|build|blender-4\.5|extension) +FAILED", printed, re.M):
        return Outcome("not built")
    failed = re.findall(r"^(?:FAILED|ERROR) (.+?)(?: - .*)?$", printed, re.M)
    return Outcome("found", tuple(dict.fromkeys(failed)) or ("no test by name; see the log",))


def try_mutant(mutant: Mutant, folder: Path, likely: bool, everything: bool) -> Outcome:
    """`likely`: try its tests first; `everything`: all tests then."""
    log = folder / "build" / "mutants" / f"{mutant.name}.log"
    log.parent.mkdir(parents=True, exist_ok=True)
    log.unlink(missing_ok=True)
    mutant.apply(folder)
    try:
        for text in mutant.tests if likely else ():
            part, *more = shlex.split(text)
            if not (folder / "tests" / "cpp" / part).is_dir():
                more.append("-x")  # of pytest: the first that fails is enough
            outcome = run_tests(folder, [part, *more], log)
            if outcome.status != "lived":
                return outcome
        return run_tests(folder, [], log) if everything else Outcome("lived")
    finally:
        _git("-C", str(folder), "checkout", "--quiet", "--", ".")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="of mutants; all where none is")
    parser.add_argument("--at", metavar="COMMIT", default="HEAD", help="whose code and tests")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--likely", action="store_true", help="only the tests named with a fault")
    which.add_argument("--everything", action="store_true", help="all tests at once")
    parser.add_argument("--check", action="store_true", help="only whether each can be made")
    options = parser.parse_args()
    chosen = [m for m in mutants() if not options.names or m.name in options.names]
    unknown = set(options.names) - {m.name for m in chosen}
    if unknown:
        parser.error(f"no mutant {', '.join(sorted(unknown))}")

    folder = ROOT if options.check else checkout(options.at)
    problems = [f"{m.name}: {problem}" for m in chosen if (problem := m.problem(folder))]
    for problem in problems:
        print(problem, file=sys.stderr)
    if problems or options.check:
        return 1 if problems else 0

    subprocess.run(["./dev", "setup"], cwd=folder, check=True)
    lived = 0
    for mutant in chosen:
        start = time.monotonic()
        outcome = try_mutant(mutant, folder, not options.everything, not options.likely)
        lived += outcome.status != "found"
        print(f"{mutant.name}: {outcome.text} ({time.monotonic() - start:.0f} s)", flush=True)
    print(f"{len(chosen)} faults, {len(chosen) - lived} found")
    return 1 if lived else 0


if __name__ == "__main__":
    sys.exit(main())
