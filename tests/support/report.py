# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The page that shows what failed: reference, new picture, 16 times their difference.

Each failure leaves a part of the page in a file of its own, since tests run in several processes.
"""

from __future__ import annotations

import html
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

PAGE = """<!doctype html>
<meta charset="utf-8"><title>Render tests</title>
<style>
body {{ font: 15px system-ui; background: #222; color: #ddd; margin: 2em }}
figure {{ display: inline-block; margin: 0 1em 1em 0 }} img {{ width: 320px; image-rendering: pixelated }}
code {{ background: #000; padding: .2em .5em }}
</style>
<h1>{count} failed comparisons</h1>
{rows}
"""


@dataclass(frozen=True)
class Report:
    folder: Path

    @property
    def parts(self) -> list[Path]:
        return sorted(self.folder.glob("*.part"))

    def clear(self) -> None:
        for part in self.parts:
            part.unlink()

    def add(
        self, name: str, keyword: str, new: np.ndarray, reference: np.ndarray, text: str
    ) -> None:
        """A failed case; `keyword` is what `./dev refs -k` takes."""
        self.folder.mkdir(parents=True, exist_ok=True)
        images = {
            "reference": reference,
            "new": new,
            "16 x difference": 16 * np.abs(new - reference),
        }
        figures = []
        for label, pixels in images.items():
            file = f"{name}-{label.replace(' ', '')}.png"
            Image.fromarray(display(pixels)).save(self.folder / file)
            figures.append(f'<figure><img src="{file}"><figcaption>{label}</figcaption></figure>')
        (self.folder / f"{name}.part").write_text(
            f"<h2>{html.escape(name)}</h2><p>{html.escape(text)}</p>{''.join(figures)}"
            f"<p>Reviewed and right? <code>./dev refs -k {html.escape(keyword)}</code></p>",
            "utf-8",
        )

    def write(self) -> None:
        page = self.folder / "index.html"
        rows = [part.read_text("utf-8") for part in self.parts]
        if rows:
            page.write_text(PAGE.format(count=len(rows), rows="\n".join(rows)), "utf-8")
        else:
            page.unlink(missing_ok=True)


def display(pixels: np.ndarray) -> np.ndarray:
    """8-bit sRGB of scene-linear values, clipped."""
    clipped = np.clip(pixels, 0.0, 1.0)
    curve = np.where(clipped <= 0.0031308, 12.92 * clipped, 1.055 * clipped ** (1 / 2.4) - 0.055)
    return np.round(255 * curve).astype(np.uint8)
