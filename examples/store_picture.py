# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Puts an example's picture beside its scene, as the README shows it: `./dev demo --pictures`.

usage: store_picture.py FOLDER EXAMPLE

The example has one picture in FOLDER, and a plot at most.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path

from PIL import Image

LARGEST_BYTES = 150_000  # of what every clone of the repository takes along
QUALITIES = range(92, 69, -2)


def as_jpeg(picture: Image.Image) -> bytes:
    """The best that is small enough."""
    for quality in QUALITIES:
        data = io.BytesIO()
        picture.save(data, "JPEG", quality=quality, optimize=True, progressive=True)
        if data.tell() <= LARGEST_BYTES:
            return data.getvalue()
    sys.exit(f"no picture below {LARGEST_BYTES} bytes: is it free of noise?")


def main() -> None:
    folder, example = Path(sys.argv[1]), sys.argv[2]
    (source,) = folder.glob(f"{example}*.png")
    target = Path(__file__).parent / example / "picture.jpg"
    target.write_bytes(as_jpeg(Image.open(source).convert("RGB")))
    plot = folder / f"{example}.svg"
    if plot.exists():
        target.with_name("plot.svg").write_bytes(plot.read_bytes())


main()
