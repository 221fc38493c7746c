# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Makes the manual that the extension carries from the pages of cpp_tools/doc: HTML that needs no net.

usage: write_manual.py -o FOLDER
"""

from __future__ import annotations

import argparse
import re
import shutil
import sys
from itertools import pairwise
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "cpp_tools" / "doc"
FIRST = "blender"

_PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{title} – Nacre</title>
<style>
body {{ font: 16px/1.5 system-ui, sans-serif; margin: 0; background: #17181a; color: #d8d9db }}
nav {{ background: #212327; padding: .6rem 1rem }}
nav a {{ margin-right: 1rem; white-space: nowrap }}
main {{ max-width: 860px; margin: 0 auto; padding: 1rem }}
h1, h2, h3 {{ font-weight: 600; color: #f0f0f0; line-height: 1.25 }} h2 {{ margin-top: 2.2rem }}
a {{ color: #8ab8ff }} img {{ max-width: 100%; border-radius: 6px }}
pre {{ background: #0f1011; padding: .8rem; overflow-x: auto; border-radius: 6px }}
code {{ font-size: .88em }}
table {{ border-collapse: collapse; display: block; overflow-x: auto }}
td, th {{ border-bottom: 1px solid #35383d; padding: .35rem .6rem; text-align: left; vertical-align: top }}
</style>
<nav>{links}</nav>
<main>
{body}
</main>
</html>
"""


def write_manual(folder: Path) -> None:
    """Every page of the documentation, and the pictures that they show."""
    folder.mkdir(parents=True, exist_ok=True)
    sources = sorted(PAGES.glob("*.md"), key=lambda path: (path.stem != FIRST, path.stem))
    titles = {path.stem: _title(path.read_text("utf-8"), path) for path in sources}
    links = "".join(f'<a href="{stem}.html">{title}</a>' for stem, title in titles.items())
    for path in sources:
        body = _body(path, folder)
        page = _PAGE.format(title=titles[path.stem], links=links, body=body)
        (folder / f"{path.stem}.html").write_text(page, "utf-8")


def _title(text: str, path: Path) -> str:
    match = re.match(r"# (.+)", text)
    if not match:
        sys.exit(f"{path}:1: must begin with a title")
    return match.group(1)


def _body(path: Path, folder: Path) -> str:
    reader = MarkdownIt("commonmark").enable("table")
    tokens = reader.parse(path.read_text("utf-8"))
    for opening, content in pairwise(tokens):
        if opening.type == "heading_open":
            opening.attrSet("id", _anchor(content.content))
    for token in _with_children(tokens):
        if token.type == "link_open":
            token.attrSet("href", _page_link(str(token.attrGet("href"))))
        elif token.type == "image":
            token.attrSet("src", _copied(path, str(token.attrGet("src")), folder))
    return reader.renderer.render(tokens, reader.options, {})


def _with_children(tokens: list[Token]):
    for token in tokens:
        yield token
        yield from token.children or ()


def _anchor(heading: str) -> str:
    """As GitHub has it."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def _page_link(target: str) -> str:
    return re.sub(r"^([\w-]+)\.md(?=#|$)", r"\1.html", target)


def _copied(page: Path, picture: str, folder: Path) -> str:
    """Its new place, flat beside the pages."""
    source = (page.parent / picture).resolve()
    if not source.is_file():
        sys.exit(f"{page}: has no picture {picture}")
    name = "-".join(source.relative_to(ROOT).parts[-2:])
    shutil.copyfile(source, folder / name)
    return name


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, required=True)
    write_manual(parser.parse_args().output)


if __name__ == "__main__":
    main()
