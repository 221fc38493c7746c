# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension adds to Blender, in the order in which it is added."""

from __future__ import annotations

import bpy

from .assets import build as asset_library
from .assets import operators as assets
from .assets import process as asset_build
from .blender import asset_libraries, drops
from .browser import assign, thumbnails
from .browser import panel as browser
from .films import colours as film_colours
from .films import live, properties, swatch
from .films import operators as stack
from .films import panel as stack_panel
from .help import operators as manual
from .lighting import operators as lighting
from .looks import my_looks
from .looks import operators as looks
from .looks import panel as looks_panel
from .materials import fallback, fix, follow, limits, preferences, schema
from .materials import menu as menus
from .materials import panel as panels
from .thickness import operators as thickness
from .variations import drawn as variations
from .variations import operators as variation_operators
from .variations import panel as variations_panel
from .viewer import panel as viewer_panel
from .viewer import pass_operators as passes
from .viewer import picture, views
from .viewer import probe_operators as probe

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
    from .background import render

    return render.main(argv)
