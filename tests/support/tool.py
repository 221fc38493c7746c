# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The command-line tool, run as a user runs it."""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

from support.paths import tool


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


def nacre(*arguments, **options) -> str:
    """Standard output of the tool under test, which must succeed."""
    return Tool(tool()).ok(*arguments, **{"timeout": 900, **options})
