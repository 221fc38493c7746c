# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of a compiled OSL shader. An `.oso` is text; Blender's wheel has no `oslquery`."""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass

from .faults import ForeseenError
from .space import Matrix, converted, dual

# A string may hold whatever else has a meaning here, a quote after a backslash among it.
_STRING = r'"(?:[^"\\\n]|\\.)*"'
_PARAMETER = re.compile(
    rf"^(o?param)\t(closure color|\S+)\t(\S+)\t({_STRING}|[^%\n]*)(.*)$", re.MULTILINE
)
_LABEL = re.compile(rf"%meta\{{string,label,({_STRING})\}}")
_META = re.compile(rf"%meta\{{[^,{{}}]*,[^,{{}}]*,(?:{_STRING}|[^\"}}]*)\}}")
_ESCAPE = re.compile(r"\\(.)")
_ESCAPED = {"n": "\n", "t": "\t", "r": "\r"}
# The compiler writes folders as they are, so that a quote or line end in one would end what it is in.
_HEADER = re.compile(
    r"\A(OpenShadingLanguage [^\n]*\n).*?^(?=(?:shader|surface|displacement|volume)\s)",
    re.DOTALL | re.MULTILINE,
)
_SOURCE_LINE = re.compile(r"^#.*\n", re.MULTILINE)
_SOURCE_FILE = re.compile(r'[ ]?%filename\{".*?"\}', re.DOTALL)
DUALS = ("tint_basis",)


class OsoError(ForeseenError):
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
        default=None if "%initexpr" in _META.sub("", hints) else _default(kind, default.strip()),
        label=_unquoted(label.group(1)) if label else name,
    )


def _default(kind: str, text: str) -> tuple[float, ...] | str | None:
    if kind == "string":
        return _unquoted(text)
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


def _unquoted(text: str) -> str:
    return _ESCAPE.sub(lambda found: _ESCAPED.get(found.group(1), found.group(1)), text[1:-1])


def strip_provenance(text: str, *names: str) -> str:
    """The same program without the compiler's version, source lines and folders: equal shaders, equal
    bytes. `names`: of files and folders that it was made from, wherever they are."""
    for name in names:
        text = text.replace(name, "")
    return _SOURCE_FILE.sub("", _SOURCE_LINE.sub("", _HEADER.sub(r"\1", text)))


def bytecode_hash(text: str) -> str:
    """What Blender compares to see whether a node's bytecode has changed."""
    return hashlib.md5(text.encode(), usedforsecurity=False).hexdigest()
