# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write cpp_tools/data/optical_constants from the refractiveindex.info database.

    git clone https://github.com/polyanskiy/refractiveindex.info-database
    python import_optical_constants.py refractiveindex.info-database/database

An unpacked copy that some package brings along will do as well: its state is then named by the
newest date of its change log. optical_constants.toml beside this file lists what is taken.

The database is in the public domain (CC0 1.0). Every entry keeps its references, comments and data
as they are, but for misplaced rows and rows with gain; comment lines say so and where it is from.
NAMES (a key of the database's own about files) gives it a readable name, FORMULA the chemical
formula of its shelf and TAGS what kind of matter it is. `book/page` is the key under which
templates name a medium.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import tomllib
from pathlib import Path

OUTPUT = Path(__file__).resolve().parents[1] / "data" / "optical_constants"

SHELVES = Path(__file__).with_name("optical_constants.toml")

ROW = re.compile(r"^ {4,}[0-9][0-9.eE+-]*( +[0-9.eE+-]+){1,2} *$")


def numbers(row: str) -> list[float]:
    return [float(word) for word in row.split()]


def mended_rows(rows: list[str]) -> tuple[list[str], list[str]]:
    """Rows that a reader can use, and what had to be changed for it."""
    changes = []
    ordered = sorted(rows, key=lambda row: numbers(row)[0])
    if ordered != rows:
        changes.append("rows sorted by wavelength")
    first = {}
    for row in ordered:
        first.setdefault(numbers(row)[0], row)
    unique = list(first.values())
    if len(unique) != len(ordered):
        changes.append("second row of a repeated wavelength left out")
    passive = [row for row in unique if min(numbers(row)) >= 0.0]
    if len(passive) != len(unique):
        changes.append("rows with k < 0 left out")
    return passive, changes


def mended_tables(lines: list[str]) -> tuple[list[str], list[str]]:
    """The same for every table of a file."""
    result, changes = [], []
    start = 0
    while start < len(lines):
        end = start
        while end < len(lines) and ROW.match(lines[end]):
            end += 1
        if end > start:
            rows, why = mended_rows(lines[start:end])
            result += rows
            changes += why
        else:
            result.append(lines[start])
            end += 1
        start = end
    return result, changes


def formula_of(source: str) -> str:
    """Chemical formula in a path of the database, or nothing where it has none."""
    shelf, book = source.split("/")[:2]
    if shelf == "main":
        return book
    return book.split(" - ")[0] if shelf == "organic" else ""


def header_keys(source: str, name: str, tags: list[str]) -> str:
    lines = ["NAMES:", f"  - {name}"]
    if formula := formula_of(source):
        lines.append(f'FORMULA: "{formula}"')
    lines += ["TAGS:", *(f"  - {tag}" for tag in tags)]
    return "\n".join(lines)


def entry_text(database: Path, state: str, source: str, keys: str) -> str:
    path = f"data/{source}.yml"
    body = (database / path).read_text(encoding="utf-8-sig").replace("\r\n", "\n")
    lines = [line.rstrip() for line in body.split("\n")]
    # The database's own three lines on the licence stay on top.
    header = [line for line in lines if line.startswith("#")]
    lines = lines[len(header) :]
    header.append(f"# database/{path}, {state}")
    lines, changes = mended_tables(lines)
    header += [f"# changed: {change}" for change in changes]
    rest = "\n".join(lines).strip("\n")
    return "\n".join(header) + f"\n\n{keys}\n{rest}\n"


def state_of(database: Path) -> str:
    """The commit of a checkout, or else the newest date of the change log."""
    if (database.parent / ".git").exists():
        asked = ["git", "-C", database, "rev-parse", "HEAD"]
        return "commit " + subprocess.check_output(asked, text=True).strip()
    log = (database / "doc" / "changelog.txt").read_text(encoding="utf-8-sig")
    return "state of " + re.search(r"=+ (\d{4}-\d\d-\d\d) =+", log)[1]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("database", type=Path, help="folder `database` of refractiveindex.info")
    database = parser.parse_args().database
    state = state_of(database)
    for shelf in tomllib.loads(SHELVES.read_text(encoding="utf-8"))["shelf"]:
        for key, (source, name) in shelf["entries"].items():
            output = OUTPUT / f"{key}.yml"
            output.parent.mkdir(parents=True, exist_ok=True)
            keys = header_keys(source, name, shelf["tags"])
            output.write_text(entry_text(database, state, source, keys), encoding="utf-8")


if __name__ == "__main__":
    main()
