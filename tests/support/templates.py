# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Templates that tests make up, written as a person would not."""

from __future__ import annotations

import json
from pathlib import Path


def toml(value) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def write_toml(file: Path, template: dict) -> None:
    lines = [f"{key} = {toml(item)}\n" for key, item in template.items()]
    file.write_text("".join(lines), "utf-8")
