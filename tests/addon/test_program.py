# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A real Blender without Open Shading Language, named by NACRE_BLENDER.

A program that sees other folders than the tests do exchanges files through NACRE_BLENDER_TMP, which
it sees as /tmp.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest

PROGRAM = os.environ.get("NACRE_BLENDER")
pytestmark = pytest.mark.skipif(not PROGRAM, reason="NACRE_BLENDER names no Blender")


@pytest.fixture
def exchange():
    shared = os.environ.get("NACRE_BLENDER_TMP", "/tmp")
    with tempfile.TemporaryDirectory(prefix="nacre-", dir=shared) as folder:
        yield Path(folder)


def inside(path: Path) -> str:
    return str(Path("/tmp", path.relative_to(os.environ.get("NACRE_BLENDER_TMP", "/tmp"))))


def blender(*arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        [PROGRAM, *arguments], capture_output=True, text=True, timeout=600, check=False
    )


def test_installs_and_renders_as_nodes(archive, exchange):
    shutil.copyfile(archive, exchange / "nacre.zip")
    done = blender(
        "--command", "extension", "install-file", "-r", "user_default", "-e",
        inside(exchange / "nacre.zip"),
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    picture = exchange / "film.exr"
    render = (
        "--command",
        "nacre",
        "render",
        "--stage",
        "furnace",
        "--size",
        "16x16",
        "--samples",
        "1",
    )
    done = blender(*render, "--material", "test_film", "-o", inside(picture))
    assert done.returncode == 0, done.stdout + done.stderr
    assert "test_film (nodes)" in done.stdout
    assert picture.stat().st_size > 0
    done = blender(*render, "--material", "test_grating", "-o", inside(exchange / "no.exr"))
    assert done.returncode == 1
    assert "OSL needed: Test Grating" in done.stderr
    assert not (exchange / "no.exr").exists()
