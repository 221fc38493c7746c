# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Two pictures have the same pixels, bit for bit; their metadata hold the time of rendering."""

from __future__ import annotations

import sys
from pathlib import Path

from support import pixels

first, second = (pixels(Path(path)) for path in sys.argv[2:4])
assert first == second
assert max(first) > min(first)
