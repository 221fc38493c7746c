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

from ..core.light import Conditions
from ..films.stack import Stack, StackError, read_stack, write_template

FIRST_NM, LAST_NM = 360, 830


class ProbeError(Exception):
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
class Film:
    """The recipe of a film, and what its socket counts in; see field_nodes.py."""

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
    film: Film | None = None
    reflected: Light | None = None
    transmitted: Light | None = None
    problem: str = ""  # why there is no spectrum

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
        if self.kind != "film":
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
            "thickness_nm": at.thickness_nm if self.kind == "film" else None,
        }
        if self.film is not None:
            result |= self.film.conditions._asdict()
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
    pixel: tuple[int, int], material: str, kind: str, reading: Reading, film: Film | None
) -> Probe:
    """Adds spectrum and colours where the material is a film; a film that cannot be computed has its
    problem instead."""
    if film is None:
        return Probe(pixel, material, kind, reading)
    try:
        lights = _lights(reading, film, material)
    except (StackError, ImportError, ValueError) as error:  # NacreError is a ValueError
        return Probe(pixel, material, kind, reading, film, problem=str(error))
    return Probe(pixel, material, kind, reading, film, *lights)


def _lights(reading: Reading, film: Film, name: str) -> tuple[Light, Light | None]:
    import nacre

    stack = read_stack(film.template)
    lets_through = bool(stack.rest.get("surface", {}).get("transmission"))
    template = film.template
    if reading.is_back and lets_through and stack.ambient != stack.substrate:
        template = write_template(seen_from_behind(stack))
    value = reading.thickness_nm / film.unit_nm if film.varies else 1.0
    angle = math.degrees(math.acos(min(1.0, reading.cos_theta)))
    found = nacre.template_spectrum(template, value, angle, name, **film.conditions._asdict())
    reflected = _light(found.reflectance, film)
    return reflected, _light(found.transmittance, film) if lets_through else None


def seen_from_behind(stack: Stack) -> Stack:
    """The same film as light meets it from inside the substrate."""
    last = len(stack.layers) - 1
    return Stack(
        ambient=stack.substrate,
        layers=stack.layers[::-1],
        substrate=stack.ambient,
        varying=None if stack.varying is None else last - stack.varying,
        range_nm=stack.range_nm,
        rest=stack.rest,
    )


def _light(spectrum: Sequence[float], film: Film) -> Light:
    import nacre

    grid = range(FIRST_NM, LAST_NM + 1)
    colour = nacre.spectrum_to_colour(list(grid), spectrum, **film.conditions._asdict())
    return Light(*(tuple(map(float, values)) for values in (spectrum, colour.XYZ, colour.rgb)))


def srgb(linear: float) -> float:
    """IEC 61966-2-1."""
    held = min(max(linear, 0.0), 1.0)
    return 12.92 * held if held <= 0.0031308 else 1.055 * held ** (1.0 / 2.4) - 0.055


def _numbers(values: Sequence[float], digits: int) -> str:
    return ", ".join(f"{value:.{digits}f}" for value in values)
