# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Installs the archive through Blender's own operator, uses it, and switches it off: FILE.zip MATERIAL."""

from __future__ import annotations

import sys

import bpy

archive, expected = sys.argv[1], sys.argv[2]
bpy.ops.preferences.addon_enable(module="bl_pkg")
bpy.ops.extensions.package_install_files(
    repo="user_default", filepath=archive, enable_on_install=True
)
name = "bl_ext.user_default.nacre"
assert name in bpy.context.preferences.addons
bpy.ops.mesh.primitive_cube_add()
assert bpy.ops.nacre.assign_material(material=expected) == {"FINISHED"}
assert bpy.context.preferences.addons[name].preferences is not None
bpy.ops.preferences.addon_disable(module=name)
assert "NACRE_OT_assign_material" not in dir(bpy.types)
bpy.ops.preferences.addon_enable(module=name)
assert "NACRE_OT_assign_material" in dir(bpy.types)
bpy.ops.preferences.addon_disable(module=name)
