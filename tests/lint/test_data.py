# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Published data stay as they were published: no other test would miss a digit of theirs."""

from __future__ import annotations

import hashlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SUMS = Path(__file__).with_name("data.sha256")


def test_published_data_are_unchanged():
    listed = dict(line.split("  ", 1)[::-1] for line in SUMS.read_text("utf-8").splitlines())
    found = {
        path.relative_to(ROOT).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in (ROOT / "cpp_tools/data").rglob("*")
        if path.is_file()
    }
    assert found, "cpp_tools/data is empty"
    changed = sorted(name for name in listed | found if listed.get(name) != found.get(name))
    assert not changed, (
        f"{', '.join(changed)}: not as listed in {SUMS.name}; if that is meant: "
        "git ls-files cpp_tools/data | LC_ALL=C sort | xargs sha256sum > tests/lint/data.sha256"
    )
