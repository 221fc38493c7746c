# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension adds to Blender: each of its features has a module `feature` with CLASSES, and PARTS that
are registered when all classes are."""

from __future__ import annotations

from importlib import import_module

import bpy

# As their panels follow each other. Handlers of one event run in this order, too.
NAMES = (
    "browser",
    "lighting",
    "materials",
    "presets",
    "films",
    "thickness",
    "gems",
    "variations",
    "looks",
    "viewer",
    "spectral",
    "develop",
    "assets",
    "help",
    "background",
)
FEATURES = tuple(import_module(f".{name}.feature", __package__) for name in NAMES)


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
