# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Blenders for every suite, and which process of pytest-xdist runs what."""

from __future__ import annotations

import os
import sys

import pytest

from blender.harness import VERSIONS, Blender, Blenders
from support.paths import PACKAGE

sys.path.insert(0, str(PACKAGE))


@pytest.fixture(scope="session")
def blenders():
    """Those of this process, stopped at its end."""
    found = Blenders()
    yield found
    found.close()


@pytest.fixture(scope="session", params=VERSIONS)
def blender_version(request) -> str:
    """Each version that is there; tests are skipped, with a word, for the others."""
    version = request.param
    if not os.environ.get(VERSIONS[version]):
        pytest.skip(f"{VERSIONS[version]} names no Python with bpy {version}")
    return version


@pytest.fixture(scope="session")
def blender(blender_version, blenders, tmp_path_factory) -> Blender:
    """A suite may override it by one of another scope."""
    return blenders.get(blender_version, tmp_path_factory.mktemp(f"blender-{blender_version}"))


def _version(item) -> str | None:
    """Of the Blender that a test asks."""
    if hasattr(item, "callspec") and "blender_version" in item.callspec.params:
        return item.callspec.params["blender_version"]
    return "4.5" if "blender45" in item.fixturenames else None


def pytest_itemcollected(item):
    """All that asks one Blender runs in one process, which has that Blender to itself."""
    version = _version(item)
    if version:
        item.add_marker(pytest.mark.xdist_group(f"blender-{version}"))


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
