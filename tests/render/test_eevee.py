# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Films as nodes in EEVEE against the exact spectrum.

EEVEE needs a Blender program with something to draw on: NACRE_BLENDER names one.
"""

from __future__ import annotations

import json
import os
import subprocess
from functools import lru_cache
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
import pytest
from harness import ROOT, delta_e, materials_folder
from rough_truth import furnace_colours
from truth import exact_colours, material_template, pixel_cosines

SIZE = 64
# Colours inside the gamut: EEVEE clips the others, as every form of nodes does.
FILMS = {
    "anodised_titanium": ("thickness_nm", 52.0),
    "oil_on_water": ("thickness_nm", 420.0),
    "tempered_steel": ("thickness_nm", 20.0),
}
CASES = [(material, roughness) for material in FILMS for roughness in (0.0, 0.35)]


@lru_cache
def expected(material: str, roughness: float) -> np.ndarray:
    cosines, counted = pixel_cosines(SIZE, 0.05)
    # A hundredth of the cosine is a hundredth of a colour at most.
    distinct, inverse = np.unique(np.round(cosines[counted], 2), return_inverse=True)
    template, value = material_template(material), FILMS[material][1]
    if roughness == 0.0:
        return exact_colours(template, value, distinct)["R"][inverse]
    alpha = roughness**2
    return furnace_colours(template, value, distinct, (alpha, alpha), paths=10_000)[inverse]


@pytest.fixture(scope="module")
def pictures(tmp_path_factory) -> dict[tuple[str, float], np.ndarray]:
    program = os.environ.get("NACRE_BLENDER")
    if not program:
        pytest.skip("NACRE_BLENDER does not name a Blender program with a display")
    folder = tmp_path_factory.mktemp("eevee")
    jobs = [
        {
            "material": material,
            "values": {FILMS[material][0]: FILMS[material][1], "roughness": roughness},
            "size": SIZE,
            "file": str(folder / f"{material}-{roughness}.exr"),
        }
        for material, roughness in CASES
    ]
    (folder / "jobs.json").write_text(json.dumps(jobs), "utf-8")
    worker = Path(__file__).with_name("eevee_worker.py")
    arguments = ["-b", "--factory-startup", "--python-exit-code", "3", "--python", worker, "--"]
    done = subprocess.run(
        [program, *arguments, ROOT / "addon", folder / "jobs.json"],
        env={**os.environ, "NACRE_MATERIALS": str(materials_folder())},
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
    )
    if not Path(jobs[-1]["file"]).is_file():
        pytest.fail(f"{program}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return {
        case: oiio.ImageBuf(job["file"]).get_pixels(oiio.FLOAT)[..., :3]
        for case, job in zip(CASES, jobs, strict=True)
    }


@pytest.mark.parametrize(("material", "roughness"), CASES)
def test_film_in_eevee(pictures, material, roughness, record_property):
    _, counted = pixel_cosines(SIZE, 0.05)
    errors = delta_e(pictures[material, roughness][counted], expected(material, roughness))
    record_property("dE00", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    print(f"dE00 mean {errors.mean():.3f}, max {errors.max():.3f} of {errors.size} pixels")
    assert errors.mean() <= 1.0
