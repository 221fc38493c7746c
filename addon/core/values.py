# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Values given by name for a material's sockets: `--set thickness_nm=420`."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from .faults import ForeseenError
from .manifest import DIRECTIONS, CompiledMaterial, Socket


class AssignmentError(ForeseenError):
    """A value does not fit; one line for each fault."""


def parse_assignments(material: CompiledMaterial, texts: Iterable[str]) -> dict[str, Any]:
    values: dict[str, Any] = {}
    problems = []
    for text in texts:
        name, equals, value = text.partition("=")
        socket = material.socket(name)
        if not equals:
            problems.append(f"must be name=value (got {text!r})")
        elif socket is None or socket.type in DIRECTIONS:
            known = (
                ", ".join(s.name for s in material.sockets if s.type not in DIRECTIONS) or "none"
            )
            problems.append(f"{material.id} has no value {name!r}; there are: {known}")
        else:
            parsed, problem = _parse(socket, value)
            if problem:
                problems.append(f"{name}: {problem} (got {value})")
            values[name] = parsed
    if problems:
        raise AssignmentError("\n".join(problems))
    return values


def _parse(socket: Socket, text: str) -> tuple[Any, str | None]:
    words = text.split(",") if socket.type == "color" else [text]
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        return None, "must be a number" if socket.type != "color" else "must be R,G,B"
    if not all(map(math.isfinite, numbers)):
        return None, "must be finite"
    if socket.type == "color":
        if len(numbers) != 3 or min(numbers) < 0:
            return None, "must be R,G,B, each ≥ 0"
        return (*numbers, 1.0), None
    number = numbers[0]
    if socket.type == "int" and number != int(number):
        return None, "must be a whole number"
    if not socket.minimum <= number <= socket.maximum:
        unit = "" if socket.unit in ("", "1") else f" {socket.unit}"
        return None, f"must be in [{socket.minimum:g}, {socket.maximum:g}]{unit}"
    return (int(number) if socket.type == "int" else number), None
