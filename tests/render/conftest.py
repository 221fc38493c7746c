# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from blender.harness import Blender, Server, xvfb_command
from support.paths import ROOT
from support.report import Report


def pytest_addoption(parser):
    parser.addoption(
        "--update-refs",
        action="store_true",
        help="store new references for cases that are missing or fail; not in CI",
    )


def pytest_configure(config):
    if config.getoption("--update-refs") and os.environ.get("CI"):
        raise pytest.UsageError("stored images are refreshed by a person after review, never in CI")


@pytest.fixture(scope="session")
def update_refs(request) -> bool:
    return request.config.getoption("--update-refs")


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


@pytest.fixture(scope="module")
def displayed(blender, tmp_path_factory):
    """The same Blender on a display that nobody sees, drawing in software, for EEVEE."""
    if not shutil.which("xvfb-run"):
        pytest.skip("EEVEE needs a display, and there is no xvfb-run (Debian's xvfb, xauth)")
    server = Server(xvfb_command(blender.python))
    folder = tmp_path_factory.mktemp("eevee")
    yield Blender(blender.version, blender.python, server, folder, {"LIBGL_ALWAYS_SOFTWARE": "1"})
    server.close()
