# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems of a template in the words of the panel that shows its stack."""

from __future__ import annotations

import re

# `name:12: layer[1].medium: must be … (got 'x')`; name and line are left out where nothing is known of them.
_PROBLEM = re.compile(
    r"^(?:.*?:)??(?:\d+: )?"
    r"(?P<place>layer\[(?P<index>\d+)\]|ambient|substrate)(?:\.(?P<field>[\w.]+))?: (?P<text>.+)$"
)
_UNKNOWN = re.compile(
    r"^must be a key of the library(?:, perhaps (?P<near>.*))? \(got '(?P<key>.*)'\)$"
)
_FIELDS = {"medium": "", "thickness_nm": "thickness", "n": "index", "k": "absorption"}
_PLACES = {"ambient": "Above", "substrate": "Below"}


def spoken(problem: str) -> list[str]:
    """One for each line of a problem. Layers are counted from 1, as the panel does."""
    return [_spoken(line) for line in problem.splitlines() if line.strip()]


def _spoken(line: str) -> str:
    found = _PROBLEM.match(line)
    if not found:
        return line
    index = found["index"]
    place = f"Layer {int(index) + 1}" if index is not None else _PLACES[found["place"]]
    unknown = _UNKNOWN.match(found["text"])
    if unknown:
        near = f" {unknown['near']}," if unknown["near"] else ""
        return (
            f"{place}: '{unknown['key']}' is not in the library. Try{near} a name (copper), "
            "an index (1.5) or a formula (cauchy 1.45 0.0035)."
        )
    field = (found["field"] or "").partition(".")[0]
    field = _FIELDS.get(field, field)
    return f"{place}{', ' * bool(field)}{field}: {found['text']}"
