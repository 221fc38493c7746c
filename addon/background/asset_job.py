# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`driver.py assets FOLDER`: makes the asset library in a process of its own, and says how far it is."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from ..assets import build as assets
from ..assets.process import PROGRESS
from ..gems import cut_stone


def main(argv: Sequence[str]) -> int:
    """Returns the exit status; what was left out, or is wrong, goes to standard error."""
    with contextlib.suppress(AttributeError, OSError):  # the window comes first
        os.nice(10)
    cut_stone.register()
    try:
        _, left_out = assets.build(Path(argv[0]), _tell)
    except Exception as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr)
        return 1
    for text in left_out:
        print(text, file=sys.stderr)
    return 0


def _tell(done: int, count: int) -> None:
    print(PROGRESS, done, count, flush=True)
