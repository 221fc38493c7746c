# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Reads images with OpenImageIO's Python module, independent of the tool under test."""

from __future__ import annotations

import json

import numpy as np
import OpenImageIO as oiio


def read(path):
    """Pixels (height, width, channels) as float, attributes by name."""
    image = oiio.ImageBuf(str(path))
    pixels = image.get_pixels(oiio.FLOAT)
    assert pixels is not None, image.geterror()
    return pixels, {attribute.name: attribute.value for attribute in image.spec().extra_attribs}


def spec(path):
    return oiio.ImageBuf(str(path)).spec()


def attribute(attributes, name):
    """An attribute that holds JSON."""
    return json.loads(attributes[f"nacre:{name}"])


def write(path, pixels, data_format=oiio.FLOAT, **attributes):
    """An image as somebody else's program writes it."""
    pixels = np.asarray(pixels, dtype=np.float32)
    height, width, channels = pixels.shape
    image_spec = oiio.ImageSpec(width, height, channels, data_format)
    for name, value in attributes.items():
        image_spec.attribute(name, value)
    buffer = oiio.ImageBuf(image_spec)
    assert buffer.set_pixels(oiio.ROI(), pixels)
    assert buffer.write(str(path), data_format), buffer.geterror()
