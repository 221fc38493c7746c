# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are dropped onto Nacre's panels. Elsewhere in the viewport they are Blender's."""

from __future__ import annotations

import bpy


class _OntoPanels:
    @classmethod
    def poll_drop(cls, context):
        area, region = context.area, context.region
        if area is None or region is None:
            return False
        kind = getattr(bpy.ops.nacre, cls.bl_import_operator.partition(".")[2])
        has_panel = area.type == "PROPERTIES" or region.type == "UI"
        return has_panel and kind.poll()


class NACRE_FH_thickness_image(_OntoPanels, bpy.types.FileHandler):
    bl_idname = "NACRE_FH_thickness_image"
    bl_label = "Nacre: Thickness from Picture"
    bl_import_operator = "nacre.open_thickness_image"
    bl_file_extensions = ".png;.jpg;.jpeg;.tif;.tiff;.exr;.hdr;.webp;.bmp;.tga"


class NACRE_FH_template(_OntoPanels, bpy.types.FileHandler):
    bl_idname = "NACRE_FH_template"
    bl_label = "Nacre: Film from Template"
    bl_import_operator = "nacre.load_template"
    bl_file_extensions = ".toml"


CLASSES = (NACRE_FH_thickness_image, NACRE_FH_template)
