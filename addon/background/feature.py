# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`blender --command nacre`, as a part of the extension."""

from __future__ import annotations

import bpy

_commands: list[object] = []


def _run(argv: list[str]) -> int:
    """The program is loaded when it is asked for."""
    from . import render

    return render.main(argv)


class _Command:
    def register(self) -> None:
        _commands.append(bpy.utils.register_cli_command("nacre", _run))

    def unregister(self) -> None:
        while _commands:
            bpy.utils.unregister_cli_command(_commands.pop())


CLASSES = ()
PARTS = (_Command(),)
