# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colours of rough films by rough_truth.py, whose light takes minutes to walk, kept in a file.

`./dev refs -k rough` adds what is missing or out of date. A test computes one point of each anew, and
another one in each run.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from support.rough_truth import furnace_colours
from support.truth import material_template

FILE = Path(__file__).with_name("rough_truth.json")


@dataclass(frozen=True)
class RoughFilm:
    """What furnace_colours() takes, but for the directions; GGX alpha along the tangent and across."""

    material: str
    value: float | None
    alpha: tuple[float, float]
    spread_nm: float = 0.0
    turned: bool = False  # azimuths are those of a quarter turn
    paths: int = 80_000

    @property
    def name(self) -> str:
        alpha = " x ".join(f"{a:g}" for a in dict.fromkeys(round(a, 6) for a in self.alpha))
        spread = f", spread {self.spread_nm:g} nm" if self.spread_nm else ""
        turned = ", turned" if self.turned else ""
        return (
            f"{self.material} at {self.value:g}, alpha {alpha}{turned}{spread}, {self.paths} paths"
        )

    @property
    def stack(self) -> dict:
        """What the colours depend on, of the template."""
        template = material_template(self.material)
        return {key: template.get(key) for key in ("ambient", "layer", "substrate", "stack")}

    def compute(self, cosines: np.ndarray, azimuths: np.ndarray | None = None) -> np.ndarray:
        return furnace_colours(
            material_template(self.material), self.value, cosines, self.alpha, azimuths,
            self.paths, self.spread_nm,
        )  # fmt: skip


@cache
def entries() -> dict[str, dict]:
    return json.loads(FILE.read_text("utf-8")) if FILE.exists() else {}


def film_of(entry: dict) -> RoughFilm:
    return RoughFilm(**{**entry["film"], "alpha": tuple(entry["film"]["alpha"])})


def _fits(entry: dict, film: RoughFilm, directions: dict[str, list]) -> bool:
    return entry["stack"] == film.stack and all(
        len(entry.get(name, ())) == len(values)
        and np.allclose(entry[name], values, rtol=0, atol=2e-9)
        for name, values in directions.items()
    )


def _store(name: str, entry: dict) -> None:
    entries()[name] = entry
    aside = FILE.with_suffix(".new")
    records = [f"{json.dumps(key)}: {json.dumps(entries()[key])}" for key in sorted(entries())]
    aside.write_text("{\n" + ",\n".join(records) + "\n}\n", "utf-8")
    aside.replace(FILE)


def stored_colours(
    film: RoughFilm, cosines: np.ndarray, azimuths: np.ndarray | None = None, *, update: bool
) -> np.ndarray:
    """Linear Rec. 709, shape (len(cosines), 3); `update`: computed and stored where they are not."""
    directions = {"cosines": np.round(cosines, 9).tolist()}
    if azimuths is not None:
        directions["azimuths"] = np.round(azimuths, 9).tolist()
    entry = entries().get(film.name)
    if entry is None or not _fits(entry, film, directions):
        assert update, f"no stored truth of {film.name}: ./dev refs -k rough"
        rgb = film.compute(**{name: np.array(values) for name, values in directions.items()})
        entry = {"film": vars(film), "stack": film.stack, **directions,
                 "rgb": np.round(rgb, 7).tolist()}  # fmt: skip
        _store(film.name, entry)
    return np.array(entry["rgb"])
