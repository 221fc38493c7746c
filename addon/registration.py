# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension adds to Blender, in the order in which it is added."""

from __future__ import annotations

import bpy

from . import properties
from .operators import assign, fix, thickness
from .ui import panels, preferences

_CLASSES = (
    properties.NACRE_PG_scene,
    preferences.NACRE_preferences,
    *assign.CLASSES,
    *fix.CLASSES,
    *thickness.CLASSES,
    *panels.CLASSES,
)

_commands: list[object] = []


def register() -> None:
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.nacre = bpy.props.PointerProperty(type=properties.NACRE_PG_scene)
    panels.add_to_menus()
    _commands.append(bpy.utils.register_cli_command("nacre", _run_command))


def unregister() -> None:
    while _commands:
        bpy.utils.unregister_cli_command(_commands.pop())
    panels.remove_from_menus()
    del bpy.types.Scene.nacre
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)


def _run_command(argv: list[str]) -> int:
    """`blender --command nacre …`; a scene is rendered without the modules being loaded before."""
    from . import render

    return render.main(argv)
