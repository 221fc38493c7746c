# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Hand-written shaders in other renderers: they ask for what OSL's specification has, and one macro says where
I points. A renderer whose I runs to the surface is had by turning Cycles' own around."""

from __future__ import annotations

import re

import numpy as np
import pytest

from support.osl import SHADERS, inline

# OSL 1.12, Language Specification: global variables (table 6.1), and material closures (7.10).
GLOBALS = {"P", "I", "N", "Ng", "dPdu", "dPdv", "Ps", "u", "v", "time", "dtime", "dPdtime", "Ci"}
CLOSURES = {
    "emission", "background", "diffuse", "oren_nayar", "phong", "ward", "microfacet", "reflection", "refraction",
    "transparent", "translucent", "holdout", "debug", "subsurface", "oren_nayar_diffuse_bsdf",
    "burley_diffuse_bsdf", "dielectric_bsdf", "conductor_bsdf", "generalized_schlick_bsdf", "translucent_bsdf",
    "transparent_bsdf", "subsurface_bssrdf", "sheen_bsdf", "uniform_edf", "anisotropic_vdf", "medium_vdf",
    "layer", "add",
}  # fmt: skip

TURNED = "#define I (-I)\n"
ELSEWHERE = "#define NACRE_I_TO_SURFACE\n"


def test_shaders_ask_for_what_the_specification_has(blender):
    texts = {path.stem: inline(path.read_text("utf-8")) for path in SHADERS}
    bytecode, _ = blender.compile(texts)
    for name in texts:
        symbols = re.findall(r"^global\t\S+\t(\w+)", bytecode[name], re.MULTILINE)
        constants = dict(
            re.findall(r'^const\tstring\t(\S+)\t"([^"]*)"', bytecode[name], re.MULTILINE)
        )
        calls = re.findall(r"^\tclosure\t\t?(.*?)(?:\t|$)", bytecode[name], re.MULTILINE)
        strings = ([constants[w] for w in call.split() if w in constants] for call in calls)
        closures = {made[0] for made in strings}
        assert symbols, name
        assert set(symbols) <= GLOBALS, name
        assert closures, name
        assert closures <= CLOSURES, name


def picture(blender, osl: str) -> np.ndarray:
    """A disc seen at a slant, in the light of a lamp."""
    return blender.render(
        osl=osl, object="disc", width=24, height=24, samples=16, world=0.3, tilt=0.6,
        lamps=[{"energy": 3.0, "angle": 0.3, "polar": 0.5, "azimuth": 0.4}],
    )  # fmt: skip


@pytest.mark.parametrize("path", SHADERS, ids=lambda path: path.stem)
def test_one_macro_chooses_the_sign_of_i(blender, path):
    osl = inline(path.read_text("utf-8"))
    here = picture(blender, osl)
    assert here.max() > 0.0
    np.testing.assert_array_equal(picture(blender, ELSEWHERE + TURNED + osl), here)


def test_the_sign_of_i_matters(blender):
    """Else the test above would show nothing."""
    osl = next(inline(path.read_text("utf-8")) for path in SHADERS if path.stem == "nacre_disc")
    assert np.abs(picture(blender, TURNED + osl) - picture(blender, osl)).max() > 0.1
