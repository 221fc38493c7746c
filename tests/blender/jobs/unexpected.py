# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders in a Blender that raises what nobody thought of."""

from __future__ import annotations

from . import extension


def render(arguments: list[str], fails_at: str) -> int:
    """`driver.py render ARGUMENTS`, where the stage `fails_at` cannot be built."""
    made = extension.module("render")
    build = made.build_stage

    def gives_up(name: str):
        if name == fails_at:
            raise TypeError('bpy_struct: item.attr = val:\n enum "Data" not found in ()')
        return build(name)

    made.build_stage = gives_up
    try:
        return made.main(["render", *arguments])
    finally:
        made.build_stage = build
