# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What may be asked of a material, of whatever kind it is: `traits` in cpp_tools/doc/manifest.md."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import lru_cache
from typing import Any

SURFACE, EMISSION, VOLUME = "surface", "emission", "volume"
ROLES = (SURFACE, EMISSION, VOLUME)
"""Of closures."""

BODY = "body"
FURNACES = (SURFACE, BODY)


@dataclass(frozen=True)
class Closure:
    """An output of a material's group, and what of an object it describes."""

    output: str
    role: str


@dataclass(frozen=True)
class Traits:
    stage: str = "shaderball"  # on which `render` shows it when no other is named
    editable_stack: bool = False  # its template has layers for the stack editor
    probe: bool = False  # a pixel of it can be probed for thickness, angle and spectrum
    closures: tuple[Closure, ...] = ()
    truth: str | None = None  # what its pictures can be checked against
    furnace: str = SURFACE  # what of it the stage `furnace` shows

    def text(self) -> str:
        """For `read`."""
        return json.dumps(asdict(self))


UNSAID = Traits()


def parse_traits(
    data: Any, where: str, outputs: Iterable[Iterable[str]], problems: list[str]
) -> Traits | None:
    """Appends every fault to `problems` and then returns None. `outputs`: of each form's group."""
    before = len(problems)
    if not isinstance(data, dict):
        problems.append(f"{where}: must be an object (got {data!r})")
        return None
    stage, truth, furnace = data.get("stage"), data.get("truth"), data.get("furnace")
    if not isinstance(stage, str) or not stage:
        problems.append(f"{where}.stage: must be the name of a stage (got {stage!r})")
    for name in ("editable_stack", "probe"):
        if not isinstance(data.get(name), bool):
            problems.append(f"{where}.{name}: must be true or false (got {data.get(name)!r})")
    if truth is not None and not isinstance(truth, str):
        problems.append(f"{where}.truth: must be a word or null (got {truth!r})")
    if furnace not in FURNACES:
        problems.append(f"{where}.furnace: must be one of {', '.join(FURNACES)} (got {furnace!r})")
    closures = _parse_closures(data.get("closures"), f"{where}.closures", outputs, problems)
    if len(problems) > before:
        return None
    return Traits(stage, data["editable_stack"], data["probe"], closures, truth, furnace)


def _parse_closures(
    data: Any, where: str, outputs: Iterable[Iterable[str]], problems: list[str]
) -> tuple[Closure, ...]:
    if not isinstance(data, list) or not data:
        problems.append(f"{where}: must be a list of objects, one for each output (got {data!r})")
        return ()
    of_each_form = [tuple(names) for names in outputs]
    closures = []
    for index, item in enumerate(data):
        at = f"{where}[{index}]"
        if not isinstance(item, dict):
            problems.append(f"{at}: must be an object with an output and a role (got {item!r})")
            continue
        output, role = item.get("output"), item.get("role")
        for names in of_each_form:
            if output not in names:
                allowed = ", ".join(names) or "none"
                problems.append(f"{at}.output: must be an output: {allowed} (got {output!r})")
                break
        if role not in ROLES:
            problems.append(f"{at}.role: must be one of {', '.join(ROLES)} (got {role!r})")
        closures.append(Closure(output, role))
    return tuple(closures)


def of_header(data: Mapping[str, Any]) -> Traits:
    """Of a manifest whose graphs are not read."""
    if "traits" in data:
        return parse_traits(data["traits"], "", (), []) or UNSAID
    return assumed(str(data.get("template", "")))


@lru_cache(maxsize=64)
def read(text: str) -> Traits | None:
    """What `Traits.text` wrote, or None."""
    try:
        data = json.loads(text)
        outputs = [closure["output"] for closure in data["closures"]]
        return parse_traits(data, "", [outputs], [])
    except (ValueError, KeyError, TypeError):
        return None


@lru_cache(maxsize=64)
def assumed(template: str, outputs: tuple[str, ...] = (), is_body: bool = False) -> Traits:
    """Where nothing is said, as by older versions: what the template tells. Whose template has layers is
    edited and probed as a stack; the first output is a surface."""
    layered = _is_layered(template)
    return Traits(
        editable_stack=layered,
        probe=layered,
        closures=tuple(Closure(output, SURFACE) for output in outputs[:1]),
        truth="stack" if layered else None,
        furnace=BODY if is_body and not layered else SURFACE,
    )


def has_layers(template: Mapping[str, Any]) -> bool:
    """Of one that was parsed."""
    return "ambient" in template and "substrate" in template


def _is_layered(template: str) -> bool:
    try:
        return has_layers(tomllib.loads(template))
    except tomllib.TOMLDecodeError:
        return False
