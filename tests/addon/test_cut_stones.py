# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Cut stones in EEVEE, which refracts once: as bright and of the colour of their pictures."""

from __future__ import annotations

import shutil

import numpy as np
import pytest

from blender.harness import Blender, Server, xvfb_command
from support.colours import delta_e
from support.images import read_channels, read_image
from support.paths import ADDON, materials_folder

SIZE, SAMPLES = 128, 24
COVERED = 0.9  # of a pixel: without the rim
LIMIT = 12.0
# Shaders are compiled in software, up to a minute each: one stone a version, and one version's ball.
SEEN_IN = {"diamond": "4.5", "mystic_topaz": "5.2", "ball": "4.5"}


@pytest.fixture(scope="module")
def shown(blender_version, blenders, tmp_path_factory):
    if not shutil.which("xvfb-run"):
        pytest.skip("EEVEE needs a display, and there is no xvfb-run (Debian's xvfb, xauth)")
    folder = tmp_path_factory.mktemp("stones")
    python = blenders.get(blender_version, folder).python
    server = Server(xvfb_command(python))
    yield Blender(
        blender_version, python, server, folder,
        {"LIBGL_ALWAYS_SOFTWARE": "1", "NACRE_MATERIALS": str(materials_folder())},
    )  # fmt: skip
    server.close()


def linear(picture: np.ndarray) -> np.ndarray:
    return np.where(picture <= 0.04045, picture / 12.92, ((picture + 0.055) / 1.055) ** 2.4)


# Without the virtual facets the diamond is off by 13, the topaz by 22.
@pytest.mark.parametrize("stone", ["diamond", "mystic_topaz"])
def test_eevee_shows_a_cut_stone_as_it_is_pictured(shown, stone):
    shown.see_in(SEEN_IN[stone])
    file = shown.folder / f"{stone}.png"
    shown.call("eevee.portrait", material=stone, size=SIZE, samples=SAMPLES, file=str(file))
    pixels, _ = read_channels(file, "RGBA")
    inside = pixels[..., 3] > COVERED
    assert 0.2 < inside.mean() < 0.5
    picture = linear(read_image(ADDON / "thumbnails" / f"{stone}.jpg"))
    step = len(picture) // SIZE
    picture = picture.reshape(SIZE, step, SIZE, step, 3).mean(axis=(1, 3))
    seen = linear(pixels[..., :3])
    assert delta_e(picture[inside].mean(axis=0), seen[inside].mean(axis=0)) < LIMIT
    # Facets sparkle: not one grey of the right mean.
    contrast = [np.std(colours[inside].mean(axis=1)) for colours in (picture, seen)]
    assert 0.7 < contrast[1] / contrast[0] < 1.5


def test_what_is_round_has_no_facets(shown):
    shown.see_in(SEEN_IN["ball"])
    pictures = []
    for plain in (False, True):
        file = shown.folder / f"ball-{plain}.png"
        given = {"material": "mystic_topaz", "object": "ball", "size": 48, "samples": 4}
        shown.call("eevee.portrait", plain=plain, file=str(file), **given)
        pictures.append(read_image(file))
    assert np.std(pictures[0]) > 0.05
    assert np.abs(pictures[0] - pictures[1]).max() < 0.01


def test_cut_stones_have_an_output_for_eevee(blender, tmp_path):
    blender.with_environment(NACRE_MATERIALS=str(materials_folder())).script(
        "scenes/cut_stones", tmp_path
    )
