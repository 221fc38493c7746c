# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The list of faults for tests/mutants/run.py, which takes too long to be run here, keeps up with the code."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

RUN = Path(__file__).resolve().parents[1] / "mutants" / "run.py"


def test_each_fault_can_be_made():
    done = subprocess.run(
        [sys.executable, RUN, "--check"], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
