# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Runs the command-line tool: the one that NACRE names, else that of the release build."""

from __future__ import annotations

import json
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
