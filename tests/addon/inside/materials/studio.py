# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""A file from a Blender with another colour config: its tables are numbers again. Arguments: FILE."""

from __future__ import annotations

import sys

import bpy

from jobs.extension import load, module

extension = load()
images = module("materials.image")


def tables() -> list[bpy.types.Image]:
    return [image for image in bpy.data.images if images.DIGEST in image]


# Without the extension Blender puts no space, or one for colours, in the place of what it does not know.
bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
assert tables()
assert not any(image.colorspace_settings.is_data for image in tables())

extension.register()
bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
assert all(image.colorspace_settings.is_data for image in tables())
assert all(image.packed_file and not images.is_missing(image) for image in tables())
extension.unregister()
