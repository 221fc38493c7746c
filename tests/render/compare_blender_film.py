# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Blender's own thin film, and Nacre's, against the exact spectrum: a Markdown table of ΔE00.

    ./dev bench colour        or, by itself:   python tests/render/compare_blender_film.py

Every pixel of an orthographic sphere under a white world, D65, CIE 1931 2°. Both get the same
structure with the same constant indices, which is all that Blender's film can take. The environment
is that of the render tests (NACRE, NACRE_BPY45, NACRE_BPY52).
"""

from __future__ import annotations

import json
import os
import re
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from blender.harness import VERSIONS, Blender, Blenders
from support.colours import delta_e
from support.paths import PACKAGE, ROOT, manifest
from support.tool import nacre

sys.path.insert(0, str(PACKAGE))

from support.truth import pixel_cosines

THICKNESSES = (200.0, 400.0, 800.0, 1600.0)
WAVELENGTHS = np.arange(360.0, 831.0)
# What: id, index of the film, n and k of the substrate.
STRUCTURES = {
    "film 1.33 on glass 1.5": ("on_glass", 1.33, (1.5, 0.0)),
    "film 2.0 on metal 2.9 + 3.1i": ("on_metal", 2.0, (2.9, 3.1)),
}
SHADERS = {
    "blender": "Blender",
    "live": "Nacre, summed in the shader",
    "table": "Nacre, table",
}
TEMPLATE = """\
schema = 1
[material]
id = "{id}"
name = "{id}"
category = "Comparison"
description = "One film"
source = "constant indices"
[ambient]
medium = "air"
[[layer]]
n = {film}
thickness_nm = {{ default = 400, min = 0, max = 1600, varies = true }}
[substrate]
n = {n}
k = {k}
"""


def shader_text(file: Path, seen: set[str]) -> str:
    """OSL with the headers in place: Cycles' compiler takes no include path."""

    def header(match: re.Match) -> str:
        if match[1] in seen:
            return ""
        seen.add(match[1])
        return shader_text(ROOT / "osl" / "include" / match[1], seen)

    text = file.read_text("utf-8").replace("#pragma once\n", "")
    return re.sub(r'#include "(nacre/[^"]+)"', header, text)


def compile_tables(folder: Path) -> None:
    for name, film, (n, k) in STRUCTURES.values():
        template = folder / f"{name}.toml"
        template.write_text(TEMPLATE.format(id=name, film=film, n=n, k=k), "utf-8")
        nacre("compile", template, "-o", folder)


def exact(film: float, substrate: tuple[float, float], thickness_nm: float, cosines) -> np.ndarray:
    """Linear Rec. 709 of the reflectance, 471 wavelengths."""
    from nacre import spectrum_to_colour, stack

    reflectance = stack(
        np.array([1.0, film, complex(*substrate)]),
        np.array([thickness_nm]),
        np.degrees(np.arccos(cosines))[:, None],
        WAVELENGTHS,
    ).R
    return np.array([spectrum_to_colour(WAVELENGTHS, row).rgb for row in reflectance])


def measure(blender: Blender) -> dict[tuple[str, float, str], tuple[float, float] | None]:
    """Mean and largest ΔE00 by structure, thickness and shader; None where Blender has no film."""
    osl = shader_text(ROOT / "osl" / "shaders" / "nacre_thin_film.osl", set())
    jobs = [
        {
            "shader": shader,
            "film_n": film,
            "substrate": substrate,
            "thickness_nm": thickness,
            "osl": osl,
            "material": name,
            "thickness_socket": manifest(name)["tables"][0]["axes"][1]["name"],
            "what": what,
        }
        for what, (name, film, substrate) in STRUCTURES.items()
        for thickness in THICKNESSES
        for shader in SHADERS
    ]
    found = {}
    for job in jobs:
        picture = blender.picture("film.render", **job)
        cosines, counted = pixel_cosines(len(picture))
        key = job["what"], job["thickness_nm"], job["shader"]
        found[key] = None
        if picture.max() > 0:
            truth = exact(job["film_n"], job["substrate"], job["thickness_nm"], cosines[counted])
            errors = delta_e(picture[counted], truth)
            found[key] = errors.mean(), errors.max()
    return found


def measure_all() -> dict[str, dict]:
    """`measure` for each Blender that there is."""
    with tempfile.TemporaryDirectory() as folder:
        compile_tables(Path(folder))
        os.environ["NACRE_MATERIALS"] = folder
        blenders = Blenders()
        found = {version: blenders.get(version, Path(folder)) for version in VERSIONS}
        try:
            return {version: measure(blender) for version, blender in found.items() if blender}
        finally:
            blenders.close()


def table(found: dict[str, dict]) -> str:
    heads = [f"{thickness:.0f} nm" for thickness in THICKNESSES]
    lines = [["ΔE00 mean / max", "shader", *heads], ["---"] * (2 + len(heads))]
    for version, results in found.items():
        for what in STRUCTURES:
            for shader, label in SHADERS.items():
                row = [results[what, thickness, shader] for thickness in THICKNESSES]
                cells = ["none" if r is None else "{:.3f} / {:.3f}".format(*r) for r in row]
                lines.append([f"{what}, Blender {version}", label, *cells])
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def summary(found: dict[str, dict]) -> list[dict]:
    """Mean ΔE00 over the thicknesses, Blender's and our table's, where Blender has a film."""
    records = []
    for version, results in found.items():
        for what, (name, *_) in STRUCTURES.items():
            means = {
                shader: [results[what, thickness, shader] for thickness in THICKNESSES]
                for shader in ("table", "blender")
            }
            if None in means["blender"]:
                continue
            ours, peer = (float(np.mean([mean for mean, _ in rows])) for rows in means.values())
            records.append(
                {"id": name, "what": what, "blender": version, "ours": ours, "peer": peer}
            )
    return records


def main() -> None:
    found = measure_all()
    print(table(found))
    print("RESULT " + json.dumps(summary(found)))


if __name__ == "__main__":
    main()
