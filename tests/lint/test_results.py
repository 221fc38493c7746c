# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What is told about a test run, from files as pytest and GoogleTest write them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[1] / "support" / "results.py"
GOOGLETEST = """<testsuites><testsuite name="Film">
<testcase name="IsThin" status="run" result="completed" time="0.5" classname="Film" />
<testcase name="IsInAnotherShard" status="notrun" result="suppressed" time="0" classname="Film" />
{}</testsuite></testsuites>"""
BROKEN = '<testcase name="IsFlat" time="2.5" classname="Film"><failure message="no"/></testcase>'
PYTEST = """<testsuites><testsuite><testcase classname="cli.test_bake" name="test_a[1]" time="31.0" />
<testcase classname="cli.test_bake" name="test_b" time="0.0"><skipped/></testcase>
</testsuite></testsuites>"""


@pytest.fixture
def told(tmp_path):
    def run(what: str, *texts: str) -> tuple[int, str]:
        for number, text in enumerate(texts):
            (tmp_path / f"{number}.xml").write_text(text)
        command = [sys.executable, SCRIPT, what, tmp_path, tmp_path / "not there"]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        return result.returncode, result.stdout

    return run


def test_cases_are_counted_where_they_ran(told):
    assert told("cases", GOOGLETEST.format("")) == (0, "1 cases passed, 0 cases failed\n")


def test_failed_cases_are_named(told):
    status, text = told("cases", GOOGLETEST.format(BROKEN))
    assert status == 1
    assert text == "FAILED 0: Film.IsFlat\n1 cases passed, 1 cases failed\n"


def test_no_case_at_all_is_a_failure(told):
    assert told("cases")[0] == 1


def test_the_slowest_come_first(told):
    status, text = told("slowest", GOOGLETEST.format(BROKEN), PYTEST)
    assert status == 0
    names = [line.split()[-1] for line in text.splitlines()[1:]]
    assert names[:3] == ["cli.test_bake.test_a[1]", "Film.IsFlat", "Film.IsThin"]


def test_nothing_to_tell_is_fine(told):
    assert told("slowest") == (0, "")
