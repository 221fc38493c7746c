# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Values that belong together: `presets` in cpp_tools/doc/manifest.md."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from .faults import ForeseenError


class PresetError(ForeseenError):
    """There is no preset of that name."""


@dataclass(frozen=True)
class Preset:
    name: str
    values: Mapping[str, float]  # by the sockets' manifest names


def parse_presets(
    data: Any, where: str, sockets: Collection[str], problems: list[str]
) -> tuple[Preset, ...]:
    """Appends every fault to `problems`."""
    if not isinstance(data, list):
        problems.append(f"{where}: must be a list (got {data!r})")
        return ()
    presets = []
    for index, item in enumerate(data):
        at = f"{where}[{index}]"
        name = item.get("name") if isinstance(item, dict) else None
        values = item.get("values") if isinstance(item, dict) else None
        if not isinstance(name, str) or not name or not isinstance(values, dict):
            problems.append(f"{at}: must be an object with a name and values (got {item!r})")
            continue
        for key, value in values.items():
            if key not in sockets:
                problems.append(
                    f"{at}.values: {key!r} must be one of the numbers: {', '.join(sockets)}"
                )
            if isinstance(value, bool) or not isinstance(value, (int, float)):
                problems.append(f"{at}.values.{key}: must be a number (got {value!r})")
        presets.append(Preset(name, values))
    return tuple(presets)


def text(presets: Iterable[Preset]) -> str:
    """For `read`."""
    return json.dumps([{"name": each.name, "values": dict(each.values)} for each in presets])


@lru_cache(maxsize=64)
def read(stored: str) -> tuple[Preset, ...]:
    """What `text` wrote, or nothing."""
    try:
        return tuple(Preset(item["name"], item["values"]) for item in json.loads(stored))
    except (ValueError, KeyError, TypeError):
        return ()


def named(presets: Iterable[Preset], name: str) -> Preset:
    """Upper and lower case are the same here."""
    known = tuple(presets)
    for preset in known:
        if preset.name.casefold() == name.casefold():
            return preset
    there = ", ".join(preset.name for preset in known) or "none"
    raise PresetError(f"there is no preset {name!r}; there are: {there}")
