# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension adds to Blender: each of its features has a module `feature` with CLASSES, and PARTS that
are registered when all classes are."""

from __future__ import annotations

import bpy

from .assets import feature as assets
from .background import feature as background
from .browser import feature as browser
from .films import feature as films
from .gems import feature as gems
from .help import feature as help_
from .lighting import feature as lighting
from .looks import feature as looks
from .materials import feature as materials
from .thickness import feature as thickness
from .variations import feature as variations
from .viewer import feature as viewer

# As their panels follow each other. Handlers of one event run in this order, too.
FEATURES = (
    browser,
    lighting,
    materials,
    films,
    thickness,
    gems,
    variations,
    looks,
    viewer,
    assets,
    help_,
    background,
)


def classes() -> list[type]:
    return [cls for feature in FEATURES for cls in feature.CLASSES]


def register() -> None:
    for cls in classes():
        bpy.utils.register_class(cls)
    for feature in FEATURES:
        for part in feature.PARTS:
            part.register()


def unregister() -> None:
    for feature in reversed(FEATURES):
        for part in reversed(feature.PARTS):
            part.unregister()
    for cls in reversed(classes()):
        bpy.utils.unregister_class(cls)
