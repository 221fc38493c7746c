# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Makes the pictures of the asset browser from a gallery: 256 x 256, JPEG.

usage: make_thumbnails.py GALLERY -o addon/thumbnails

GALLERY is what `nacre render --gallery --size 256x256` wrote, of all materials or, where
NACRE_MATERIALS has those alone, of some.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from PIL import Image

SIZE = (256, 256)


_OSL = Path(__file__).resolve().parents[2] / "osl"


def materials() -> set[str]:
    """Ids of the templates, and of the shaders that say where they are listed."""
    shaders = (
        path.stem.removeprefix("nacre_")
        for path in (_OSL / "shaders").rglob("*.osl")
        if "string category = " in path.read_text("utf-8")
    )
    return {path.stem for path in (_OSL / "templates").glob("*.toml")} | set(shaders)


def _is_swatch(path: Path) -> bool:
    return path.stem.endswith("_swatch")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gallery", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    for path in sorted(options.gallery.glob("*.png")):
        if _is_swatch(path):
            continue
        picture = Image.open(path).convert("RGB")
        if picture.size != SIZE:
            raise SystemExit(f"{path.name}: must be {SIZE[0]} x {SIZE[1]} (got {picture.size})")
        picture.save(options.output / f"{path.stem}.jpg", quality=82, optimize=True)
    pictured = {path.stem for path in options.output.glob("*.jpg")}
    if missing := materials() - pictured:
        raise SystemExit(f"{options.gallery}: has no picture of {', '.join(sorted(missing))}")


if __name__ == "__main__":
    main()
