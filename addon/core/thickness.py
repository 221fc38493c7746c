# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources of a thickness that varies over a surface: what there is, and its sockets."""

from __future__ import annotations

from dataclasses import dataclass

SOCKETS = ("thickness_nm", "thickness_scale")
"""Sockets of materials that a source feeds, by their manifest names."""


@dataclass(frozen=True)
class Input:
    """A socket of a source. Thicknesses are shares of the material's range until they are set up.

    `share` is where in the range from the least to the largest thickness the default lies; `value`
    is the default of everything else.
    """

    name: str
    description: str
    share: float | None = None
    value: float | tuple[float, float, float] = 0.0
    minimum: float = 0.0
    maximum: float = 1e6

    @property
    def is_thickness(self) -> bool:
        return self.share is not None


@dataclass(frozen=True)
class Source:
    id: str
    name: str
    description: str
    inputs: tuple[Input, ...]
    coordinates: str | None = None  # output of Texture Coordinate that feeds `Vector`

    @property
    def goes_upon_another(self) -> bool:
        """Whether it changes a thickness instead of making one."""
        return any(item.name == "Thickness" for item in self.inputs)

    @property
    def stands_alone(self) -> bool:
        """Whether it needs neither a picture nor an attribute."""
        return all(item.name != "Value" for item in self.inputs)


_VECTOR = Input("Vector", "Where on the surface", value=(0.0, 0.0, 0.0))
_LEAST = Input("Minimum", "Thickness where the value is 0", share=0.0)
_LARGEST = Input("Maximum", "Thickness where the value is 1", share=1.0)

SOURCES = (
    Source(
        "map",
        "Image",
        "A picture or any other texture from 0 to 1, as a thickness from minimum to maximum",
        (Input("Value", "0: minimum, 1: maximum", value=0.5, maximum=1.0), _LEAST, _LARGEST),
        "UV",
    ),
    Source(
        "attribute",
        "Paint or Attribute",
        "A colour attribute that is painted on, or any attribute from 0 to 1",
        (Input("Value", "0: minimum, 1: maximum", value=0.5, maximum=1.0), _LEAST, _LARGEST),
    ),
    Source(
        "attribute_nm",
        "Attribute in Units of Thickness",
        "An attribute that holds the thickness itself, as from geometry nodes",
        (Input("Value", "Thickness", share=0.5),),
    ),
    Source(
        "drop",
        "Drop",
        "A round drop: highest in the middle, a parabola to its rim",
        (
            Input("Base", "Thickness outside the drop", share=0.0),
            Input("Height", "What the middle adds to the base", share=0.8),
            Input("Centre", "Middle of the drop", value=(0.5, 0.5, 0.0)),
            Input("Radius", "From the middle to the rim", value=0.5, minimum=1e-4),
            _VECTOR,
        ),
        "UV",
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
        "Eddies that carry the film along; add it upon another source, and drive Time",
        (
            Input("Thickness", "Thickness that is swirled", share=0.4),
            Input("Amount", "Share of the thickness by which it is changed", value=0.35),
            Input("Scale", "Eddies per unit of length", value=2.0),
            Input("Flow", "How far the eddies carry", value=1.0),
            Input(
                "Time", "In seconds; the same time gives the same picture", value=0.0, minimum=-1e6
            ),
            _VECTOR,
        ),
        "Object",
    ),
    Source(
        "spread",
        "Spread",
        "Unevenness too fine to be seen: each sample draws a thickness, so that fringes fade as they "
        "do where the thickness varies within a pixel; add it upon another source",
        (
            Input("Thickness", "Mean thickness", share=0.4),
            Input("Spread", "Standard deviation of the thickness", share=0.02),
        ),
    ),
)


def source(source_id: str) -> Source:
    return next(item for item in SOURCES if item.id == source_id)
