# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of a compiled OSL shader. An `.oso` is text; Blender's wheel has no `oslquery`."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass

from .space import Matrix, converted, dual

_PARAMETER = re.compile(r"^(o?param)\t(closure color|\S+)\t(\S+)\t([^%\n]*)(.*)$", re.MULTILINE)
_LABEL = re.compile(r'%meta\{string,label,"([^"]*)"\}')
DUALS = ("tint_basis",)
_HEADER_COMMENT = re.compile(r"^# (?:Compiled by|options:).*\n", re.MULTILINE)


class OsoError(Exception):
    """The text is not a compiled OSL shader."""


@dataclass(frozen=True)
class Parameter:
    name: str
    type: str  # as in OSL: float, int, color, vector, normal, point, string, closure color
    is_output: bool
    default: tuple[float, ...] | str | None  # None where only running the shader gives it
    label: str


def parse_parameters(text: str) -> tuple[Parameter, ...]:
    if not text.startswith("OpenShadingLanguage"):
        raise OsoError("not a compiled OSL shader: must start with 'OpenShadingLanguage'")
    return tuple(_parameter(match) for match in _PARAMETER.finditer(text))


def _parameter(match: re.Match[str]) -> Parameter:
    direction, kind, name, default, hints = match.groups()
    label = _LABEL.search(hints)
    return Parameter(
        name=name,
        type=kind,
        is_output=direction == "oparam",
        default=None if "%initexpr" in hints else _default(kind, default.strip()),
        label=label.group(1) if label else name,
    )


def _default(kind: str, text: str) -> tuple[float, ...] | str | None:
    if kind == "string":
        return text.strip('"')
    if not text:
        return None
    return tuple(float(word) for word in text.split())


def convert_colours(text: str, matrix: Matrix | None) -> str:
    """The same program with the defaults of its colours, arrays of them too, in another space.

    What DUALS names is multiplied by colours, and each product is the same in every space.
    """
    if matrix is None:
        return text

    def convert(match: re.Match[str]) -> str:
        direction, kind, name, default, hints = match.groups()
        numbers = default.split()
        if not re.fullmatch(r"color(\[\d+\])?", kind) or direction != "param" or not numbers:
            return match.group()
        how = dual(matrix) if name in DUALS else matrix
        colours = [
            converted(how, [float(number) for number in numbers[i : i + 3]])
            for i in range(0, len(numbers), 3)
        ]
        ending = default[len(default.rstrip()) :]
        written = " ".join(f"{channel:.9g}" for colour in colours for channel in colour)
        return f"{direction}\t{kind}\t{name}\t{written}{ending}{hints}"

    return _PARAMETER.sub(convert, text)


def strip_provenance(text: str) -> str:
    """The same program without the compiler's version and folders: equal shaders, equal bytes."""
    return _HEADER_COMMENT.sub("", text)


def bytecode_hash(text: str) -> str:
    """What Blender compares to see whether a node's bytecode has changed."""
    return hashlib.md5(text.encode(), usedforsecurity=False).hexdigest()
