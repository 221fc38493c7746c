# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Makes the pictures of the asset browser from a gallery: 256 x 256, JPEG.

usage: make_thumbnails.py GALLERY -o addon/thumbnails

GALLERY is what `nacre render --gallery --size 256x256` wrote.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from PIL import Image

SIZE = (256, 256)


def _is_swatch(path: Path) -> bool:
    return path.stem.endswith("_swatch")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gallery", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    wanted = {path.stem for path in options.gallery.glob("*.png") if not _is_swatch(path)}
    templates = Path(__file__).resolve().parents[2] / "osl" / "templates"
    missing = {path.stem for path in templates.glob("*.toml")} - wanted
    if missing:
        raise SystemExit(f"{options.gallery}: has no picture of {', '.join(sorted(missing))}")
    for old in options.output.glob("*.jpg"):
        if old.stem not in wanted:
            old.unlink()
    for name in sorted(wanted):
        picture = Image.open(options.gallery / f"{name}.png").convert("RGB")
        if picture.size != SIZE:
            raise SystemExit(f"{name}.png: must be {SIZE[0]} x {SIZE[1]} (got {picture.size})")
        picture.save(options.output / f"{name}.jpg", quality=82, optimize=True)


if __name__ == "__main__":
    main()
