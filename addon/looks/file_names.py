# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that a user gives as names of files that every system takes, and back."""

from __future__ import annotations

import re
import unicodedata
from urllib.parse import unquote

LONGEST = 63
"""Bytes of a name: as many as Blender 4.5 keeps."""

_RESERVED = re.compile(r'[<>:"/\\|?*%\x00-\x1f\x7f]')
# Devices of Windows, with any suffix.
_DEVICES = re.compile(r"(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(\..*)?", re.IGNORECASE)


def tidy(name: str) -> str:
    """As it is shown: composed, without what surrounds it, and not too long."""
    whole = "".join(c if c.isprintable() else " " for c in unicodedata.normalize("NFC", name))
    return whole.strip().encode()[:LONGEST].decode(errors="ignore").strip()


def stem(name: str) -> str:
    """Without a suffix. What is reserved is written as `%` and its code."""
    found = _RESERVED.sub(lambda match: f"%{ord(match[0]):02X}", name)
    if found.startswith(".") or _DEVICES.fullmatch(found):
        found = f"%{ord(found[0]):02X}{found[1:]}"
    if found.endswith((".", " ")):
        found = f"{found[:-1]}%{ord(found[-1]):02X}"
    return found


def name_of(file_stem: str) -> str:
    return unquote(file_stem)


def is_same(name: str, other: str) -> bool:
    """Whether some system takes them for one file."""
    return tidy(name).casefold() == tidy(other).casefold()


def free(name: str, taken) -> str:
    """The name, or with the first number that makes it free."""
    number, found = 2, name
    while any(is_same(found, other) for other in taken):
        found = f"{tidy(name).encode()[: LONGEST - 6].decode(errors='ignore')} {number}"
        number += 1
    return found
