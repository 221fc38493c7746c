# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What test runs wrote about their cases, in JUnit's XML: pytest and GoogleTest both do.

usage: results.py cases FOLDER…    how many cases ran, and the names of those that failed
       results.py slowest FOLDER…  the ten that took the longest
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

SHOWN = 10


@dataclass(frozen=True)
class Case:
    suite: str  #: the name of the file
    name: str
    seconds: float
    outcome: str  #: passed, failed or skipped


def outcome(case: ElementTree.Element) -> str:
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    # GoogleTest lists what a filter or another shard has, as notrun.
    skipped = case.find("skipped") is not None or case.get("status") == "notrun"
    return "skipped" if skipped else "passed"


def cases(file: Path) -> Iterator[Case]:
    for case in ElementTree.parse(file).iter("testcase"):
        name = f"{case.get('classname')}.{case.get('name')}"
        yield Case(file.stem, name, float(case.get("time", 0)), outcome(case))


def tell_cases(found: list[Case]) -> int:
    for case in found:
        if case.outcome == "failed":
            print(f"FAILED {case.suite}: {case.name}")
    counts = {kind: sum(c.outcome == kind for c in found) for kind in ("passed", "failed")}
    print(", ".join(f"{count} cases {kind}" for kind, count in counts.items()))
    return 0 if counts["passed"] and not counts["failed"] else 1


def tell_slowest(found: list[Case]) -> int:
    slowest = sorted(found, key=lambda case: -case.seconds)[:SHOWN]
    if slowest:
        print("slowest:")
    for case in slowest:
        print(f"  {case.seconds:7.1f} s  {case.suite}: {case.name}")
    return 0


def main() -> int:
    what, *folders = sys.argv[1:]
    files = sorted(file for folder in folders for file in Path(folder).glob("*.xml"))
    found = [case for file in files for case in cases(file)]
    return {"cases": tell_cases, "slowest": tell_slowest}[what](found)


if __name__ == "__main__":
    sys.exit(main())
