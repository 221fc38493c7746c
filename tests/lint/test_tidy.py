# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Which sources clang-tidy checks: none that changed, itself or in what it includes, is left out."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import tidy

FILES = {
    ".clang-tidy": "Checks: bugprone-*\n",
    "cpp_tools/include/nacre/core/text.h": "#pragma once\n",
    "cpp_tools/include/nacre/optics/film.h": '#include "nacre/core/text.h"\n',
    "cpp_tools/src/optics/film.cpp": '#include "nacre/optics/film.h"\n',
    "cpp_tools/src/optics/other.cpp": "#include <vector>\n  #  include <sides.h> // ours\n",
    "cpp_tools/src/optics/sides.h": "",
    "cpp_tools/src/lut/sides.h": "",
    "cpp_tools/apps/nacre/made.cpp": "#include TABLE\n",
}
FILM, OTHER, MADE = (name for name in FILES if name.endswith(".cpp"))


@pytest.fixture
def project(tmp_path, monkeypatch):
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    (tmp_path / "tests/lint").mkdir(parents=True)
    unity = tmp_path / "build/unity_0_cxx.cxx"
    unity.parent.mkdir()
    unity.write_text("".join(f'#include "{tmp_path / name}"\n' for name in (FILM, OTHER)))
    compiled = [
        {"file": str(f), "directory": str(tmp_path), "command": f"ccache c++ -O2 -o a.o -c {f}"}
        for f in (unity, tmp_path / MADE)
    ]
    (tmp_path / "build/compile_commands.json").write_text(json.dumps(compiled))
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CI", raising=False)
    monkeypatch.setattr(sys, "argv", ["tidy.py", "build"])
    return tmp_path


@pytest.fixture
def checked(project, monkeypatch):
    """A run of the script: the sources that it gives to clang-tidy; those in `bad` have findings."""
    bad: set[str] = set()

    def run() -> set[str]:
        seen: set[str] = set()

        def check(entry):
            file = Path(entry["file"])
            names = {file.relative_to(project).as_posix()}
            if file.name.startswith("batch_"):
                names = {n for n in FILES if str(project / n) in file.read_text()}
            seen.update(names)
            return "a finding" if names & bad else None

        monkeypatch.setattr(tidy, "check", check)
        assert tidy.main() == (1 if seen & bad else 0)
        return seen

    run.bad = bad
    return run


def test_all_are_checked_once_then_none(checked):
    assert checked() == {FILM, OTHER, MADE}
    assert checked() == set()


@pytest.mark.parametrize(
    ("changed", "wanted"),
    [
        (FILM, {FILM}),
        ("cpp_tools/include/nacre/optics/film.h", {FILM, MADE}),
        ("cpp_tools/include/nacre/core/text.h", {FILM, MADE}),  # two steps away
        ("cpp_tools/src/optics/sides.h", {OTHER, MADE}),
        ("cpp_tools/src/lut/sides.h", {OTHER, MADE}),  # of the same name: it may be meant
        (".clang-tidy", {FILM, OTHER, MADE}),
    ],
)
def test_a_change_reaches_what_includes_it(project, checked, changed, wanted):
    checked()
    with (project / changed).open("a") as file:
        file.write("// changed\n")
    # A macro may name any file.
    assert checked() == wanted | ({MADE} if changed == FILM else set())


def test_a_finding_is_checked_until_it_is_gone(checked):
    checked.bad.add(OTHER)
    checked()
    assert checked() == {OTHER}
    checked.bad.clear()
    assert checked() == {OTHER}
    assert checked() == set()


def test_ci_writes_nothing(project, checked, monkeypatch):
    monkeypatch.setenv("CI", "true")
    checked()
    assert not tidy.PASSED.exists()


def test_all_skips_nothing_and_forgets_what_is_gone(checked, monkeypatch):
    checked()
    with tidy.PASSED.open("a") as file:
        file.write("0123 cpp_tools/src/optics/gone.cpp\n")
    monkeypatch.setattr(sys, "argv", ["tidy.py", "build", "--all"])
    assert checked() == {FILM, OTHER, MADE}
    assert "gone" not in tidy.PASSED.read_text()


def test_hashes_are_those_of_any_machine(project, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    for name, text in reversed(FILES.items()):
        (elsewhere / name).parent.mkdir(parents=True, exist_ok=True)
        (elsewhere / name).write_text(text)
    for name in (FILM, OTHER, MADE):
        here, there = tidy.Contents(project), tidy.Contents(elsewhere)
        assert here.hash(project / name) == there.hash(elsewhere / name)


def test_a_merge_may_leave_two_lines_of_a_source(project, checked):
    checked()
    with tidy.PASSED.open("a") as file:
        file.write(f"0123 {FILM}\n<<<<<<< ours\n")
    assert checked() == set()
