# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Renders in a Blender that raises what nobody thought of."""

from __future__ import annotations

from . import extension


def render(arguments: list[str], fails_at: str) -> int:
    """`driver.py render ARGUMENTS`, where the stage `fails_at` cannot be built."""
    made = extension.module("background.render")
    build = made.build_stage

    def gives_up(name: str, object_name: str):
        if name == fails_at:
            raise TypeError('bpy_struct: item.attr = val:\n enum "Data" not found in ()')
        return build(name, object_name)

    made.build_stage = gives_up
    try:
        return made.main(["render", *arguments])
    finally:
        made.build_stage = build


def pixel(arguments: list[str]) -> int:
    """The same, where no spectrum of a film can be computed."""
    probe = extension.module("viewer.probe")
    lights = probe._lights

    def unknown(*_arguments):
        raise extension.module("films.stack").StackError("no such medium")

    probe._lights = unknown
    try:
        return extension.module("background.render").main(["render", *arguments])
    finally:
        probe._lights = lights
