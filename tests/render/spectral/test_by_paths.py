# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Paths that draw their wavelengths: the colours of bands in one render."""

from __future__ import annotations

import colour
import numpy as np
import pytest

from nacre import library
from support.images import read_channels, read_image
from support.spectral import delta_e, delta_e_of_parts, light_at, observer_at, reflectance_at

LIGHTS = ["D65", "A", "F2", "F11", "LED-B3", "lamp/hps", "line:462@1,532@0.8,638@1.2"]
CHART = [key for key in library.keys("spectra") if key.startswith("colorchecker/")]
SIZE = 4
"""Pixels of a patch, of which the four in the middle count."""
TO_XYZ = colour.RGB_COLOURSPACES["sRGB"].matrix_RGB_to_XYZ


@pytest.fixture(scope="module")
def chart(blender):
    """XYZ of each patch, a row for each light."""
    file = blender.folder / "by_paths.exr"
    said = blender.call(
        "spectral.scenes.chart",
        reflectances=CHART, lights=LIGHTS, file=str(file), size=SIZE, samples=4096, passes=-1,
    )  # fmt: skip
    assert said == {"left": [], "same": True}
    xyz = read_image(file)[..., :3] @ TO_XYZ.T
    parts = xyz.reshape(len(LIGHTS), SIZE, len(CHART), SIZE, 3)
    return parts[:, 1:3, :, 1:3].mean(axis=(1, 3))


@pytest.mark.parametrize("light", LIGHTS)
def test_chart_has_the_colours_that_it_should(chart, light, record_property):
    """What is left is chance: some thousand wavelengths for all lights at once."""
    nm, power = light_at(light)
    seen = observer_at(nm) * power[:, None]
    white = seen.sum(axis=0)
    expected = np.array([reflectance_at(key, nm) @ seen for key in CHART]) / white[1]
    errors = delta_e(chart[LIGHTS.index(light)], expected, white / white[1])
    record_property("delta_e", f"mean {errors.mean():.3f}, max {errors.max():.3f}")
    assert errors.mean() <= 0.1
    assert errors.max() <= 0.3


def test_white_glass_stays_white(blender):
    """As bright as in RGB, whichever of X, Y and Z a path takes through it."""
    folder = blender.folder / "white_by_paths"
    folder.mkdir()
    blender.call(
        "spectral.scenes.films",
        cells=[
            {"material": "sf11", "form": "osl", "values": {}},
            {"material": "water", "form": "nodes", "values": {"dispersion": 5.0}},
        ],
        **{"columns": 2, "folder": str(folder), "size": 16, "samples": 2048, "lit": "all"},
        **{"passes": -1, "light": "D65"},
    )
    before, paths = (read_image(folder / f"{name}.exr")[4:12] for name in ("before", "bands"))
    for middle in (slice(4, 12), slice(20, 28)):
        found = paths[:, middle].mean((0, 1))
        np.testing.assert_allclose(found, before[:, middle].mean(), atol=0.01)


@pytest.mark.parametrize("moves", [False, True])
def test_films_glass_and_what_moves_are_as_in_bands(blender, moves):
    """All that changes for it is as it was; what moves is not torn into colours."""
    blender.see_in("5.2" if moves else "4.5")
    said = blender.call(
        "spectral.paths.full_room",
        folder=str(blender.folder), size=48, samples=192, moves=moves,
    )  # fmt: skip
    assert said == {"left": [], "same": True, "changed": []}
    bands = read_channels(blender.folder / "bands.exr", "RGB")[0]
    paths = read_image(blender.folder / "paths.exr")[..., :3]
    glass = np.zeros(bands.shape[:2], bool)
    glass[14:27, 21:34] = True  # where one path in a few has all the light
    for part, share in ((~glass, 0.01), (glass, 0.12)):
        np.testing.assert_allclose(paths[part].mean(0), bands[part].mean(0), rtol=share)
    assert delta_e_of_parts(paths, bands) < 2.0  # of noise
