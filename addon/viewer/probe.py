# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a probe says about a point of a surface: geometry as it was rendered, spectrum and colour as
the exact multilayer gives them, in double precision."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ..core.faults import ForeseenError
from ..core.light import FIRST_NM, LAST_NM, Conditions
from ..core.space import srgb
from ..films.stack import Stack, StackError, read_stack, write_template


class ProbeError(ForeseenError):
    """There is nothing to measure."""


@dataclass(frozen=True)
class Reading:
    """What the renderer found at a pixel; directions and places in world space, single precision."""

    point: tuple[float, ...]
    normal: tuple[float, ...]
    uv: tuple[float, ...]
    cos_theta: float
    is_back: bool
    thickness_nm: float


@dataclass(frozen=True)
class Sample:
    """The recipe of a stack of layers, and what its socket counts in; see field_nodes.py."""

    template: str
    conditions: Conditions
    unit_nm: float
    varies: bool


@dataclass(frozen=True)
class Light:
    """Reflected or transmitted: 471 values at 1 nm, and the colour of them. A white is (1, 1, 1) in
    linear Rec.709 and has Y = 1; nothing is clipped but in `hex`."""

    spectrum: tuple[float, ...]
    XYZ: tuple[float, ...]
    rgb: tuple[float, ...]

    @property
    def is_in_gamut(self) -> bool:
        return all(-1e-9 <= value <= 1.0 + 1e-9 for value in self.rgb)

    @property
    def hex(self) -> str:
        """sRGB, held to its gamut."""
        return "#" + "".join(f"{round(255.0 * srgb(value)):02x}" for value in self.rgb)


@dataclass(frozen=True)
class Probe:
    pixel: tuple[int, int]  # from the top left
    material: str
    kind: str
    reading: Reading
    sample: Sample | None = None
    reflected: Light | None = None
    transmitted: Light | None = None
    problem: str = ""  # why there is no spectrum

    @property
    def has_thickness(self) -> bool:
        """Whether it is of what can be probed for it, a sample or why there is none."""
        return self.sample is not None or bool(self.problem)

    @property
    def angle_deg(self) -> float:
        """Of incidence, in the medium on the side that is seen."""
        return math.degrees(math.acos(min(1.0, self.reading.cos_theta)))

    def lines(self) -> list[tuple[str, str]]:
        """Label and value, for people."""
        at = self.reading
        side = "back" if at.is_back else "front"
        result = [
            ("Material", self.material),
            ("Thickness", f"{at.thickness_nm:.3f} nm"),
            ("Angle", f"{self.angle_deg:.4f}°, {side}"),
            ("Point", _numbers(at.point, 6)),
            ("Normal", _numbers(at.normal, 6)),
            ("UV", _numbers(at.uv[:2], 6)),
        ]
        if not self.has_thickness:
            result.pop(1)
        for name, light in (("Reflected", self.reflected), ("Transmitted", self.transmitted)):
            if light is not None:
                outside = "" if light.is_in_gamut else ", held to the gamut"
                result += [
                    (f"{name} XYZ", _numbers(light.XYZ, 8)),
                    (f"{name} RGB", _numbers(light.rgb, 8)),
                    (f"{name} sRGB", light.hex + outside),
                ]
        return result

    def data(self) -> dict[str, Any]:
        """For JSON; field names as cpp_tools/doc/viewer.md has them."""
        at = self.reading
        result: dict[str, Any] = {
            "pixel": list(self.pixel),
            "material": self.material,
            "kind": self.kind,
            "point": list(at.point),
            "normal": list(at.normal),
            "uv": list(at.uv[:2]),
            "angle_deg": self.angle_deg,
            "side": "back" if at.is_back else "front",
            "thickness_nm": at.thickness_nm if self.has_thickness else None,
        }
        if self.sample is not None:
            result |= self.sample.conditions._asdict()
        for name, light in (("R", self.reflected), ("T", self.transmitted)):
            if light is not None:
                result[name] = {
                    "wavelength_nm": [FIRST_NM, LAST_NM],
                    "spectrum": list(light.spectrum),
                    "XYZ": list(light.XYZ),
                    "rgb": list(light.rgb),
                    "sRGB": light.hex,
                }
        if self.problem:
            result["problem"] = self.problem
        return result

    def text(self) -> str:
        lines = [f"{label}: {value}" for label, value in self.lines()]
        return "\n".join([*lines, *([self.problem] if self.problem else [])])

    def json(self) -> str:
        return json.dumps(self.data(), sort_keys=True)


def measure(
    pixel: tuple[int, int], material: str, kind: str, reading: Reading, sample: Sample | None
) -> Probe:
    """Adds spectrum and colours where there is a sample of the material; one that cannot be computed has
    its problem instead."""
    if sample is None:
        return Probe(pixel, material, kind, reading)
    try:
        lights = _lights(reading, sample, material)
    except (StackError, ImportError, ValueError) as error:  # NacreError is a ValueError
        return Probe(pixel, material, kind, reading, sample, problem=str(error))
    return Probe(pixel, material, kind, reading, sample, *lights)


def _lights(reading: Reading, sample: Sample, name: str) -> tuple[Light, Light | None]:
    import nacre

    stack = read_stack(sample.template)
    lets_through = bool(stack.rest.get("surface", {}).get("transmission"))
    template = sample.template
    if reading.is_back and lets_through and stack.ambient != stack.substrate:
        template = write_template(seen_from_behind(stack))
    value = reading.thickness_nm / sample.unit_nm if sample.varies else 1.0
    angle = math.degrees(math.acos(min(1.0, reading.cos_theta)))
    found = nacre.template_spectrum(template, value, angle, name, **sample.conditions._asdict())
    reflected = _light(found.reflectance, sample)
    return reflected, _light(found.transmittance, sample) if lets_through else None


def seen_from_behind(stack: Stack) -> Stack:
    """The same layers as light meets them from inside the substrate."""
    last = len(stack.layers) - 1
    return Stack(
        ambient=stack.substrate,
        layers=stack.layers[::-1],
        substrate=stack.ambient,
        varying=None if stack.varying is None else last - stack.varying,
        range_nm=stack.range_nm,
        rest=stack.rest,
    )


def _light(spectrum: Sequence[float], sample: Sample) -> Light:
    import nacre

    grid = range(FIRST_NM, LAST_NM + 1)
    colour = nacre.spectrum_to_colour(list(grid), spectrum, **sample.conditions._asdict())
    return Light(*(tuple(map(float, values)) for values in (spectrum, colour.XYZ, colour.rgb)))


def _numbers(values: Sequence[float], digits: int) -> str:
    return ", ".join(f"{value:.{digits}f}" for value in values)
