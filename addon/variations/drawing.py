# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variations of a look: other values for what an artist may turn, always the same for the same seed."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

State = dict[str, float]
"""Values by the names of knobs."""

NEAR = 0.12
"""How far More Like This goes, as a share of each value; and not further than _MOST of the range."""
_MOST = 0.15


@dataclass(frozen=True)
class Knob:
    """One number. `usual`: what Randomise draws from; None: it leaves the value alone.

    `ladder` has values at even steps of the colour, which are drawn evenly instead. `step` is how far
    More Like This goes where a share of the value says nothing, as with a time.
    """

    name: str
    value: float
    low: float
    high: float
    usual: tuple[float, float] | None = None
    is_log: bool = False
    ladder: tuple[float, ...] = ()
    step: float | None = None
    not_below: str = ""  # the knob that this one stays above, as a maximum does its minimum
    piled_on: str = ""  # the knob with which it makes a sum that has to stay below `high`


def state_of(knobs: Sequence[Knob]) -> State:
    return {knob.name: knob.value for knob in knobs}


def randomised(knobs: Sequence[Knob], seed: int) -> State:
    """Anything that the material can be. Seeds that follow one another give values far apart."""
    values = [
        knob.value if knob.usual is None else _drawn(knob, place)
        for knob, place in zip(knobs, _places(len(knobs), seed), strict=True)
    ]
    return _settled(knobs, values)


def like(knobs: Sequence[Knob], seed: int) -> State:
    """The same character: each value a little up or down; what is 0 stays 0."""
    values = [
        _near(knob, place) for knob, place in zip(knobs, _places(len(knobs), seed), strict=True)
    ]
    return _settled(knobs, values)


def _drawn(knob: Knob, place: float) -> float:
    if knob.ladder:
        at = place * (len(knob.ladder) - 1)
        below = min(int(at), len(knob.ladder) - 2)
        return _mix(knob.ladder[below], knob.ladder[below + 1], at - below)
    low, high = knob.usual
    if knob.is_log:
        return low * (high / low) ** place
    return _mix(low, high, place)


def _near(knob: Knob, place: float) -> float:
    """Mirrored at an end of the range, so that a value that lies there moves, too."""
    away = (2.0 * place - 1.0) * _reach(knob)
    is_inside = knob.low <= knob.value + away <= knob.high
    return knob.value + (away if is_inside else -away)


def _reach(knob: Knob) -> float:
    if knob.step is not None:
        return knob.step
    return min(NEAR * abs(knob.value), _MOST * (knob.high - knob.low))


def _places(count: int, seed: int) -> list[float]:
    """From 0 to 1, one for each knob: a sequence of low discrepancy with the powers of the generalised
    golden ratio as its steps (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018)."""
    ratio = 2.0
    for _ in range(32):  # x^(count + 1) = x + 1
        ratio = (1.0 + ratio) ** (1.0 / (count + 1))
    return [math.fmod(0.5 + seed * ratio ** -(index + 1), 1.0) for index in range(count)]


def _settled(knobs: Sequence[Knob], values: Sequence[float]) -> State:
    """Within the limits of each and of all together."""
    state = {
        knob.name: min(max(value, knob.low), knob.high)
        for knob, value in zip(knobs, values, strict=True)
    }
    for knob in knobs:
        other = knob.not_below
        if other in state and state[other] > state[knob.name]:
            state[other], state[knob.name] = state[knob.name], state[other]
        if knob.piled_on in state:
            state[knob.name] = min(state[knob.name], knob.high - state[knob.piled_on])
    return state


def _mix(a: float, b: float, share: float) -> float:
    return a + (b - a) * share


def colour_ladder(
    values: Sequence[float], colours: Sequence[Sequence[float]], steps: int = 24
) -> tuple[float, ...]:
    """Values at even steps along the path of their colours, whichever these are: a film is black over
    much of its thinnest part and changes fast at the next."""
    travelled = [0.0]
    for before, after in pairwise(colours):
        travelled.append(travelled[-1] + math.dist(_shown(before), _shown(after)))
    if travelled[-1] <= 0.0:
        return ()
    ladder = []
    for step in range(steps):
        wanted = travelled[-1] * step / (steps - 1)
        below = min(bisect_right(travelled, wanted) - 1, len(values) - 2)
        length = travelled[below + 1] - travelled[below]
        share = (wanted - travelled[below]) / length if length else 0.0
        ladder.append(_mix(values[below], values[below + 1], min(share, 1.0)))
    return tuple(ladder)


def _shown(colour: Sequence[float]) -> list[float]:
    """Roughly as far apart as an eye sees them."""
    return [max(channel, 0.0) ** (1.0 / 2.4) for channel in colour]


def words(knobs: Sequence[Knob], state: Mapping[str, float]) -> str:
    """What differs from the present, such as `roughness 0.21`."""
    told = [
        f"{knob.name.rpartition('/')[2].replace('_', ' ').lower()} {state[knob.name]:.3g}"
        for knob in knobs
        if knob.name in state and not math.isclose(state[knob.name], knob.value, rel_tol=1e-3)
    ]
    return " · ".join(told)
