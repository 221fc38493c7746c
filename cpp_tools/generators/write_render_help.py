# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What `nacre render --help` prints, from the options of the program that renders.

    .venv/bin/python cpp_tools/generators/write_render_help.py >cpp_tools/apps/nacre/help/render.txt

Needs a Python with bpy, as that program does.
"""

from __future__ import annotations

import importlib
import os
import runpy
import sys
from pathlib import Path

COLUMNS = 112
_DRIVER = Path(__file__).parents[2] / "addon" / "background" / "driver.py"


def text() -> str:
    package = runpy.run_path(str(_DRIVER), run_name="driver")["load_package"]().__name__
    os.environ["COLUMNS"] = str(COLUMNS)
    return importlib.import_module(f"{package}.background.options").parser().format_help()


if __name__ == "__main__":
    sys.stdout.write(text())
