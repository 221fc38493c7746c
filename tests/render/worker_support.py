# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the scripts that run inside Blender share."""

from __future__ import annotations

import importlib.util
from pathlib import Path

ADDON = Path(__file__).resolve().parents[2] / "addon"


def load_extension() -> str:
    """Imports the extension from the checkout; returns its package's name."""
    spec = importlib.util.spec_from_file_location("nacre_driver", ADDON / "driver.py")
    driver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(driver)
    driver.load_package()
    return driver.PACKAGE
