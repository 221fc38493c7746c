# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources of a thickness that varies over a surface: what there is, its sockets, and their values as
text: `drop:base_nm=100,height_nm=300`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ..core.faults import ForeseenError


@dataclass(frozen=True)
class Input:
    """A socket of a source. Thicknesses are shares of the material's range until they are set up.

    `share` is where in the range from the least to the largest thickness the default lies; `value`
    is the default of everything else. What is `added` to a thickness may be 0 and the whole range.
    A thickness that `follows` starts as the one that the material had. What is `fine` is seldom
    changed, and folded away.
    """

    name: str
    description: str
    share: float | None = None
    value: float | bool | tuple[float, float, float] = 0.0
    minimum: float = 0.0
    maximum: float = 1e6
    unit: str = ""
    added: bool = False
    follows: bool = False
    fine: bool = False

    @property
    def is_thickness(self) -> bool:
        return self.share is not None

    @property
    def is_switch(self) -> bool:
        return isinstance(self.value, bool)

    @property
    def is_given(self) -> bool:
        """Whether a user has a value for it, and not a link."""
        return self.name not in ("Vector", BELOW, "Value") and not self.is_switch

    def option(self, thickness_unit: str) -> str:
        """Its name in text, such as `base_nm`."""
        unit = thickness_unit if self.is_thickness else self.unit
        return "_".join(filter(None, (*self.name.lower().split(), unit)))


BELOW, STRENGTH, ON = "Thickness", "Strength", "On"
"""Inputs that every source has: what lies below it in the stack, how much of it is seen, and whether."""

UPON = "Grows Upon Below"
"""Switch of heat that lies upon other heat: the oxide that is there grows on."""

_BELOW = Input(BELOW, "What lies below this source", share=0.4, follows=True)
_ALWAYS = (
    Input(STRENGTH, "0: only what lies below, 1: only this source", value=1.0, maximum=1.0),
    Input(ON, "Whether this source is seen at all", value=True),
)


@dataclass(frozen=True)
class Source:
    """One layer of a stack of sources. `coordinates` says what feeds `Vector`: an output of Texture
    Coordinate, POSITION (in the scene), POINT (an object's own space) or CURVE (see heat.py)."""

    id: str
    name: str
    description: str
    own: tuple[Input, ...]
    coordinates: str | None = None
    below: str = BELOW
    group: str = ""  # heading in menus; the one before where there is none

    @property
    def inputs(self) -> tuple[Input, ...]:
        """In the order of the sockets."""
        ahead = () if self.below in (item.name for item in self.own) else (_BELOW,)
        return (*ahead, *self.own, *_ALWAYS)

    @property
    def changes_what_is_below(self) -> bool:
        """Whether it is nothing by itself."""
        return self.below != BELOW or not any(
            item.is_thickness and not item.added for item in self.own
        )

    @property
    def is_heat(self) -> bool:
        return any(item.name == UPON for item in self.own)

    @property
    def stands_alone(self) -> bool:
        """Whether it needs neither a picture, nor an attribute, nor an object."""
        fed = any(item.name == "Value" for item in self.own)
        return not fed and self.coordinates not in (POINT, CURVE)


POSITION, POINT, CURVE = "Position", "Point", "Curve"

_VECTOR = Input("Vector", "Where on the surface", value=(0.0, 0.0, 0.0))
_LEAST = Input("Minimum", "Thickness where the value is 0", share=0.0)
_LARGEST = Input("Maximum", "Thickness where the value is 1", share=1.0)
_BETWEEN = (Input("Value", "0: minimum, 1: maximum", value=0.5, maximum=1.0), _LEAST, _LARGEST)
_NEAR = Input("Near", "Thickness at the start", share=0.0)
_FAR = Input("Far", "Thickness at the end", share=1.0)


def _start(x: float) -> Input:
    return Input(
        "Start", "Where it starts, in the object's box: 0 to 1", value=(x, 0.5, 0.5), fine=True
    )


def _axes(values: tuple[float, float, float]) -> Input:
    return Input("Axes", "How much each axis counts; 0 leaves it out", value=values, fine=True)


ZERO_CELSIUS = 273.15  # in K

# Oxide grows as √t, and the faster the hotter it is: d = d₀ exp(-B/T). A fit of B to the temperatures
# of the workshop's colours (galvanotechnik-for-you.de, Anlauffarben: 220 °C pale yellow to 293 °C blue)
# and the thicknesses of magnetite that have these colours (10 to 48 nm) is within 3 nm of all.
GROWTH_KELVIN = 5800.0


def _growth(reach: float) -> tuple[Input, ...]:
    return (
        Input("Hottest", "Temperature at the source, in °C", value=330.0, maximum=3000.0, unit="c"),
        Input("Coldest", "Temperature far from it, in °C", value=20.0, maximum=3000.0, unit="c"),
        Input("Reach", "Distance over which the heat falls to a third", value=reach, minimum=1e-4),
        Input(
            "Grown",
            "Thickness that grows at the next temperature",
            share=0.5,
            follows=True,
            fine=True,
        ),
        Input(
            "At",
            "Temperature at which that thickness grows, in °C",
            value=280.0,
            unit="c",
            fine=True,
        ),
        Input(
            "Growth",
            "How steeply the oxide grows with temperature, in K; 5800 fits the colours of carbon steel",
            value=GROWTH_KELVIN,
            minimum=1.0,
            unit="k",
            fine=True,
        ),
        Input(UPON, "Lets the oxide below grow on, instead of lying on it", value=False),
    )


SOURCES = (
    Source(
        "map",
        "Image",
        "A picture or any other texture from 0 to 1, as a thickness from minimum to maximum",
        _BETWEEN,
        "UV",
        group="Painted",
    ),
    Source(
        "attribute",
        "Paint",
        "Brushed onto the object, or any attribute from 0 to 1, through a ramp",
        _BETWEEN,
    ),
    Source(
        "noise",
        "Noise",
        "Clouds from minimum to maximum",
        (
            _LEAST,
            _LARGEST,
            Input("Scale", "Clouds per unit of length", value=2.0),
            Input("Detail", "Octaves of finer clouds", value=3.0, maximum=15.0),
            _VECTOR,
        ),
        "Object",
        group="Patterns",
    ),
    Source(
        "gradient",
        "Gradient over the Object",
        "From one end of the object to the other",
        (
            _NEAR,
            _FAR,
            _start(0.0),
            _axes((1.0, 0.0, 0.0)),
            Input("Reach", "How far it goes; 1 is the whole object", value=1.0, minimum=1e-4),
            _VECTOR,
        ),
        "Generated",
    ),
    Source(
        "height",
        "Gradient by Height",
        "From a height in the scene to another",
        (
            Input("Near", "Thickness at the bottom", share=0.0),
            Input("Far", "Thickness at the top", share=1.0),
            Input("Bottom", "Height where it starts", value=-1.0, minimum=-1e6, unit="m"),
            Input("Top", "Height where it ends", value=1.0, minimum=-1e6, unit="m"),
            _VECTOR,
        ),
        POSITION,
    ),
    Source(
        "distance",
        "Gradient from a Point",
        "Outwards from an empty that can be moved",
        (
            _NEAR,
            _FAR,
            Input("Reach", "How far it goes, in sizes of the empty", value=1.0, minimum=1e-4),
            _VECTOR,
        ),
        POINT,
    ),
    Source(
        "edge",
        "Edge Wear",
        "Another thickness where the object has edges",
        (
            Input("Faces", "Thickness away from edges", share=0.6),
            Input("Edges", "Thickness on edges", share=0.1),
            Input("Width", "How far from an edge it is worn", value=0.2, minimum=1e-4, unit="m"),
        ),
    ),
    Source(
        "temperature",
        "Heat over the Object",
        "Temper colours of an object that was heated at one end",
        # The end that the default camera sees.
        (*_growth(0.8), _start(1.0), _axes((1.0, 0.15, 0.15)), _VECTOR),
        "Generated",
        group="Heat",
    ),
    Source(
        "heat_point",
        "Heat from a Point",
        "Temper colours around an empty that can be moved, as around a torch",
        # At the empty's ring the steel has its first colour.
        (*_growth(2.2), _VECTOR),
        POINT,
    ),
    Source(
        "heat_curve",
        "Heat along a Curve",
        "Temper colours along a curve, as beside a weld",
        (*_growth(0.8), _VECTOR),
        CURVE,
    ),
    Source(
        "drop",
        "Drop",
        "A round drop: highest in the middle, a parabola to its rim",
        (
            Input("Base", "Thickness outside the drop", share=0.0),
            Input("Height", "What the middle adds to the base", share=0.8, added=True),
            Input("Centre", "Middle of the drop", value=(0.5, 0.5, 0.0)),
            Input("Radius", "From the middle to the rim", value=0.5, minimum=1e-4),
            _VECTOR,
        ),
        "UV",
        below="Base",
        group="Liquid Films",
    ),
    Source(
        "drainage",
        "Drainage",
        "A film that runs down: black at the top, thicker below as the square root of the depth",
        (
            Input("Bottom", "Thickness at the lower end when Time is 1", share=0.6),
            Input("Time", "The film thins as 1/√time", value=1.0, minimum=1e-3),
            Input("Black Film", "Share of the height that is black film", value=0.06, maximum=1.0),
            Input("Black Thickness", "Thickness of the black film", share=0.0),
            _VECTOR,
        ),
        "Generated",
    ),
    Source(
        "swirl",
        "Swirl",
        "Eddies that carry what lies below along; drive Time",
        (
            Input("Amount", "Share of the thickness by which it is changed", value=0.35),
            Input("Scale", "Eddies per unit of length", value=2.0),
            Input("Flow", "How far the eddies carry", value=1.0),
            Input(
                "Time",
                "In seconds; the same time gives the same picture",
                value=0.0,
                minimum=-1e6,
                unit="s",
            ),
            _VECTOR,
        ),
        "Object",
    ),
    Source(
        "spread",
        "Spread",
        "Unevenness too fine to be seen: each sample draws a thickness, so that fringes fade as they "
        "do where the thickness varies within a pixel",
        (Input("Spread", "Standard deviation of the thickness", share=0.02, added=True),),
        group="Others",
    ),
    Source(
        "attribute_nm",
        "Attribute in Units of Thickness",
        "An attribute that holds the thickness itself, as from geometry nodes",
        (Input("Value", "Thickness", share=0.5),),
    ),
)


def source(source_id: str) -> Source:
    return next(item for item in SOURCES if item.id == source_id)


class ThicknessError(ForeseenError):
    """A source or its values do not fit; one line for each fault."""


@dataclass(frozen=True)
class Varied:
    """A source with values, as it is asked for: `SOURCE[:NAME=VALUE,…]`."""

    source: Source
    values: tuple[str, ...] = ()


def read_varied(text: str) -> Varied:
    source_id, colon, values = text.partition(":")
    known = {item.id: item for item in SOURCES if item.stands_alone}
    if source_id not in known:
        raise ThicknessError(f"no source {source_id!r}; there are: {', '.join(known)}")
    return Varied(known[source_id], tuple(values.split(",")) if colon else ())


Value = float | tuple[float, ...]


def socket_values(varied: Varied, socket: str, span: tuple[float, float]) -> dict[str, Value]:
    """By input; thicknesses in the unit of the material's socket, and within the span of its tables."""
    unit = socket.removeprefix("thickness_")
    inputs = {item.option(unit): item for item in varied.source.inputs if item.is_given}
    found: dict[str, Value] = {}
    problems = []
    for text in varied.values:
        name, equals, value = text.partition("=")
        if not equals or name not in inputs:
            said = f"no value {name!r}" if equals else f"must be NAME=VALUE (got {text!r})"
            problems.append(f"{said}; there are: {', '.join(inputs)}")
            continue
        item = inputs[name]
        try:
            found[item.name] = _value(item, value, span)
        except ValueError as error:
            problems.append(f"{name}: {error} (got {value})")
    if not problems:
        problems += _above(varied.source, found, unit, span)
    if problems:
        raise ThicknessError("\n".join(f"{varied.source.id}: {text}" for text in problems))
    return found


def default_thickness(item: Input, span: tuple[float, float]) -> float:
    low, high = span
    return (0.0 if item.added else low) + (item.share or 0.0) * (high - low)


def _value(item: Input, text: str, span: tuple[float, float]) -> Value:
    words = text.split(":")
    count = len(item.value) if isinstance(item.value, tuple) else 1
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        numbers = []
    # A point may have two numbers: it lies on the surface.
    if (
        not numbers
        or not count - 1 <= len(numbers) <= count
        or not all(map(math.isfinite, numbers))
    ):
        raise ValueError("must be X:Y or X:Y:Z" if count > 1 else "must be a number")
    if count > 1:
        return (*numbers, *[0.0] * (count - len(numbers)))
    low, high = item.minimum, item.maximum
    if item.is_thickness:
        low, high = (0.0, span[1] - span[0]) if item.added else span
    if not low <= numbers[0] <= high:
        raise ValueError(f"must be in [{low:g}, {high:g}]")
    return numbers[0]


def _above(
    source: Source, given: dict[str, Value], unit: str, span: tuple[float, float]
) -> Sequence[str]:
    """What a drop piles up beyond the tables, which hold their edge there."""
    if source.id != "drop" or not given:
        return []
    base, height = (given.get(item.name, default_thickness(item, span)) for item in source.own[:2])
    if base + height <= span[1]:
        return []
    names = " + ".join(item.option(unit) for item in source.own[:2])
    return [f"{names}: must be ≤ {span[1]:g}, which the tables cover (got {base:g} + {height:g})"]
