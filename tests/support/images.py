# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Pictures as arrays, by OpenImageIO's own module and not by the tool under test."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import OpenImageIO as oiio


def read_image(file: Path | str) -> np.ndarray:
    """RGB as float64, shape (height, width, 3)."""
    source = oiio.ImageInput.open(str(file))
    assert source, oiio.geterror()
    pixels = source.read_image(0, 0, 0, 3, oiio.FLOAT)
    source.close()
    return np.asarray(pixels, dtype=np.float64)


def read_channels(file: Path | str, names: Sequence[str]) -> tuple[np.ndarray, dict[str, object]]:
    """Channels by their names, shape (height, width, len(names)), and the file's attributes."""
    source = oiio.ImageInput.open(str(file))
    assert source, oiio.geterror()
    spec = source.spec()
    pixels = np.asarray(source.read_image(oiio.FLOAT), dtype=np.float64)
    source.close()
    attributes = {item.name: item.value for item in spec.extra_attribs}
    return pixels[..., [spec.channelnames.index(name) for name in names]], attributes


def write_channels(
    file: Path, pixels: np.ndarray, names: Sequence[str], attributes: dict[str, int]
) -> None:
    """Half floats as EXR."""
    height, width, channels = pixels.shape
    file.parent.mkdir(parents=True, exist_ok=True)
    target = oiio.ImageOutput.create(str(file))
    spec = oiio.ImageSpec(width, height, channels, "half")
    spec.channelnames = tuple(names)
    spec.attribute("compression", "zip")
    for name, value in attributes.items():
        spec.attribute(name, value)
    assert target.open(str(file), spec), target.geterror()
    assert target.write_image(pixels.astype(np.float32)), target.geterror()
    target.close()


def read_all(path: Path | str) -> tuple[np.ndarray, dict]:
    """All channels as float32, shape (height, width, channels), and attributes by name."""
    image = oiio.ImageBuf(str(path))
    pixels = image.get_pixels(oiio.FLOAT)
    assert pixels is not None, image.geterror()
    return pixels, {attribute.name: attribute.value for attribute in image.spec().extra_attribs}


def spec_of(path: Path | str) -> oiio.ImageSpec:
    return oiio.ImageBuf(str(path)).spec()


def json_attribute(attributes: dict, name: str):
    """One of the tool's attributes, which hold JSON."""
    return json.loads(attributes[f"nacre:{name}"])


def write_as(path: Path | str, pixels, data_format=oiio.FLOAT, **attributes) -> None:
    """An image as somebody else's program writes it."""
    pixels = np.asarray(pixels, dtype=np.float32)
    height, width, channels = pixels.shape
    image_spec = oiio.ImageSpec(width, height, channels, data_format)
    for name, value in attributes.items():
        image_spec.attribute(name, value)
    buffer = oiio.ImageBuf(image_spec)
    assert buffer.set_pixels(oiio.ROI(), pixels)
    assert buffer.write(str(path), data_format), buffer.geterror()
