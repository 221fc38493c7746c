# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""White furnace for every film and roughness: no more light leaves than comes."""

from __future__ import annotations

import numpy as np
import pytest
from harness import manifest
from truth import material_template, pixel_cosines, template_names

SIZE, SAMPLES = 8, 2048
ROUGHNESSES = (0.0, 0.3, 0.65, 1.0)
FILMS = [name for name in template_names() if "substrate" in material_template(name)]
FORMS = ("osl", "nodes")
# Of linear Rec.709. A single channel may pass 1: a saturated colour of a surface that keeps all
# light of some wavelengths lies outside the gamut.
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


# The last one reflects greens outside the gamut, whose negative channels nodes cut.
CASES = [(film, {}) for film in FILMS] + [("soap_film", {"thickness_nm": 340.0})]
NAMES = ["-".join([film, *(f"{value:g}" for value in more.values())]) for film, more in CASES]


def values(material: str, roughness: float, more: dict) -> dict:
    """A white base where there is one: the most that can come back."""
    names = {socket["name"] for socket in manifest(material)["sockets"]}
    given = {"roughness": roughness, "base_colour": (1.0, 1.0, 1.0, 1.0), **more}
    return {name: value for name, value in given.items() if name in names}


@pytest.fixture(scope="module")
def furnaces(blender):
    keys = [(name, form, rough) for name in NAMES for form in FORMS for rough in ROUGHNESSES]
    jobs = [
        {
            "material": film,
            "values": values(film, rough, more),
            "form": form,
            "lit": "all",
            "size": SIZE,
            "samples": SAMPLES,
        }
        for film, more in CASES
        for form in FORMS
        for rough in ROUGHNESSES
    ]
    return dict(zip(keys, blender.run("furnace_worker.py", jobs), strict=True))


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("name", NAMES)
def test_no_light_is_made(furnaces, name, form, record_property):
    cosines, counted = pixel_cosines(SIZE)
    zones = {"sphere": counted, "rim": counted & (cosines < 0.6)}
    found = {
        (rough, part): float((furnaces[name, form, rough][zone] @ LUMINANCE).mean())
        for rough in ROUGHNESSES
        for part, zone in zones.items()
    }
    record_property("most", f"{max(found.values()):.5f}")
    print({key: round(value, 5) for key, value in found.items()})
    assert max(found.values()) <= 1 + 1e-3
    assert min(found.values()) > 0.0
