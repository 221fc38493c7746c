# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stack of a film's template as data: read, edited, and written as a template again."""

from __future__ import annotations

import copy
import json
import math
import re
import tomllib
from dataclasses import dataclass, field
from typing import Any

from ..core.faults import RecipeError
from ..core.traits import has_layers

MOST_LAYERS = 64
"""cpp_tools/include/nacre/optics/film_stack.h says so too, and checks."""

MULTILAYER = "multilayer"
TECHNIQUES = {
    MULTILAYER: ("Multilayer", "Interference of all layers; the reference"),
    "path_difference": ("Path Difference", "Bands without physics, for style; one clear film"),
    "airy": ("Airy", "Two beams in closed form; one clear film on a clear base"),
    "series": ("Cut Series", "Two round trips and no more, loses light; one clear film and base"),
    "opaque_base": ("Opaque Base", "Closed form over metal; one clear film"),
    "free_film": ("Free Film", "Closed form with one medium on both sides; one clear film"),
    "etalon": ("Etalon", "Two mirrors as bright as the upper face; one clear film"),
    "recursion": ("Recursion", "From the substrate up, any number of coherent layers"),
}
"""Of `[stack] technique`: label and tooltip. The same names as in the reader of templates."""

_MEDIUM_KEYS = ("medium", "n", "k", "cauchy", "sellmeier", "abbe")
_NUMBER = r"[0-9]*\.?[0-9]+(?:e[+-]?[0-9]+)?"
_COMPLEX = re.compile(rf"({_NUMBER})(?:\+({_NUMBER})i)?", re.IGNORECASE)


_SHADER = re.compile(r"^(?:shader|surface) \w+$", re.MULTILINE)


class StackError(RecipeError):
    """A stack cannot be read or edited so; one line for each fault."""


@dataclass
class Layer:
    medium: str  # see medium_text()
    thickness_nm: float
    coherent: bool = True


@dataclass
class Stack:
    """A film from the ambient down. `rest` is what a template holds besides, as it was read."""

    ambient: str
    layers: list[Layer]
    substrate: str
    varying: int | None = None  # index of the layer whose thickness the artist has as a slider
    range_nm: tuple[float, float] = (0.0, 1000.0)  # of it
    technique: str = MULTILAYER  # of TECHNIQUES
    rest: dict[str, Any] = field(default_factory=dict)
    # What the look's thickness was made for.
    look_range_nm: tuple[float, float] | None = field(default=None, compare=False)

    @property
    def has_scale(self) -> bool:
        return "scale" in self.rest.get("stack", {})


def read_stack(text: str) -> Stack:
    """From a template; groups of layers are unrolled."""
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        if _SHADER.search(text):
            raise StackError("not the template of a film: it is a shader") from error
        raise StackError(f"not a template: {error}") from error
    if not has_layers(data):
        raise StackError("not the template of a film: it has no [ambient] and [substrate]")
    try:
        return _read(data)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise StackError(f"not a template: {error!r}") from error


def _read(data: dict[str, Any]) -> Stack:
    layers: list[dict[str, Any]] = []
    for entry in data.pop("layer", []):
        if "group" in entry:
            layers += list(entry["group"]) * int(entry.get("repeat", 1))
        else:
            layers.append(entry)
    stack = Stack(
        ambient=medium_text(data.pop("ambient")),
        layers=[],
        substrate=medium_text(data.pop("substrate")),
    )
    for index, layer in enumerate(layers):
        thickness = layer["thickness_nm"]
        if isinstance(thickness, dict):
            if thickness.get("varies"):
                stack.varying = index
                stack.range_nm = (float(thickness["min"]), float(thickness["max"]))
            thickness = thickness["default"]
        stack.layers.append(
            Layer(medium_text(layer), float(thickness), bool(layer.get("coherent", True)))
        )
    stack.technique = _take_technique(data)
    stack.rest = data
    stack.look_range_nm = stack.range_nm
    return stack


def _take_technique(data: dict[str, Any]) -> str:
    whole = data.get("stack", {})
    technique = str(whole.pop("technique", MULTILAYER))
    if not whole:
        data.pop("stack", None)
    return _technique(technique)


def _technique(name: str) -> str:
    if name not in TECHNIQUES:
        raise StackError(f"technique: must be one of {', '.join(TECHNIQUES)} (got {name})")
    return name


def write_template(stack: Stack) -> str:
    """The template's text; the same stack gives the same text."""
    lines = [f"schema = {stack.rest.get('schema', 1)}"]
    _add_table(lines, "[material]", stack.rest.get("material", {}))
    _add_table(lines, "[ambient]", _medium("ambient.medium", stack.ambient))
    for index, layer in enumerate(stack.layers):
        entry: dict[str, Any] = dict(_medium(f"layer[{index}].medium", layer.medium))
        entry["thickness_nm"] = layer.thickness_nm
        if index == stack.varying:
            low, high = stack.range_nm
            entry["thickness_nm"] = {
                "default": min(max(layer.thickness_nm, low), high),
                "min": low,
                "max": high,
                "varies": True,
            }
        if not layer.coherent:
            entry["coherent"] = False
        _add_table(lines, "[[layer]]", entry)
    _add_table(lines, "[substrate]", _medium("substrate.medium", stack.substrate))
    for name, value in _rest(stack).items():
        if name in ("schema", "material"):
            continue
        for item in value if isinstance(value, list) else [value]:
            _add_table(lines, f"[[{name}]]" if isinstance(value, list) else f"[{name}]", item)
    return "\n".join(lines) + "\n"


def _medium(path: str, text: str) -> dict[str, Any]:
    try:
        return parse_medium(text)
    except StackError as error:
        raise StackError(f"{path}: {error}") from error


def _rest(stack: Stack) -> dict[str, Any]:
    rest = dict(stack.rest)
    varies = stack.varying is not None or stack.has_scale
    if "look" in rest and not (varies and stack.range_nm == stack.look_range_nm):
        rest["look"] = {name: value for name, value in rest["look"].items() if name != "thickness"}
    if stack.technique != MULTILAYER:
        rest["stack"] = {**rest.get("stack", {}), "technique": stack.technique}
    return rest


def _add_table(lines: list[str], head: str, values: dict[str, Any]) -> None:
    lines += ["", head, *(f"{name} = {_toml(value)}" for name, value in values.items())]


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and value == int(value) and abs(value) < 1e15:
        return f"{value:.1f}"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return "{ " + ", ".join(f"{name} = {_toml(item)}" for name, item in value.items()) + " }"


# ---- Media ---------------------------------------------------------------------------------------


def medium_text(table: dict[str, Any]) -> str:
    """A medium as one writes it in a field: `Fe/Johnson`, `1.5`, `2.1+0.05i`, `cauchy 1.54 0.004`,
    `sellmeier b1 … / c1 …`, `abbe 1.5168 64.2`."""
    if "medium" in table:
        return str(table["medium"])
    k = f"+{_short(table['k'])}i" if table.get("k") else ""
    if "n" in table:
        return _short(table["n"]) + k
    if "cauchy" in table:
        return " ".join(["cauchy", *map(_short, table["cauchy"]), *([k] if k else [])])
    if "sellmeier" in table:
        terms = table["sellmeier"]
        return " ".join(["sellmeier", *map(_short, terms["b"]), "/", *map(_short, terms["c"])])
    if "abbe" in table:
        return f"abbe {_short(table['abbe']['n_d'])} {_short(table['abbe']['v_d'])}"
    raise ValueError(f"a medium needs one of {', '.join(_MEDIUM_KEYS)}")


def parse_medium(text: str) -> dict[str, Any]:
    """The template's keys of what `medium_text` writes; any other text is a key of the library."""
    text = text.strip()
    if not text:
        raise StackError("must be named, such as water/Daimon-20C, or given as 1.33")
    plain = _COMPLEX.fullmatch(text.replace(" ", ""))
    if plain:
        n, k = float(plain[1]), float(plain[2] or 0.0)
        return {"n": n, "k": k} if k else {"n": n}
    word, *numbers = text.split()
    if word == "cauchy":
        return _cauchy(text, numbers)
    if word == "sellmeier":
        b, _, c = " ".join(numbers).partition("/")
        return {"sellmeier": {"b": _numbers(text, b.split()), "c": _numbers(text, c.split())}}
    if word == "abbe":
        values = _numbers(text, numbers)
        if len(values) != 2:
            raise StackError(f"abbe needs n_d and v_d, as in abbe 1.5168 64.2 (got {text!r})")
        return {"abbe": {"n_d": values[0], "v_d": values[1]}}
    return {"medium": text}


def _cauchy(text: str, numbers: list[str]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    if numbers and numbers[-1].startswith("+"):
        result["k"] = _numbers(text, [numbers.pop().strip("+i")])[0]
    return {"cauchy": _numbers(text, numbers), **result}


def _numbers(text: str, words: list[str]) -> list[float]:
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = []
    if not values or not all(map(math.isfinite, values)):
        raise StackError(f"must be a word and numbers, as in cauchy 1.54 0.004 (got {text!r})")
    return values


def _short(number: float) -> str:
    return repr(float(number)).removesuffix(".0")


# ---- Edits by name -------------------------------------------------------------------------------


def is_path(name: str) -> bool:
    """Whether `--set name=value` means the stack, not a value of the material."""
    names = ("ambient", "substrate", "range_nm", "technique")
    return name in names or name.startswith("layers.")


def edit(stack: Stack, path: str, value: str) -> Stack:
    """A copy with one thing changed: `ambient`, `substrate`, `layers.N.medium`,
    `layers.N.thickness_nm`, `layers.N.coherent`, counted from 0, `range_nm` = LOW:HIGH or
    `technique`."""
    result = copy.deepcopy(stack)
    if path in ("ambient", "substrate"):
        _medium(path, value)
        setattr(result, path, value)
        return result
    if path == "range_nm":
        result.range_nm = _range(value)
        return result
    if path == "technique":
        result.technique = _technique(value)
        return result
    _, index, name = (*path.split("."), "", "")[:3]
    if not index.isdecimal() or int(index) >= len(stack.layers):
        have = (
            f"there are layers 0 to {len(stack.layers) - 1}" if stack.layers else "there are none"
        )
        raise StackError(f"{path}: no such layer; {have}")
    layer = result.layers[int(index)]
    if name == "medium":
        _medium(path, value)
        layer.medium = value
    elif name == "thickness_nm":
        layer.thickness_nm = _thickness(path, value)
    elif name == "coherent":
        if value not in ("true", "false"):
            raise StackError(f"{path}: must be true or false (got {value})")
        layer.coherent = value == "true"
    else:
        raise StackError(f"{path}: must end in .medium, .thickness_nm or .coherent")
    return result


def _thickness(path: str, value: str) -> float:
    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not 0.0 <= number <= 1e8:
        raise StackError(f"{path}: must be in [0, 1e8] nm (got {value})")
    return number


def _range(value: str) -> tuple[float, float]:
    low, _, high = value.partition(":")
    limits = (_thickness("range_nm", low), _thickness("range_nm", high or "nan"))
    if limits[0] >= limits[1]:
        raise StackError(f"range_nm: must be LOW:HIGH with LOW < HIGH (got {value})")
    return limits
