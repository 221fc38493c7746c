# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a Blender says of itself."""

from __future__ import annotations

import bpy


def scripts_folder() -> str:
    return bpy.utils.system_resource("SCRIPTS")
