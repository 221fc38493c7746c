# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Files whose scene-linear space is not Rec.709 show the colours of those whose is."""

from __future__ import annotations

import re
from itertools import product

import numpy as np
import pytest

from blender.harness import Blender, Server, server_command
from support.colours import REC709_TO_XYZ, delta_e
from support.images import read_image
from support.paths import ROOT, materials_folder
from support.representatives import FORMS

STUDIO = ROOT / "tests" / "support" / "studio.ocio"
# Where a path has two ways to go, the noise of the samples stays; it falls like 1/N.
SAMPLES = {
    "anodised_titanium": 1, "oil_on_water": 1, "soap_film": 4096, "dichroic_mirror": 4096,
}  # fmt: skip
SEEN_THROUGH = ("soap_film", "dichroic_mirror")
IN_GAMUT = -1e-4
MEAN = 0.05


def job(material, form, space="", how="assigned"):
    return {
        "material": material,
        "form": form,
        "values": {},
        "space": space,
        "how": how,
        "reflected": material in SEEN_THROUGH,
        "samples": SAMPLES[material],
    }


def rendered(blender: Blender, **what) -> np.ndarray:
    """In XYZ."""
    file = blender.folder / "picture.exr"
    file.unlink(missing_ok=True)
    matrix = blender.call("space.render", **job(**what), file=str(file))
    return read_image(file) @ np.array(matrix).T


FROM_XYZ = np.linalg.inv(REC709_TO_XYZ)


def compare(found_xyz: np.ndarray, expected_xyz: np.ndarray) -> None:
    found, expected = found_xyz @ FROM_XYZ.T, expected_xyz @ FROM_XYZ.T
    inside = np.all(expected > IN_GAMUT, axis=-1)
    assert np.count_nonzero(inside) > 60
    difference = delta_e(found[inside], expected[inside])
    assert np.mean(difference) <= MEAN, (np.mean(difference), np.max(difference))


CASES = list(product(SAMPLES, FORMS))


@pytest.fixture(scope="module")
def plain(blenders, tmp_path_factory):
    """Pictures in files of Rec.709, in XYZ."""
    found: dict[tuple, np.ndarray] = {}

    def picture(version: str, material: str, form: str) -> np.ndarray:
        key = (version, material, form)
        if key not in found:
            blender = blenders.get(version, tmp_path_factory.mktemp("plain"))
            found[key] = rendered(blender, material=material, form=form)
        return found[key]

    return picture


@pytest.mark.parametrize("blender_version", ["5.2"], indirect=True)
@pytest.mark.parametrize("space", ["Linear Rec.2020", "ACEScg"])
@pytest.mark.parametrize(("material", "form"), CASES)
def test_material_assigned_in_a_working_space(blender, plain, space, material, form):
    found = rendered(blender, material=material, form=form, space=space)
    compare(found, plain("5.2", material, form))


@pytest.mark.parametrize("blender_version", ["5.2"], indirect=True)
@pytest.mark.parametrize("how", ["changed", "appended", "linked"])
@pytest.mark.parametrize(
    ("material", "form"), [("anodised_titanium", "nodes"), ("soap_film", "osl")]
)
def test_material_that_was_made_in_another_space(blender, plain, how, material, form):
    found = rendered(blender, material=material, form=form, space="ACEScg", how=how)
    compare(found, plain("5.2", material, form))


@pytest.fixture(scope="module")
def studio(blender):
    """A Blender that was started with a studio's configuration."""
    server = Server(["env", f"OCIO={STUDIO}", *server_command(blender.python)])
    yield Blender(blender.version, blender.python, server, blender.folder)
    server.close()


@pytest.mark.parametrize(("material", "form"), CASES)
def test_material_under_a_studio_s_configuration(studio, plain, material, form):
    found = rendered(studio, material=material, form=form)
    compare(found, plain(studio.version, material, form))


def stage_light(blender: Blender, stage: str) -> np.ndarray:
    """In XYZ."""
    file = blender.folder / f"{stage}.exr"
    file.unlink(missing_ok=True)
    matrix = blender.call("space.stage_light", stage=stage, file=str(file))
    return read_image(file) @ np.array(matrix).T


# A sky with trees, and warm lamps in a room.
@pytest.mark.parametrize("stage", ["bubble", "sphere"])
def test_the_light_of_a_stage_under_a_studio_s_configuration(blender, studio, stage):
    expected = stage_light(blender, stage)
    assert expected.max() > 2.0 * expected.min()
    compare(stage_light(studio, stage), expected)


# What a glass or a grating sends to the eye is of one wavelength, and in no gamut.
WORLD = """
shader world(float line_nm = 550.0, {edges}, {weight}, output color value = 0.0)
{{
    int transmissions = 0;
    getattribute("path:transmission_depth", transmissions);
    nacre_wavelength path = nacre_draw_wavelength(wavelength_edges, wavelength_weight,
                                                  nacre_path_random());
    if (transmissions == 2 && fabs(path.nm - line_nm) < 15.0) value = color(1.0);
}}
"""


def world() -> str:
    """White for a band of wavelengths that came through the glass."""
    text = (materials_folder() / "n_bk7" / "n_bk7.osl").read_text("utf-8")
    head, _, body = text.partition("shader nacre_n_bk7\n")
    arrays = {
        name: re.search(rf"{kind} wavelength_{name}\[\d+\] = {{[^}}]*}}", body)[0]
        for kind, name in (("float", "edges"), ("color", "weight"))
    }
    return head + WORLD.format(**arrays)


def spectral(call: str, blender: Blender, space: str = "", **job) -> np.ndarray:
    """Rows of XYZ."""
    file = blender.folder / "picture.exr"
    file.unlink(missing_ok=True)
    matrix = blender.call(call, **job, space=space, file=str(file))
    return (read_image(file) @ np.array(matrix).T).reshape(-1, 3)


def through_glass(blender: Blender, space: str = "") -> np.ndarray:
    bands = (450.0, 510.0, 560.0, 620.0)
    job = {"material": "n_bk7", "apex_deg": 30.0, "incidence_deg": 45.0, "world": world()}
    return np.array(
        [
            spectral("prism.render", blender, space, **job, line_nm=nm, samples=2048).mean(axis=0)
            for nm in bands
        ]
    )


def from_a_disc(blender: Blender, space: str = "") -> np.ndarray:
    job = {"material": "cd", "eye": [0, -3, 4], "lamp": [0, 3, 5], "target": [0, 1.05, 0]}
    return spectral("disc.render", blender, space, **job, fov_deg=10.0, height=32, samples=4096)


SPECTRAL = [through_glass, from_a_disc]


def compare_rows(found: np.ndarray, expected: np.ndarray) -> None:
    """Of XYZ, where there is light."""
    lit = expected.sum(axis=1) > 0.1 * expected.sum(axis=1).max()
    assert np.count_nonzero(lit) >= 4
    error = np.linalg.norm(found[lit] - expected[lit], axis=1)
    relative = error / np.linalg.norm(expected[lit], axis=1)
    print("relative errors of XYZ:", np.round(relative, 4))
    assert relative.mean() <= 0.01


@pytest.mark.parametrize("blender_version", ["5.2"], indirect=True)
@pytest.mark.parametrize("space", ["Linear Rec.2020", "ACEScg"])
@pytest.mark.parametrize("seen", SPECTRAL)
def test_spectral_colours_in_a_working_space(blender, seen, space):
    compare_rows(seen(blender, space), seen(blender))


@pytest.mark.parametrize("seen", SPECTRAL)
def test_spectral_colours_under_a_studio_s_configuration(studio, blenders, tmp_path, seen):
    compare_rows(seen(studio), seen(blenders.get(studio.version, tmp_path)))
