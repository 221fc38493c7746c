# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of a scene and of a session. Features add theirs to these groups when they are registered."""

from __future__ import annotations

import bpy
from bpy.props import EnumProperty, PointerProperty

# The numbers are stored in .blend files: append, never reorder.
FORMS = (
    ("auto", "Automatic", "Open Shading Language where the renderer runs it, else nodes", 0),
    ("osl", "Open Shading Language", "Exact colours; Cycles on the CPU or with OptiX", 1),
    ("nodes", "Nodes", "Works in EEVEE and on every GPU; colours outside the gamut are clipped", 2),
)


class NACRE_PG_scene(bpy.types.PropertyGroup):
    form: EnumProperty(
        name="Form",
        description="Which form new wave materials take",
        items=FORMS,
        default="auto",
    )


class NACRE_PG_session(bpy.types.PropertyGroup):
    """Of this session, in no file."""


CLASSES = (NACRE_PG_scene, NACRE_PG_session)


def register() -> None:
    bpy.types.Scene.nacre = PointerProperty(type=NACRE_PG_scene)
    bpy.types.WindowManager.nacre = PointerProperty(type=NACRE_PG_session)


def unregister() -> None:
    del bpy.types.WindowManager.nacre
    del bpy.types.Scene.nacre
