# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many pictures in one process: a CSV of options and values, done again only where something changed."""

from __future__ import annotations

import argparse
import csv
import hashlib
import json
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy

from ..blender.output import SUFFIXES, frame_path
from ..core.library import Library
from ..core.whole_file import write_whole
from .options import UsageError, parse, parser

STATE = ".nacre-batch.json"
"""In the folder: what each picture there was made from."""

_OF_THE_WHOLE = {"--batch": 1, "--gallery": 0, "-o": 1, "--output": 1, "--json": 0}


@dataclass(frozen=True)
class Row:
    where: str  # for messages
    output: Path
    arguments: tuple[str, ...]
    options: argparse.Namespace

    def is_there(self) -> bool:
        if not self.options.frames:
            return self.output.is_file()
        return all(frame_path(self.output, frame).is_file() for frame in self.options.frames)

    def digest(self) -> str:
        """Of all that decides about the pixels."""
        parts = [bpy.app.version_string, *self.arguments]
        for path in (self.options.template, self.options.thickness_map, self.options.blend):
            if path is not None:
                parts.append(hashlib.sha256(Path(path).read_bytes()).hexdigest())
        if self.options.material is not None:
            parts.append(Library.default().load(self.options.material).digest)
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()


def common_arguments(argv: Sequence[str]) -> list[str]:
    """What holds for each picture: the command line without what is about all of them."""
    words = list(argv[1:] if argv[:1] == ["render"] else argv)
    kept: list[str] = []
    while words:
        word = words.pop(0)
        name, equals, _ = word.partition("=")
        if name not in _OF_THE_WHOLE:
            kept.append(word)
        elif not equals:
            del words[: _OF_THE_WHOLE[name]]
    return kept


def read_rows(path: Path, folder: Path, given: Sequence[str]) -> list[Row]:
    """All rows of the table; every fault of it at once, with its line."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as stream:
            reader = csv.DictReader(stream)
            lines = [(reader.line_num, record) for record in reader]
            columns = list(reader.fieldnames or ())
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise UsageError(f"--batch: {path}: cannot be read: {error}") from error
    if "output" not in columns:
        raise UsageError(
            f"{path}:1: must have a column output (got {', '.join(columns) or 'none'})"
        )
    if not lines:
        raise UsageError(f"{path}: has no rows")
    rows, problems, taken = [], [], {}
    for line, record in lines:
        where = f"{path}:{line}"
        try:
            row = make_row(where, folder, record.get("output") or "", given, _arguments(record))
        except UsageError as error:
            problems += [f"{where}: {text}" for text in str(error).splitlines()]
            continue
        if row.output in taken:
            problems.append(f"{where}: output: already in line {taken[row.output]}")
        taken[row.output] = line
        rows.append(row)
    if problems:
        raise UsageError("\n".join(problems))
    return rows


def make_row(
    where: str, folder: Path, name: str, given: Sequence[str], arguments: Iterable[str]
) -> Row:
    path = Path(name if Path(name).suffix else f"{name}.png")
    if not name or path.is_absolute() or ".." in path.parts or path.suffix not in SUFFIXES:
        raise UsageError(f"output: must be a file in the folder, .exr or .png (got {name!r})")
    all_arguments = (*given, *arguments)
    options = parse([*all_arguments, "-o", str(folder / path)])
    return Row(where, folder / path, all_arguments, options)


def _arguments(record: dict[str, Any]) -> list[str]:
    """Columns named as options give these; the others are values to set. Empty cells say nothing."""
    if None in record:
        raise UsageError("has more cells than the first line has names")
    known = {
        option
        for action in parser()._actions
        for option in action.option_strings
        if action.nargs != 0
    }
    arguments: list[str] = []
    for column, cell in record.items():
        if column == "output" or cell is None or not cell.strip():
            continue
        option = f"--{column.strip()}"
        if option in known and option not in _OF_THE_WHOLE:
            arguments += [option, cell.strip()]
        else:
            arguments += ["--set", f"{column.strip()}={cell.strip()}"]
    return arguments


def render(
    rows: Sequence[Row],
    folder: Path,
    render_row: Callable[[argparse.Namespace, Path], str],
    quiet: bool,
) -> dict[str, Any]:
    """Renders what is not there yet or was made from something else; goes on after a failure."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"-o: {folder}: {error.strerror}") from error
    state = _read_state(folder)
    report: dict[str, Any] = {"rendered": [], "kept": [], "failed": {}, "folder": str(folder)}
    for number, row in enumerate(rows, 1):
        name = str(row.output.relative_to(folder))
        try:
            digest = row.digest()
        except Exception as error:  # of this row alone
            report["failed"][name] = f"{row.where}: {error}"
            continue
        if row.is_there() and state.get(name) == digest:
            report["kept"].append(name)
            continue
        if not quiet:
            print(f"nacre render: {number}/{len(rows)} {name}", file=sys.stderr, flush=True)
        problem = render_row(row.options, row.output)
        if problem:
            report["failed"][name] = "\n".join(f"{row.where}: {t}" for t in problem.splitlines())
            print(f"nacre render: {report['failed'][name]}", file=sys.stderr, flush=True)
            continue
        report["rendered"].append(name)
        state[name] = digest
        _write_state(folder, state)
    return report


def summary(report: dict[str, Any]) -> str:
    counts = f"{len(report['rendered'])} rendered, {len(report['kept'])} kept"
    if report["failed"]:
        counts += f", {len(report['failed'])} failed: {', '.join(report['failed'])}"
    lines = [f"{report['folder']}: {counts}"]
    if "page" in report:
        lines.append(report["page"])
    return "\n".join(lines)


def _read_state(folder: Path) -> dict[str, str]:
    try:
        state = json.loads((folder / STATE).read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return state if isinstance(state, dict) else {}


def _write_state(folder: Path, state: dict[str, str]) -> None:
    write_whole(folder / STATE, json.dumps(state, indent=1, sort_keys=True))
