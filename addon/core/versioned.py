# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON that files keep, an object with a number of its version."""

from __future__ import annotations

import json
from typing import Any

from .faults import ForeseenError


def parsed(text: str, newest: int, fault: type[ForeseenError]) -> dict[str, Any]:
    """What it says besides its version. Raises `fault` that says what is wrong."""
    try:
        said = json.loads(text)
        version = said.pop("version")
        is_newer = version > newest
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise fault(f"cannot be read: {error!r}") from error
    if is_newer:
        raise fault(f"is of version {version}, made by a newer Nacre; this one knows {newest}")
    return said
