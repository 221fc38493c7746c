# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension adds to Blender, in the order in which it is added."""

from __future__ import annotations

import bpy

from . import properties
from .nodes import (
    asset_build,
    asset_libraries,
    fallback,
    film_colours,
    follow,
    limits,
    live,
    my_looks,
    schema,
    thumbnails,
    variations,
    views,
)
from .nodes import assets as asset_library
from .operators import (
    assets,
    assign,
    fix,
    lighting,
    looks,
    manual,
    passes,
    picture,
    probe,
    stack,
    thickness,
)
from .operators import variations as variation_operators
from .ui import (
    browser,
    drops,
    looks_panel,
    menus,
    panels,
    preferences,
    stack_panel,
    swatch,
    variations_panel,
    viewer_panel,
)

_CLASSES = (
    *properties.CLASSES,
    preferences.NACRE_preferences,
    *assets.CLASSES,
    *assign.CLASSES,
    *fix.CLASSES,
    *lighting.CLASSES,
    *manual.CLASSES,
    *thickness.CLASSES,
    *stack.CLASSES,
    *looks.CLASSES,
    *variation_operators.CLASSES,
    *passes.CLASSES,
    *picture.CLASSES,
    *probe.CLASSES,
    *browser.CLASSES,
    *panels.CLASSES,
    *stack_panel.CLASSES,
    *variations_panel.CLASSES,
    *looks_panel.CLASSES,
    *menus.CLASSES,
    *drops.CLASSES,
    *viewer_panel.CLASSES,
)

_commands: list[object] = []


def register() -> None:
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    properties.register()
    schema.register()
    live.register()
    views.register()
    fallback.register()
    follow.register()
    film_colours.register()
    limits.register()
    asset_build.register()
    thumbnails.register()
    my_looks.register()
    menus.add_to_menus()
    bpy.utils.register_manual_map(manual.manual_map)
    if asset_library.is_built(asset_library.default_folder()):
        asset_library.show(asset_library.default_folder())
    _commands.append(bpy.utils.register_cli_command("nacre", _run_command))


def unregister() -> None:
    while _commands:
        bpy.utils.unregister_cli_command(_commands.pop())
    bpy.utils.unregister_manual_map(manual.manual_map)
    menus.remove_from_menus()
    asset_build.unregister()
    asset_libraries.remove(asset_library.default_folder())
    limits.unregister()
    film_colours.unregister()
    follow.unregister()
    fallback.unregister()
    views.unregister()
    live.unregister()
    schema.unregister()
    swatch.unregister()
    my_looks.unregister()
    variations.forget()
    thumbnails.unregister()
    probe.forget()
    properties.unregister()
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)


def _run_command(argv: list[str]) -> int:
    """`blender --command nacre …`; a scene is rendered without the modules being loaded before."""
    from . import render

    return render.main(argv)
