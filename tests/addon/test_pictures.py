# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The stored pictures of materials are of the materials and objects as they are now."""

from __future__ import annotations

import os

import numpy as np
import pytest

from support.colours import delta_e
from support.images import read_image
from support.osl import SHADER_MATERIALS
from support.paths import ADDON, TEMPLATES, materials_folder

THUMBNAILS = ADDON / "thumbnails"
PICTURES = sorted(path.stem for path in THUMBNAILS.glob("*.jpg"))
# All of them in the soak, four seconds each. Smaller pictures would blur what sparkles.
CHOSEN = PICTURES if os.environ.get("NACRE_SOAK") else PICTURES[3::14]
BLOCKS = 8


def blocks(pixels: np.ndarray) -> np.ndarray:
    """Means of 8 x 8 parts, in linear light."""
    linear = np.where(pixels <= 0.04045, pixels / 12.92, ((pixels + 0.055) / 1.055) ** 2.4)
    size = len(linear) // BLOCKS
    return linear.reshape(BLOCKS, size, BLOCKS, size, 3).mean(axis=(1, 3))


def test_every_variant_has_a_picture_and_no_other():
    templates = {path.stem: path.read_text("utf-8") for path in TEMPLATES.glob("*.toml")}
    varied = {f"{name}.even" for name, text in templates.items() if "\nthickness = [" in text}
    assert set(PICTURES) == set(templates) | set(SHADER_MATERIALS) | varied
    assert sum(path.stat().st_size for path in THUMBNAILS.glob("*.jpg")) < 1.2e6


@pytest.mark.parametrize("picture", CHOSEN)
def test_picture_is_of_the_material_as_it_is(blender45, tmp_path, picture):
    material, _, even = picture.partition(".")
    look = ("--stage", "portrait") if even else ("--look",)
    done = blender45.with_environment(NACRE_MATERIALS=str(materials_folder())).render(
        "--material", material, *look, "--view", "AgX", "--size", "128x128", "--samples", "12",
        "--denoise", "-o", tmp_path / "now.png",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    stored, now = (
        blocks(read_image(path)) for path in (THUMBNAILS / f"{picture}.jpg", tmp_path / "now.png")
    )
    assert delta_e(stored.mean(axis=(0, 1)), now.mean(axis=(0, 1))) < 1.5
    assert delta_e(stored, now).mean() < 3.0
