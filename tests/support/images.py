# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Pictures as arrays, by OpenImageIO's own module."""

from __future__ import annotations

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


def write_image(file: Path, pixels: np.ndarray, kind: str = "half") -> None:
    """Scene-linear RGB as EXR."""
    height, width, channels = pixels.shape
    file.parent.mkdir(parents=True, exist_ok=True)
    target = oiio.ImageOutput.create(str(file))
    spec = oiio.ImageSpec(width, height, channels, kind)
    spec.attribute("compression", "zip")
    assert target.open(str(file), spec), target.geterror()
    assert target.write_image(pixels.astype(np.float32)), target.geterror()
    target.close()
