# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Writes the page about the format of templates from its JSON schema, and so from the fields that C++ declares.

nacre library schema | python3 cpp_tools/generators/write_template_page.py >cpp_tools/doc/templates.md
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from typing import Any

HEAD = """\
# Templates

A template is the one source of a material: TOML, or JSON of the same shape. `nacre library schema` prints
its JSON schema, which editors complete and check by; this page is made from that
(`cpp_tools/generators/write_template_page.py`). `nacre library check FILE` tells all that is wrong with a
template, each with its line; `nacre compile` makes the material. How a stack is edited is in
[stacks.md](stacks.md).

<!-- file: violet_steel.toml -->
```toml
schema = 1

[material]
id = "violet_steel"
name = "Violet Steel"
category = "Mine/Steel"
source = "an example"

[ambient]
medium = "air"

[[layer]]
medium = "Fe3O4/Querry"
thickness_nm = { default = 45, min = 5, max = 70, varies = true }

[substrate]
medium = "Fe/Johnson"
```

<!-- run -->
```sh
nacre library check violet_steel.toml
nacre library schema >template.schema.json
```

`schema` is 1. A material is of the kind whose sections its template has: """
TITLES = {"layer": "[[layer]]", "parameter": "[[parameter]]"}
"""Of sections that may stand several times."""
TABLE = "| key | value | needed | what |\n|---|---|---|---|\n"
PLURALS = {"text": "texts", "number": "numbers"}


def number(value: float) -> str:
    return (
        f"{value:g}" if abs(value) < 1e6 else f"{value:.0e}".replace("e+0", "e").replace("e+", "e")
    )


def bounds(field: dict[str, Any]) -> str:
    low, high = field.get("minimum"), field.get("maximum")
    if "exclusiveMinimum" in field:
        above = f"above {number(field['exclusiveMinimum'])}"
        return above if high is None else f"{above}, to {number(high)}"
    if low is None or high is None:
        return "" if low is None else f"from {number(low)}"
    return f"{number(low)} … {number(high)}"


def value(field: dict[str, Any]) -> str:
    if "$ref" in field:
        return f"a {field['$ref'].rsplit('/', 1)[-1]}"
    if "enum" in field:
        return ", ".join(f"`{name}`" for name in field["enum"])
    if "oneOf" in field:
        kinds = [value(each) for each in field["oneOf"]]
        return kinds[0] + "".join(f", or {each}" for each in kinds[1:])
    if field["type"] == "object":
        return "`{ " + ", ".join(field["properties"]) + " }`"
    if field["type"] == "array":
        many = field.get("minItems"), field.get("maxItems")
        count = (
            ""
            if many[1] is None
            else f"{many[0]} to {many[1]} "
            if many[0] != many[1]
            else f"{many[0]} "
        )
        what, _, within = value(field["items"]).partition(" ")
        if what in PLURALS:
            return f"list of {count}{PLURALS[what]} {within}".rstrip()
        return f"list, each {what} {within}".rstrip()
    name = {"string": "text", "boolean": "true or false", "integer": "whole number"}
    return f"{name.get(field['type'], field['type'])} {bounds(field)}".rstrip()


def told(field: dict[str, Any]) -> str:
    if "description" in field:
        return field["description"]
    return next((told(each) for each in field.get("oneOf", ()) if told(each)), "")


def rows(section: dict[str, Any]) -> Iterator[str]:
    for key, field in section["properties"].items():
        needed = "yes" if key in section["required"] else ""
        yield f"| `{key}` | {value(field)} | {needed} | {told(field)} |\n"


def table(section: dict[str, Any]) -> str:
    return TABLE + "".join(rows(section))


def page(schema: dict[str, Any]) -> str:
    sections = schema["properties"]
    kinds = (" with ".join(f"`[{name}]`" for name in each["required"]) for each in schema["oneOf"])
    parts = [HEAD, ", or ".join(kinds), ".\n"]
    order = ["material", *(name for name in sections if name not in ("schema", "material"))]
    for name in order:
        section = sections[name]
        title = TITLES.get(name, f"[{name}]")
        parts.append(f"\n## `{title}`\n\n")
        if "$ref" in section:
            parts.append(f"{value(section).capitalize()}, see below.\n")
        elif section["type"] == "array":
            items = section["items"]
            named = [each["$ref"].rsplit("/", 1)[-1] for each in items.get("oneOf", ())]
            parts.append(
                f"Each is a {' or a '.join(named)}, see below.\n" if named else table(items)
            )
        else:
            parts.append(table(section))
    for name, definition in schema["$defs"].items():
        parts.append(f"\n## A {name}\n\n{table(definition)}")
    return "".join(parts)


def main() -> None:
    sys.stdout.write(page(json.load(sys.stdin)))


if __name__ == "__main__":
    main()
