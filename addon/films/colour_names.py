# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a film's colours are called, and where along its thickness they are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby

Colour = Sequence[float]  # linear Rec.709

# Hues of OKLCH in degrees, upper ends, with the word for a light and for a dark colour of that hue.
# Between straw and gold, brown and orange the lightness and the chroma decide: see `name`.
_HUES = (
    (12.0, "pink", "magenta"),
    (33.0, "salmon", "red"),
    (62.0, "orange", "brown"),
    (100.0, "straw", "brown"),
    (118.0, "yellow", "olive"),
    (160.0, "green", "green"),
    (200.0, "turquoise", "teal"),
    (235.0, "light blue", "blue"),
    (283.0, "blue", "blue"),
    (318.0, "violet", "purple"),
    (345.0, "magenta", "purple"),
    (360.0, "pink", "purple"),
)
_GREY_CHROMA = 0.028
_NEUTRAL = ("black", "grey", "silver")
_MANY = 26  # runs; those of two orders are fewer
_DARK, _LIGHT, _BLACK = 0.52, 0.57, 0.2  # lightnesses


def name(colour: Colour) -> str:
    """An everyday word; colours out of gamut are held to it."""
    lightness, chroma, hue = _oklch([max(channel, 0.0) for channel in colour])
    if lightness < _BLACK:
        return "black"
    if chroma < _GREY_CHROMA:
        return "silver" if lightness > 0.75 else "grey"
    light, dark = next((light, dark) for end, light, dark in _HUES if hue <= end)
    if light == "straw" and lightness > _DARK and chroma > 0.11:
        return "gold"
    if light == "blue" and lightness > _LIGHT:
        return "light blue"
    return dark if lightness < _DARK else light


def along(values: Sequence[float], colours: Sequence[Colour], most: int = 5) -> str:
    """`straw at 21, purple at 41, blue at 56`: the first colours in the order of the values, each where
    it is in the middle of its run. Greys are passed over where there are hues, and short runs unless
    the range holds several orders, of which the first are the strongest."""
    words = [name(colour) for colour in brightened(colours)]
    chosen = _runs(words, values, 1)
    if len(chosen) < _MANY:
        chosen = _runs(words, values, len(words) // 28)
    return ", ".join(f"{word} at {_rounded(value)}" for word, value in chosen[:most])


def _runs(words: Sequence[str], values: Sequence[float], shortest: int) -> list[tuple[str, float]]:
    places = [list(run) for _, run in groupby(range(len(words)), lambda index: words[index])]
    middles = [run[len(run) // 2] for run in places if len(run) >= shortest]
    hues = [index for index in middles if words[index] not in _NEUTRAL]
    shown = hues if len(hues) > 1 else middles
    ahead = [None, *shown]
    return [
        (words[index], values[index])
        for before, index in zip(ahead, shown, strict=False)
        if before is None or words[before] != words[index]
    ]


def brightened(colours: Sequence[Colour]) -> list[list[float]]:
    """Of a clear film, which reflects little: as an eye sees it that has grown used to that."""
    brightest = max((_luminance(colour) for colour in colours), default=0.0)
    gain = 0.35 / brightest if 0.0 < brightest < 0.1 else 1.0
    return [[gain * channel for channel in colour] for colour in colours]


def _rounded(value: float) -> str:
    """To two digits, which is as exact as a name of a colour can be."""
    if value <= 0.0:
        return "0"
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return f"{round(value / step) * step:g}"


def _luminance(colour: Colour) -> float:
    return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]


def _oklch(colour: Colour) -> tuple[float, float, float]:
    """OKLab by B. Ottosson, "A perceptual color space for image processing" (2020), as lightness,
    chroma and hue in degrees."""
    r, g, b = colour
    long = math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b)
    middle = math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b)
    short = math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b)
    lightness = 0.2104542553 * long + 0.7936177850 * middle - 0.0040720468 * short
    a = 1.9779984951 * long - 2.4285922050 * middle + 0.4505937099 * short
    b = 0.0259040371 * long + 0.7827717662 * middle - 0.8086757660 * short
    return lightness, math.hypot(a, b), math.degrees(math.atan2(b, a)) % 360.0
