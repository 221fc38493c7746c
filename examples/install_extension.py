# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Installs and enables an extension as a user does, through Blender's own operator.

usage: BLENDER_USER_RESOURCES=FOLDER install_extension.py FILE.zip
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy


def main() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="bl_pkg")
    archive = Path(sys.argv[1]).resolve()
    bpy.ops.extensions.package_install_files(
        repo="user_default", filepath=str(archive), enable_on_install=True
    )
    if "bl_ext.user_default.nacre" not in bpy.context.preferences.addons:
        sys.exit(f"{archive}: was not installed or not enabled")
    bpy.ops.wm.save_userpref()


main()
