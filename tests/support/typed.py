# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a reader types: commands and programs of documents and of `--help`, in a folder of their own."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from support.paths import PACKAGE, ROOT

# Two spaces before what is typed, more before where it goes on.
_EXAMPLE = re.compile(r"^  (?:nacre|echo) .*(?:\n {4,}\S.*)*", re.MULTILINE)


def run(language: str, text: str, folder: Path, program: Path) -> str:
    """Standard output of what must succeed; `nacre` is `program`."""
    path = os.pathsep.join([str(program.parent), os.environ["PATH"]])
    lib = str(program.parent.parent / "lib")
    compiler = {
        "C_INCLUDE_PATH": str(ROOT / "cpp_tools" / "include"),
        "LIBRARY_PATH": lib,
        "LD_LIBRARY_PATH": lib,
    }
    command = {"sh": ["bash", "-euo", "pipefail", "-c"], "python": [sys.executable, "-c"]}[language]
    # Who types Python has installed the package; who types commands need not have.
    installed = {"PYTHONPATH": str(PACKAGE)} if language == "python" else {}
    result = subprocess.run(
        [*command, text],
        cwd=folder,
        env={**os.environ, **compiler, **installed, "PATH": path},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert result.returncode == 0, f"{text}\n{result.stdout}{result.stderr}"
    return result.stdout


def examples(help_text: str) -> list[str]:
    """The commands of a `--help`, each with the lines that it goes on for."""
    return [match.group().strip() for match in _EXAMPLE.finditer(help_text)]
