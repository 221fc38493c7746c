# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bands where somebody wants them, `400:700:10`, as sensors have them, instead of where the eye does."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

from .faults import ForeseenError
from .light import FIRST_NM, LAST_NM

MOST = 300
"""Of bands."""
_LEAST_NM = 0.5
"""Of a band: they are made of tenths of a nanometre."""


class WavelengthsError(ForeseenError):
    """What is wanted is not possible."""


@dataclass(frozen=True)
class Wavelengths:
    """In nm. wanted: in the middle of a band each; bands: with those beside them that cover the rest, as many
    as it takes for three a pass; edges: one more."""

    wanted: tuple[float, ...]
    bands: tuple[float, ...]
    edges: tuple[float, ...]


def parse(text: str) -> Wavelengths:
    """Raises WavelengthsError that says what is wrong with FIRST:LAST:STEP."""
    try:
        first, last, step = (float(part) for part in text.split(":"))
    except ValueError:
        raise WavelengthsError(
            f"must be FIRST:LAST:STEP in nm, as 400:700:10 (got {text!r})"
        ) from None
    if not (math.isfinite(first + last + step) and step >= _LEAST_NM and first <= last):
        raise WavelengthsError(
            f"must ascend by {_LEAST_NM:g} nm or more, FIRST:LAST:STEP (got {text!r})"
        )
    count = int((last - first) / step + 1e-9) + 1
    if count > MOST - 2:
        raise WavelengthsError(f"must be {MOST - 2} wavelengths at most (got {count})")
    wanted = tuple(first + step * number for number in range(count))
    start, end = first - step / 2, wanted[-1] + step / 2
    if start < FIRST_NM or end > LAST_NM:
        raise WavelengthsError(
            f"must have bands within {FIRST_NM} … {LAST_NM} nm (got {start:g} … {end:g})"
        )
    edges = [start + step * number for number in range(count + 1)]
    return Wavelengths(wanted, *_covering(list(wanted), edges))


def _covering(
    bands: list[float], edges: list[float]
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """All that there is, by a multiple of three: what is beside is cut into as many as that takes."""
    before, after = (int(gap >= _LEAST_NM) for gap in (edges[0] - FIRST_NM, LAST_NM - edges[-1]))
    missing = -(len(bands) + before + after) % 3
    if missing and not before and not after:
        raise WavelengthsError(
            f"cover all of {FIRST_NM} … {LAST_NM} nm: their number must be a multiple of three "
            f"(got {len(bands)})"
        )
    if after:
        after += missing
    elif before:
        before += missing
    lower, upper = _cut(FIRST_NM, edges[0], before), _cut(edges[-1], LAST_NM, after)
    all_edges = [*lower[:-1], *edges, *upper[1:]]
    all_edges[0], all_edges[-1] = float(FIRST_NM), float(LAST_NM)
    return (*_middles(lower), *bands, *_middles(upper)), tuple(all_edges)


def _cut(start: float, end: float, parts: int) -> list[float]:
    return (
        [start + (end - start) * number / parts for number in range(parts + 1)] if parts else [end]
    )


def _middles(edges: list[float]) -> list[float]:
    return [(a + b) / 2 for a, b in pairwise(edges)]
