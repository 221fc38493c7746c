# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What takes long to make is made once for all processes of a run."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from .templates import write_toml
from .tool import nacre

_DONE, _FAILED = ".done", ".failed"
_PATIENCE = 600.0  # seconds


def made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], object]) -> Path:
    """A folder that `make` fills in the first process that asks for it; the others wait for that."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        folder = factory.mktemp(name)
        make(folder)
        return folder
    folder = factory.getbasetemp().parent / name
    try:
        folder.mkdir()
    except FileExistsError:
        _wait_for(folder)
        return folder
    try:
        make(folder)
    except BaseException:
        (folder / _FAILED).touch()
        raise
    (folder / _DONE).touch()
    return folder


def compiled_once(factory: pytest.TempPathFactory, name: str, templates: dict[str, dict]) -> Path:
    """A folder of materials, compiled from templates by their ids."""

    def make(folder: Path) -> None:
        files = [folder / f"{material}.toml" for material in templates]
        for file, template in zip(files, templates.values(), strict=True):
            write_toml(file, template)
        nacre("compile", *files, "-o", folder / "materials", "--quiet")

    return made_once(factory, name, make) / "materials"


def _wait_for(folder: Path) -> None:
    deadline = time.monotonic() + _PATIENCE
    while not (folder / _DONE).exists():
        if (folder / _FAILED).exists():
            raise RuntimeError(
                f"{folder.name}: could not be made by another process, which says why"
            )
        if time.monotonic() > deadline:
            raise TimeoutError(f"{folder.name}: is still being made after {_PATIENCE:.0f} s")
        time.sleep(0.1)
