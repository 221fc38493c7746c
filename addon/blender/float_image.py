# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures that were computed, as images of the file."""

from __future__ import annotations

import bpy
import numpy as np


def as_image(rgb: np.ndarray, alpha: np.ndarray, name: str) -> bpy.types.Image:
    """A picture of the file in its linear space, row 0 on top, which editors show as they show renders; one
    of that name is filled anew."""
    height, width = rgb.shape[:2]
    pixels = np.concatenate([rgb, alpha[..., None]], axis=-1, dtype=np.float32)
    image = bpy.data.images.get(name)
    if image is None or tuple(image.size) != (width, height):
        if image is not None:
            bpy.data.images.remove(image)
        image = bpy.data.images.new(
            name, width, height, alpha=True, float_buffer=True, is_data=False
        )
        image.alpha_mode = "PREMUL"
        image.use_view_as_render = True
    image.pixels.foreach_set(np.ascontiguousarray(pixels[::-1]).ravel())
    image.update()
    return image
