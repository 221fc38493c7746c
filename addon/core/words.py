# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What finds a material: its name, category and tags, and words that stand for those, which words.toml has."""

from __future__ import annotations

import tomllib
from functools import cache, lru_cache
from pathlib import Path

from .library import Entry


@cache
def vocabulary() -> dict[str, tuple[str, ...]]:
    """What each word stands for."""
    text = Path(__file__).with_suffix(".toml").read_text("utf-8")
    return {word: tuple(targets) for word, targets in tomllib.loads(text).items()}


@lru_cache(maxsize=256)
def synonyms(entry: Entry) -> tuple[str, ...]:
    """Further words for a material, none of which is a tag of its own."""
    parts = {part.strip().lower() for part in entry.category.split("/")}
    tags = {tag.lower() for tag in entry.tags}
    known = {entry.id, entry.kind} | tags | parts | {part.removesuffix("s") for part in parts}
    return tuple(
        word for word, targets in vocabulary().items() if known & set(targets) and word not in tags
    )


def finds(entry: Entry, query: str) -> bool:
    """Whether each word of a query begins a word of the material's, without regard to case."""
    texts = (entry.name, entry.category, *entry.tags, *synonyms(entry))
    words = " ".join(texts).lower().replace("/", " ").replace(",", " ").replace("-", " ").split()
    asked = query.lower().replace("-", " ").replace(",", " ").split()
    return all(any(word.startswith(part) for word in words) for part in asked)
