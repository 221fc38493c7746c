# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a material can be varied, and within which values that are physical."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..thickness.sources import ZERO_CELSIUS, Input, Source
from .drawing import Knob

# Of the material's own inputs. Dispersion other than 1 is not the glass; it is drawn by no die, but can
# be turned. Roughness is drawn more finely near a mirror, as the eye sees it.
_OWN = {
    "coverage": (0.5, 1.0),
    "anisotropy": (0.0, 0.8),
    "strength": (0.35, 1.0),
    "pitch_nm": (-math.inf, math.inf),
    "dispersion": None,
}
_ROUGHNESS = (0.0, 0.02, 0.05, 0.1, 0.16, 0.24, 0.34, 0.46, 0.6)
_FROSTED = 0.06  # how far from a mirror More Like This goes where nothing else varies


@dataclass(frozen=True)
class _Rule:
    usual: tuple[float, float] | None
    is_log: bool = False
    step: float | None = None


# Of sources, by input. What is not here is how the object lies or how the oxide grows, and stays.
_SHAPES = {
    "Scale": _Rule((0.5, 5.0), is_log=True),
    "Detail": _Rule((0.0, 5.0)),
    "Reach": _Rule((0.5, 2.5), is_log=True),
    "Radius": _Rule((0.3, 0.9)),
    "Amount": _Rule((0.1, 0.6)),
    "Flow": _Rule((0.3, 2.0)),
    "Width": _Rule(None),
    "Black Film": _Rule((0.02, 0.25)),
}
_TIMES = {
    "swirl": _Rule((0.0, 60.0), step=2.0),
    "drainage": _Rule((1.0, 4.0), is_log=True),  # it only thins
}
_HEAT_REACH = _Rule((1.2, 4.0), is_log=True)  # heat that falls fast leaves its colours at an edge
_HOTTER = 15.0  # °C that More Like This goes
_GROWN = 0.45  # of the range: oxide at the hottest end that has run through several colours


def own_knob(
    name: str, value: float, limits: tuple[float, float], *, is_alone: bool
) -> Knob | None:
    """Of an input of the material, but its thickness. `is_alone`: it has no thickness to vary."""
    if name == "roughness":
        # A liquid or polished film is a mirror, and stays one.
        stays = value == 0.0 and not is_alone
        ladder = () if stays else tuple(min(max(rung, limits[0]), limits[1]) for rung in _ROUGHNESS)
        usual = None if stays else (0.0, 0.6)
        step = _FROSTED if value == 0.0 and is_alone else None
        return Knob(name, value, *limits, usual, ladder=ladder, step=step)
    if name not in _OWN:
        return None
    usual = _OWN[name]
    if usual is not None:
        usual = max(usual[0], limits[0]), min(usual[1], limits[1])
    return Knob(name, value, *limits, usual)


def thickness_knob(
    name: str, value: float, span: tuple[float, float], ladder: tuple[float, ...]
) -> Knob:
    return Knob(name, value, *span, span, ladder=ladder)


def source_knob(
    node: str,
    source: Source,
    item: Input,
    values: dict[str, float],
    span: tuple[float, float],
    ladder: tuple[float, ...],
) -> Knob | None:
    """Of an input of a source. `values` are those of all of its inputs."""
    name, value = f"{node}/{item.name}", values[item.name]
    if item.is_thickness and item.added:
        if source.id != "drop":
            return None
        width = span[1] - span[0]
        usual = 0.15 * width, 0.8 * width
        return Knob(name, value, 0.0, span[1], usual, piled_on=f"{node}/Base")
    if item.is_thickness:
        if item.name == "Grown":
            return None
        above = f"{node}/Minimum" if item.name == "Maximum" else ""
        return Knob(name, value, *span, span, ladder=ladder, not_below=above)
    if item.name == "Hottest":
        hottest = _temperatures(values, span, ladder, (item.minimum, item.maximum))
        usual = (hottest[0], hottest[-1]) if hottest else None
        return Knob(name, value, item.minimum, item.maximum, usual, ladder=hottest, step=_HOTTER)
    rule = _rule(source, item)
    if rule is None:
        return None
    limits = item.minimum, item.maximum
    return Knob(name, value, *limits, rule.usual, is_log=rule.is_log, step=rule.step)


def _rule(source: Source, item: Input) -> _Rule | None:
    if item.name == "Time":
        return _TIMES.get(source.id)
    if item.name == "Reach" and any(other.name == "Hottest" for other in source.own):
        return _HEAT_REACH
    return _SHAPES.get(item.name)


def _temperatures(
    values: dict[str, float],
    span: tuple[float, float],
    ladder: tuple[float, ...],
    limits: tuple[float, float],
) -> tuple[float, ...]:
    """At which the oxide grows that has these thicknesses: d = d_ref exp(B (1/T_ref - 1/T)) for T."""
    thicknesses = ladder or tuple(span[0] + (span[1] - span[0]) * i / 8 for i in range(9))
    least = span[0] + _GROWN * (span[1] - span[0])
    found = []
    for thickness in (value for value in thicknesses if value >= least):
        if min(values["Grown"], values["Growth"], thickness) <= 0.0:
            continue
        slower = math.log(thickness / values["Grown"]) / values["Growth"]
        inverse = 1.0 / (values["At"] + ZERO_CELSIUS) - slower
        if inverse > 0.0 and limits[0] <= 1.0 / inverse - ZERO_CELSIUS <= limits[1]:
            found.append(1.0 / inverse - ZERO_CELSIUS)
    return tuple(found) if len(found) > 1 else ()
