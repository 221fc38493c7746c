# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Writes index.html over the pictures of a folder.

usage: contact_sheet.py FOLDER
"""

from __future__ import annotations

import html
import sys
from pathlib import Path

PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>Nacre</title>
<style>
  body {{ background: #16171a; color: #ddd; font: 15px/1.5 sans-serif; margin: 2rem; }}
  main {{ display: grid; gap: 1.5rem;
          grid-template-columns: repeat(auto-fill, minmax(26rem, 1fr)); }}
  figure {{ margin: 0; }}
  img {{ width: 100%; border-radius: 4px; }}
  a {{ color: #9bd; }}
</style>
<h1>Nacre</h1>
<main>
{figures}
</main>
</html>
"""

FIGURE = """<figure><img src="{name}.png" alt="{caption}">
<figcaption>{caption} <a href="{name}.exr">EXR</a></figcaption></figure>"""


def caption(name: str) -> str:
    """The first paragraph of the README of the example that made the picture, below its title."""
    examples = Path(__file__).parent
    folder = max(
        (f for f in examples.iterdir() if name.startswith(f.name)), key=lambda f: len(f.name)
    )
    text = (folder / "README.md").read_text(encoding="utf-8").split("\n\n")[1]
    return " ".join(text.split())


def main() -> None:
    folder = Path(sys.argv[1])
    names = sorted(path.stem for path in folder.glob("*.png"))
    figures = [FIGURE.format(name=name, caption=html.escape(caption(name))) for name in names]
    page = PAGE.format(figures="\n".join(figures))
    (folder / "index.html").write_text(page, encoding="utf-8")


main()
