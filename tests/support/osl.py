# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Shader texts as Cycles' compiler takes them, which knows no include path."""

from __future__ import annotations

import re
from collections.abc import Iterable

from support.paths import ROOT

INCLUDE = ROOT / "osl" / "include"
SHADERS = sorted((ROOT / "osl" / "shaders").rglob("*.osl"))

SHADER_MATERIALS = {
    path.stem.removeprefix("nacre_"): path
    for path in SHADERS
    if "string category = " in path.read_text("utf-8")
}
"""Those that say where they are listed, by the id of their material."""


def inline(text: str, seen: set[str] | None = None) -> str:
    """OSL text with our includes in place."""
    seen = set() if seen is None else seen
    lines = []
    for line in text.splitlines():
        found = re.fullmatch(r'#include "(nacre/[^"]+)"', line)
        if not found:
            if line != "#pragma once":
                lines.append(line)
        elif found[1] not in seen:
            seen.add(found[1])
            lines.append(inline((INCLUDE / found[1]).read_text(encoding="utf-8"), seen))
    return "\n".join(lines) + "\n"


def shader(name: str) -> str:
    """A shader of the checkout."""
    path = next(path for path in SHADERS if path.stem == name)
    return inline(path.read_text(encoding="utf-8"))


def probe(headers: Iterable[str], body: str) -> str:
    """A shader whose column i shows the `color value` that `body` sets."""
    includes = "".join(f'#include "nacre/{name}"\n' for name in headers)
    return inline(
        f"{includes}shader probe(output closure color BSDF = 0)\n"
        "{\n    int i = (int)floor(P[0]);\n    color value = 0.0;\n"
        f"{body}\n    BSDF = value * emission();\n}}\n"
    )


def osl_array(name: str, values) -> str:
    items = ", ".join(f"{float(value)!r}" for value in values)
    return f"float {name}[{len(values)}] = {{ {items} }};\n"
