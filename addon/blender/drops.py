# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are dropped onto Nacre's panels. Elsewhere in the viewport they are Blender's."""

from __future__ import annotations

import bpy


class OntoPanels:
    """Of a FileHandler."""

    @classmethod
    def poll_drop(cls, context):
        area, region = context.area, context.region
        if area is None or region is None:
            return False
        kind = getattr(bpy.ops.nacre, cls.bl_import_operator.partition(".")[2])
        has_panel = area.type == "PROPERTIES" or region.type == "UI"
        return has_panel and kind.poll()
