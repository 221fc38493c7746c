# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The package of the checkout over the library that NACRE_LIBRARY names, else the release build's."""

from __future__ import annotations

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
os.environ.setdefault("NACRE_LIBRARY", str(ROOT / "build" / "release" / "lib" / "libnacre.so"))
os.environ["XDG_DATA_HOME"] = os.devnull  # nobody's own library has a say
sys.path.insert(0, str(ROOT / "cpp_tools" / "python"))
