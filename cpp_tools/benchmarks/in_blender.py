# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The extension inside a Python with bpy, for benchmarks that run there."""

from __future__ import annotations

import importlib
import importlib.util
from pathlib import Path

PACKAGE = "nacre_extension"


def load_extension(folder: Path) -> None:
    spec = importlib.util.spec_from_file_location(
        "nacre_driver", folder / "background" / "driver.py"
    )
    driver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(driver)
    driver.load_package(PACKAGE)


def extension(module: str):
    return importlib.import_module(f"{PACKAGE}.{module}")
