# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which of the library's media is meant by what someone types."""

from __future__ import annotations

from collections.abc import Callable, Iterable


def meant(text: str, media: Iterable[tuple[str, str]]) -> str:
    """`media`: keys and names, such as `Cu/Johnson` and `Copper`. The first key that is the text, or whose
    name is, or that is of the substance: names go on after a comma, keys after a stroke. Else the only one
    with the text as a word in its name, or the text itself."""
    media = list(media)
    typed = text.casefold().strip()
    if not typed:
        return text
    rules: tuple[Callable[[str, str], bool], ...] = (
        lambda key, _: key.casefold() == typed,
        lambda _, name: name.casefold() == typed,
        lambda _, name: name.casefold().partition(",")[0] == typed,
        lambda key, _: key.casefold().partition("/")[0] == typed,
    )
    for fits in rules:
        found = next((key for key, name in media if fits(key, name)), None)
        if found is not None:
            return found
    only = [key for key, name in media if typed in name.casefold().replace(",", " ").split()]
    return only[0] if len(only) == 1 else text
