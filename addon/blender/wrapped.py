# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences in panels: labels of Blender's are cut off where a panel ends."""

from __future__ import annotations

import textwrap

import bpy

_USUAL = 44  # letters that fit into a panel of the usual width
_FEWEST = 20
_LETTER, _MARGIN = 6.5, 75.0  # points: of a letter on average, and of what is beside a label


def label(layout: bpy.types.UILayout, text: str, icon: str) -> None:
    """As many lines as it takes, the icon before the first."""
    column = layout.column(align=True)
    for index, line in enumerate(textwrap.wrap(text, _letters(), break_on_hyphens=False)):
        column.label(text=line, icon="BLANK1" if index else icon)


def _letters() -> int:
    region = bpy.context.region
    if region is None:
        return _USUAL
    points = region.width / bpy.context.preferences.system.ui_scale
    return max(_FEWEST, int((points - _MARGIN) / _LETTER))
