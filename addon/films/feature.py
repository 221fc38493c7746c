# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stack editor, as a part of the extension."""

from __future__ import annotations

from ..blender.parts import Joined
from ..materials import material, menu
from . import colours, live, operators, panel, properties

CLASSES = (*properties.CLASSES, *operators.CLASSES, *panel.CLASSES)
PARTS = (
    properties,
    live,
    Joined(material.WHEN_MADE, colours.describe),
    menu.entries(20, "edit_stack", "add_layer", "revert_stack", "load_template", "save_template"),
)
