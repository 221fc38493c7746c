# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs the command-line tool: the one that NACRE names, else that of the release build."""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TEMPLATES = ROOT / "osl" / "templates"


@dataclass(frozen=True)
class Tool:
    program: Path

    def __call__(self, *arguments, stdin: str = "", cwd=None, env=None, timeout=300):
        """Runs `nacre ARGUMENTS`; the result has returncode, stdout, stderr."""
        return subprocess.run(
            [self.program, *map(str, arguments)],
            input=stdin,
            capture_output=True,
            text=True,
            cwd=cwd,
            env=None if env is None else {**os.environ, **env},
            timeout=timeout,
            check=False,
        )

    def ok(self, *arguments, **options) -> str:
        """Standard output of a run that must succeed."""
        result = self(*arguments, **options)
        assert result.returncode == 0, result.stderr
        return result.stdout

    def evaluate(self, kind: str, records, *options):
        """The answers of `nacre eval KIND`, all of which must succeed."""
        return json.loads(self.ok("eval", kind, *options, stdin=json.dumps(records)))

    def fails(self, *arguments, code=1, **options) -> str:
        """Standard error of a run that must end with `code`."""
        result = self(*arguments, **options)
        assert result.returncode == code, (result.returncode, result.stdout, result.stderr)
        return result.stderr


@pytest.fixture(scope="session")
def nacre() -> Tool:
    program = Path(os.environ.get("NACRE", ROOT / "build" / "release" / "bin" / "nacre"))
    if not program.is_file():
        pytest.fail(f"{program} is not built; set NACRE to the program under test")
    return Tool(program)


@pytest.fixture(autouse=True)
def own_library(tmp_path, monkeypatch) -> Path:
    """A library of the user's own, empty: nobody's real one has a say."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path / "data" / "nacre"


@pytest.fixture(scope="session")
def templates() -> Path:
    return TEMPLATES


@pytest.fixture
def film_json(tmp_path) -> Path:
    """A film that bakes in no time."""
    path = tmp_path / "film.json"
    path.write_text(
        json.dumps(
            {
                "ambient": {"n": 1.0},
                "layer": [
                    {
                        "n": 1.33,
                        "thickness_nm": {"default": 200, "min": 0, "max": 400, "varies": True},
                    }
                ],
                "substrate": {"n": 1.5},
            }
        )
    )
    return path
