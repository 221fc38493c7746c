# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from harness import ROOT, VERSIONS, Blender
from report import Report

sys.path.insert(0, str(ROOT / "cpp_tools" / "python"))
os.environ.setdefault("NACRE_LIBRARY", str(ROOT / "build" / "release" / "lib" / "libnacre.so"))


def pytest_addoption(parser):
    parser.addoption(
        "--update-refs",
        action="store_true",
        help="store new references for cases that are missing or fail; not in CI",
    )


def pytest_configure(config):
    if config.getoption("--update-refs") and os.environ.get("CI"):
        raise pytest.UsageError("stored images are refreshed by a person after review, never in CI")


# Files whose tests share what one of their fixtures renders: in each Blender by one process.
SHARED = ("energy", "interiors", "prism", "rough", "spread", "stacks", "techniques", "truth")


def pytest_collection_modifyitems(items):
    for item in items:
        version = getattr(item, "callspec", None) and item.callspec.params.get("blender")
        if version and item.path.stem.removeprefix("test_") in SHARED:
            item.add_marker(pytest.mark.xdist_group(f"{item.path.stem}-{version}"))


@pytest.fixture(scope="session", params=VERSIONS)
def blender(request, tmp_path_factory) -> Blender:
    variable = VERSIONS[request.param]
    python = os.environ.get(variable)
    if not python:
        pytest.skip(f"{variable} names no Python with bpy {request.param}")
    return Blender(request.param, python, tmp_path_factory.mktemp("blender"))


REPORT = Report(Path(os.environ.get("NACRE_REPORT", ROOT / "build" / "report")))


def _of_several(config) -> bool:
    """Whether this is one of pytest-xdist's processes, whose first one has the page in its care."""
    return hasattr(config, "workerinput")


def pytest_sessionstart(session):
    if not _of_several(session.config):
        REPORT.clear()


def pytest_sessionfinish(session):
    if not _of_several(session.config):
        REPORT.write()


@pytest.fixture(scope="session")
def report() -> Report:
    """Failed comparisons, a page at the end of the run."""
    return REPORT
