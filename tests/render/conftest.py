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


def _shares(item) -> bool:
    """Whether a fixture makes something for all tests of the file."""
    definitions = item._fixtureinfo.name2fixturedefs.values()
    return any(last.scope == "module" for *_, last in definitions)


def pytest_itemcollected(item):
    """What shares pictures, and the truth that those of both Blenders are held against, stays in one
    process."""
    if _shares(item):
        item.add_marker(pytest.mark.xdist_group(item.path.stem))


@pytest.fixture(scope="session", autouse=True)
def groups_are_kept(request):
    """A pytest that pytest-xdist does not know loses its groups, which doubles the time in silence."""
    if not getattr(request.config.option, "loadgroup", False):
        return
    for item in request.session.items:
        for group in item.iter_markers("xdist_group"):
            if not item.nodeid.endswith(f"@{group.args[0]}"):
                pytest.fail(
                    f"pytest {pytest.__version__} hides the group of {item.nodeid} from pytest-xdist; "
                    "use the versions in tests/requirements.txt"
                )


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
