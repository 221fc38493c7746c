# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Where things are: the checkout's folders, and what was built of it.

NACRE names the command-line tool, which has its driver and the Python package beside it,
NACRE_MATERIALS the compiled materials; both default to the release build.
"""

from __future__ import annotations

import json
import os
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ADDON = ROOT / "addon"
TEMPLATES = ROOT / "osl" / "templates"
RELEASE = ROOT / "build" / "release"
# Compiled materials that are small, and stay as they are.
OPTICAL_CONSTANTS = ROOT / "cpp_tools" / "data" / "optical_constants"
FIXTURES = ROOT / "tests" / "addon" / "fixtures"
# One of a kind that there is not.
OTHER_KINDS = ROOT / "tests" / "addon" / "other_kinds"
STAGE_EXTENSION = ROOT / "cpp_tools" / "generators" / "stage_extension.py"


def tool() -> Path:
    return Path(os.environ.get("NACRE", RELEASE / "bin" / "nacre"))


SHARE = tool().absolute().parents[1] / "share" / "nacre"
DRIVER = SHARE / "addon" / "background" / "driver.py"
# Where the tool has the Python package, as a user finds it: with its library beside it.
PACKAGE = SHARE / "python"


def materials_folder() -> Path:
    return Path(os.environ.get("NACRE_MATERIALS", RELEASE / "share" / "nacre" / "materials"))


@cache
def manifest(material: str) -> dict:
    return json.loads((materials_folder() / material / f"{material}.json").read_text("utf-8"))
