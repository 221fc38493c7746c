# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs the command-line tool: the one that NACRE names, else that of the release build."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from support.paths import TEMPLATES, tool
from support.tool import Tool


@pytest.fixture(scope="session")
def nacre() -> Tool:
    program = tool()
    if not program.is_file():
        pytest.fail(f"{program} is not built; set NACRE to the program under test")
    return Tool(program)


@pytest.fixture(scope="session")
def prefix(nacre, tmp_path_factory) -> Path:
    """An installation, under another name than it was installed by: nothing may depend on that."""
    build = nacre.program.parents[1]
    cmake = shutil.which("cmake")
    if not cmake or not (build / "cmake_install.cmake").is_file():
        pytest.skip(f"needs cmake and a build tree in {build}")
    if not os.access(build, os.W_OK):
        pytest.skip(f"cmake --install keeps a list of its files in {build}, which is not writable")
    installed = tmp_path_factory.mktemp("prefix") / "installed"
    done = subprocess.run(
        [cmake, "--install", build, "--prefix", installed],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return installed.rename(installed.with_name("moved"))


@pytest.fixture(autouse=True)
def own_library(tmp_path, monkeypatch) -> Path:
    """A library of the user's own, empty: nobody's real one has a say."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path / "data" / "nacre"


@pytest.fixture(scope="session")
def templates() -> Path:
    return TEMPLATES


@pytest.fixture
def film_json(tmp_path) -> Path:
    """A film that bakes in no time."""
    path = tmp_path / "film.json"
    path.write_text(
        json.dumps(
            {
                "ambient": {"n": 1.0},
                "layer": [
                    {
                        "n": 1.33,
                        "thickness_nm": {"default": 200, "min": 0, "max": 400, "varies": True},
                    }
                ],
                "substrate": {"n": 1.5},
            }
        )
    )
    return path
