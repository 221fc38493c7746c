# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Every hand-written shader that is a material, as it is without anything set and with its presets: inputs have
the shader's own defaults, and no more light leaves than comes."""

from __future__ import annotations

import re

import numpy as np
import pytest

from support.osl import SHADER_MATERIALS
from support.paths import manifest, materials_folder
from support.truth import pixel_cosines

SIZE, SAMPLES = 12, 512
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # of linear Rec.709
NUMBERS = ("float", "int", "color")
CASES = [
    (material, form, preset)
    for material in SHADER_MATERIALS
    for form in ("osl", "nodes")  # that for bands is seen by test_glass_in_bands
    if manifest(material)["graphs"][form] is not None
    for preset in (None, *(each["name"] for each in manifest(material).get("presets", [])))
]


@pytest.fixture(scope="module")
def furnaces(blender):
    def job(material: str, form: str, preset: str | None) -> dict:
        presets = {each["name"]: each["values"] for each in manifest(material).get("presets", [])}
        return {
            "material": material,
            "form": form,
            "values": presets.get(preset, {}),
            "lit": "all",
            "size": SIZE,
            "samples": SAMPLES,
        }

    return blender.pictures("furnace.render", job)


@pytest.mark.parametrize(("material", "form", "preset"), CASES)
def test_no_light_is_made(furnaces, material, form, preset):
    _, counted = pixel_cosines(SIZE)
    picture = furnaces(material, form, preset)
    assert np.isfinite(picture).all()
    found = float((picture[counted] @ LUMINANCE).mean())
    print(f"{found:.4f} of the light")
    assert 0.0 < found <= 1 + 5e-3
    if manifest(material)["traits"]["truth"] == "white":
        assert found >= 1 - 5e-3


@pytest.mark.parametrize("material", SHADER_MATERIALS)
def test_inputs_have_the_defaults_of_the_shader(blender, material):
    osl = (materials_folder() / material / f"{material}.osl").read_text("utf-8")
    compiled, _, _ = blender.ask("osl.compile_all", shaders={material: osl})
    stated = dict(
        re.findall(r"^param\t\w+\t(\w+)\t([-+.e\d ]*\d)", compiled[material], re.MULTILINE)
    )
    sockets = [each for each in manifest(material)["sockets"] if each["type"] in NUMBERS]
    assert sockets
    for socket in sockets:
        values = list(map(float, stated[socket["name"]].split()))
        default = socket["default"]
        np.testing.assert_allclose(values, default, rtol=1e-6, err_msg=socket["name"])
    of_groups = blender.call("hand_written.inputs", material=material)
    for socket in sockets:
        value = of_groups[socket["name"]]
        held = value[:3] if socket["type"] == "color" else value
        np.testing.assert_allclose(held, socket["default"], rtol=1e-6, err_msg=socket["name"])


@pytest.mark.parametrize("material", SHADER_MATERIALS)
def test_presets_are_kept_by_the_group_and_taken_by_name(blender, material):
    for preset in manifest(material)["presets"]:
        values = blender.call("hand_written.inputs", material=material, preset=preset["name"])
        for name, value in preset["values"].items():
            np.testing.assert_allclose(values[name], value, rtol=1e-6, err_msg=name)
