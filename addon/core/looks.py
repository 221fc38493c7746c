# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How materials look their best: what they are pictured on, and what their thickness follows. What varies
is offered twice: as its picture shows it, and even."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .library import Entry

EVEN = ":even"
"""What the key of a variant of one thickness ends with."""
_WORD = re.compile(r"[a-z][a-z0-9_]*")


@dataclass(frozen=True)
class Look:
    object: str = ""
    thickness: tuple[str, ...] = ()  # `SOURCE[:NAME=VALUE,…]`, the lowest first


PLAIN = Look()


def look_of(data: Mapping[str, Any]) -> Look | None:
    """Of a manifest; None where it is not as it must be."""
    given = data.get("look", {})
    if not isinstance(given, dict):
        return None
    name, thickness = given.get("object", ""), given.get("thickness", [])
    if not isinstance(name, str) or (name and not _WORD.fullmatch(name)):
        return None
    if not isinstance(thickness, list) or not all(isinstance(text, str) for text in thickness):
        return None
    return Look(name, tuple(thickness))


@dataclass(frozen=True)
class Variant:
    """A material as lists offer it; `key` is what operators and favourites know it by."""

    key: str
    name: str
    entry: Entry
    is_even: bool

    @property
    def label(self) -> str:
        """Under a picture, where long names are cut off at the end."""
        return f"Even {self.entry.name}" if self.is_even else self.name


def variants(entries: Mapping[str, Entry]) -> dict[str, Variant]:
    """By key, in the order of the entries; the even ones follow those that vary."""
    found = []
    for entry in entries.values():
        found.append(Variant(entry.id, entry.name, entry, False))
        if entry.varies:
            found.append(Variant(entry.id + EVEN, even_name(entry.name), entry, True))
    return {variant.key: variant for variant in found}


def even_name(name: str) -> str:
    return f"{name}, Even"


def picture_name(key: str) -> str:
    """Of the file with its picture, without the suffix; a dot is in no id."""
    return key.replace(":", ".")
