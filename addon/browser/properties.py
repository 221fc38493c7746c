# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is searched and chosen in the side bar."""

from __future__ import annotations

import time

from bpy.props import EnumProperty, IntProperty, StringProperty

from ..blender.parts import Extended
from ..core.library import Library
from ..core.looks import variants
from ..core.words import finds
from ..materials.preferences import keep
from ..materials.properties import NACRE_PG_session
from . import thumbnails

# Blender keeps no reference to the texts of a computed list of items, and asks for it several times at
# each redraw, where a look at the library's files each time would be felt.
_found: list[tuple[str, str, str, int, int]] = []
_found_for: list[object] = [None, ""]  # the entries and the search
_looked_at = [0.0]
_SHOWN_FIRST = "tempered_steel"  # as long as nothing was chosen
_LOOK_AGAIN = 0.5  # seconds


def _choices(self, _context):
    """What the search finds, each with the number that it has among all."""
    now = time.monotonic()
    if _found_for[1] == self.search and now < _looked_at[0] + _LOOK_AGAIN:
        return _found
    _looked_at[0] = now
    entries = Library.default().entries()
    if _found_for[0] is not entries or _found_for[1] != self.search:
        _found_for[:] = entries, self.search
        _found[:] = [
            (item.key, item.label, item.entry.description, thumbnails.icon(item.key), number)
            for number, item in enumerate(variants(entries).values())
            if finds(item.entry, self.search)
        ]
    return _found


def _choice(self) -> int:
    """The one that was chosen, or the first that is found while that is not among them. Read without a
    value of its own: Blender warns of one that is not offered."""
    numbers = [item[4] for item in _choices(self, None)]
    if self.number in numbers or not numbers:
        return self.number
    first = [item[4] for item in _found if item[0] == _SHOWN_FIRST]
    return (first or numbers)[0]


def _choose(self, number: int) -> None:
    self.number = number


def _on_search(self, _context) -> None:
    if finds_any(self):
        self.number = _choice(self)


def finds_any(browser: NACRE_PG_session) -> bool:
    return bool(_choices(browser, None))


_CHOSEN = {
    "recent": StringProperty(name="Recent", description="Assigned last, the last one first"),
    "favourites": StringProperty(name="Favourites", description="In the order in which they came"),
}
keep(**_CHOSEN)

PARTS = (
    Extended(
        NACRE_PG_session,
        search=StringProperty(
            name="Search",
            description="A look, a thing or a material: iridescent, burnt, beetle, CD, gasoline …",
            options={"TEXTEDIT_UPDATE"},
            update=_on_search,
        ),
        number=IntProperty(
            name="Number", description="Of the material that was chosen, among all", default=-1
        ),
        choice=EnumProperty(
            name="Material",
            description="Which material",
            items=_choices,
            get=_choice,
            set=_choose,
        ),
        **_CHOSEN,  # where there are no preferences; see chosen.py
    ),
)
