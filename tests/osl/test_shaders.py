# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The shipped shaders compile without a word, and each keeps the promise of its effect."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from support.osl import SHADER_MATERIALS, SHADERS, inline, shader
from support.paths import TEMPLATES, materials_folder

colour = pytest.importorskip("colour")
tmm = pytest.importorskip("tmm")


def is_complaint(said: str) -> bool:
    return re.search(r"warning|error:", said, re.I) is not None


REDEFINED = """
float same(float x) { return x; }
float same(float x) { return -x; }
shader odd(output closure color BSDF = 0) { BSDF = same(0.5) * emission(); }
"""


def test_complaints_of_the_compiler_are_heard(blender):
    """Else its silence would mean nothing."""
    _, said = blender.compile({"odd": REDEFINED})
    assert is_complaint(said), said


def test_every_shader_compiles_without_warnings(blender):
    texts = {path.stem: inline(path.read_text(encoding="utf-8")) for path in SHADERS}
    compiled, said = blender.compile(texts)
    assert not is_complaint(said), said
    assert set(compiled) == set(texts)


def test_every_compiled_template_compiles_without_warnings(blender):
    paths = sorted(materials_folder().glob("*/*.osl"))
    assert len(paths) == len(list(TEMPLATES.glob("*.toml"))) + len(SHADER_MATERIALS)
    _, said = blender.compile({path.stem: path.read_text(encoding="utf-8") for path in paths})
    assert not is_complaint(said), said


# -- film --------------------------------------------------------------------------------------


def film_colour(n_1: complex, n_2: complex, thickness_nm: float, cos_0: float) -> np.ndarray:
    """Linear Rec.709 under D65, summed over 360-830 nm at 1 nm; a perfect white is (1, 1, 1)."""
    shape = colour.SpectralShape(360, 830, 1)
    matching = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(shape).values
    light = colour.SDS_ILLUMINANTS["D65"].copy().align(shape).values
    to_rgb = np.linalg.inv(colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_RGB_to_XYZ)
    weights = (matching * light[:, None]) @ to_rgb.T
    weights /= weights.sum(axis=0)
    angle = math.acos(cos_0)
    spectrum = [
        tmm.unpolarized_RT([1.0, n_1, n_2], [np.inf, thickness_nm, np.inf], angle, nm)["R"]
        for nm in shape.wavelengths
    ]
    return np.asarray(spectrum) @ weights


@pytest.mark.parametrize(
    ("n_1", "n_2", "thickness_nm", "tilt"),
    [(1.33, 1.0, 400.0, 0.0), (2.4, 2.9 + 3.4j, 40.0, 1.0), (2.0, 1.5, 1200.0, 0.6)],
)
def test_film_has_the_colour_of_its_spectrum(blender, n_1, n_2, thickness_nm, tilt):
    """A flat film under a white world reflects its own colour, out of the gamut or not."""
    values = {
        "film_n": n_1,
        "substrate_n": complex(n_2).real,
        "substrate_k": complex(n_2).imag,
        "thickness_nm": thickness_nm,
        "wavelengths": 235,
    }
    image = blender.render(
        osl=shader("nacre_thin_film"),
        object="disc",
        width=4,
        height=4,
        samples=1,
        span=0.5,
        tilt=tilt,
        values=values,
    )
    expected = film_colour(n_1, n_2, thickness_nm, math.cos(tilt))
    np.testing.assert_allclose(image[2, 2], expected, atol=4e-4)


def test_multilayer_reads_its_tables(blender):
    """R in proportion to the axes; T lets the rest of a white world through."""
    x, y = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 5))
    table = blender.write_table(np.stack([x, y, np.zeros_like(x)], axis=-1) * 0.5)
    values = {
        "table_R": table,
        "table_T": table,
        "table_width": 9,
        "table_height": 5,
        "axis_min": 100.0,
        "axis_max": 500.0,
        "thickness": 400.0,
        "table_origin_top": blender.table_origin_top,
    }
    image = blender.render(
        osl=shader("nacre_multilayer"),
        object="disc",
        width=4,
        height=4,
        samples=4,
        span=0.5,
        tilt=math.acos(0.6),
        values=values,
    )
    np.testing.assert_allclose(image[2, 2], [0.6, 0.75, 0.0], atol=2e-3)


# -- glass -------------------------------------------------------------------------------------

# n_d, Abbe number, samples
GLASSES = {
    "crown": (1.5168, 64.2, 256),
    "flint": (1.7847, 25.7, 256),
    "diamond": (2.4175, 55.3, 512),
}


def assert_white(image: np.ndarray) -> None:
    """Within 5e-4, plus three standard errors of the noise that one wavelength per path brings."""
    pixels = image.reshape(-1, 3)
    error = 3.0 * pixels.std(axis=0) / math.sqrt(len(pixels))
    assert np.all(error < 2.5e-3), "too noisy to tell"
    assert np.all(abs(pixels.mean(axis=0) - 1.0) < 5e-4 + error), pixels.mean(axis=0)


@pytest.mark.parametrize("glass", GLASSES)
def test_white_world_stays_white_through_glass(blender, glass):
    n_d, v_d, samples = GLASSES[glass]
    image = blender.render(
        osl=shader("nacre_glass"),
        object="sphere",
        width=64,
        height=64,
        samples=samples,
        values={"n_d": n_d, "v_d": v_d},
    )
    assert_white(image)


def test_weight_is_applied_once_through_two_objects(blender):
    """A second ball behind the first: weighting at each entry would square the weight."""
    image = blender.render(
        osl=shader("nacre_glass"),
        object="sphere",
        width=64,
        height=64,
        samples=256,
        offsets=[[0, 0, 0], [0, 0, -2.2]],
        values={"n_d": 1.7847, "v_d": 25.7},
    )
    assert_white(image)


def test_weight_is_applied_once_after_a_reflection(blender):
    """Paths that a ball throws at its neighbour enter that one first, and not with both weights."""
    image = blender.render(
        osl=shader("nacre_glass"),
        object="sphere",
        width=64,
        height=64,
        samples=256,
        span=3.0,
        offsets=[[-0.6, 0, 0], [0.6, 0, 0]],
        radius=0.55,
        values={"n_d": 2.4175, "v_d": 55.3},
    )
    assert_white(image)


def test_no_dispersion_means_no_colour_noise(blender):
    image = blender.render(
        osl=shader("nacre_glass"),
        object="sphere",
        width=32,
        height=32,
        samples=16,
        values={"dispersion": 0.0},
    )
    np.testing.assert_array_equal(image[..., 0], image[..., 1])
    np.testing.assert_array_equal(image[..., 0], image[..., 2])


# -- disc --------------------------------------------------------------------------------------

SUNS = [(0.34, 0.0), (0.34, 0.6), (0.40, 2.0)]  # polar angle, azimuth


@pytest.mark.parametrize(("polar", "azimuth"), SUNS)
def test_streak_lies_where_the_grating_equation_puts_it(blender, polar, azimuth):
    """Seen from above, order m = ±1 sends sin(polar) = wavelength / pitch to the eye, and from those
    tracks only that run across the plane of incidence."""
    image = blender.render(
        osl=shader("nacre_disc"),
        object="disc",
        width=96,
        height=96,
        samples=32,
        world=0.0,
        lamps=[{"energy": 3.0, "angle": 0.02, "polar": polar, "azimuth": azimuth}],
        values={"roughness": 0.08},
    )
    light = image.sum(axis=2).clip(0)
    y, x = (47.5 - np.mgrid[0:96, 0:96][0]) / 48, (np.mgrid[0:96, 0:96][1] - 47.5) / 48
    spread = np.cov(np.stack([x.ravel(), y.ravel()]), aweights=light.ravel())
    axis = np.linalg.eigh(spread)[1][:, 1]
    towards = np.array([math.sin(azimuth), -math.cos(azimuth)])
    assert abs(axis @ towards) > math.cos(1.0 / 48)  # one pixel at the rim

    wavelength = 1600.0 * math.sin(polar)
    dominant = "B" if wavelength < 490 else "G" if wavelength < 580 else "R"
    assert "RGB"[int(np.argmax(image[light > np.percentile(light, 99)].sum(axis=0)))] == dominant


def test_disc_loses_no_light(blender):
    """All orders of a white metal under a white world add up to white."""
    image = blender.render(
        osl=shader("nacre_disc"),
        object="disc",
        width=64,
        height=64,
        samples=256,
        span=1.0,
        values={"tint": [1, 1, 1], "roughness": 0.0, "orders": 9},
    )
    np.testing.assert_allclose(image.mean(axis=(0, 1)), 1.0, atol=5e-3)


@pytest.mark.parametrize(
    ("offset", "radius"),
    [((0, 0, 0.7), 0.65), ((0, 0.9, 0.45), 0.4)],
    ids=["disc behind glass", "glass in the disc's orders"],
)
def test_glass_and_disc_together_leave_white_white(blender, offset, radius):
    """Either weights its wavelength, in both orders on a path: by one and the same wavelength the
    weight would be squared."""
    image = blender.render(
        osl=shader("nacre_disc"),
        object="disc",
        width=64,
        height=64,
        samples=512,
        span=1.0,
        values={
            "tint": [1, 1, 1],
            "roughness": 0.0,
            "pitch_nm": 700.0,  # three orders at most
            "strength": 0.3,
        },
        ball={
            "osl": shader("nacre_glass"),
            "values": {"n_d": 1.7847, "v_d": 25.7},
            "offset": offset,
            "radius": radius,
        },
    )
    noise = image.std(axis=(0, 1)) / 64
    print("mean", image.mean(axis=(0, 1)), "noise", noise)
    assert np.all(noise < 2.5e-3), "too noisy to tell"
    np.testing.assert_allclose(image.mean(axis=(0, 1)), 1.0, atol=5e-3)
