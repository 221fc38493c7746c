# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual that comes with the packaged extension: pages that need no net."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "manual"

PAGES = (
    ("blender", "In Blender", "From installing to the first picture"),
    ("thickness", "Thickness", "Thickness that varies over a surface"),
    ("stacks", "Stacks", "Layers, and the light that they are computed for"),
    ("models", "Techniques", "What a film's colour is computed by"),
    ("rough", "Rough Surfaces", "Rough and brushed films"),
    ("viewer", "Probe, Views and Passes", "Numbers at a point, fields, passes and pictures"),
    ("spectral", "Spectral Rendering", "Wavelengths in place of red, green and blue"),
    ("library", "Materials and Media", "Optical constants, spectra, and those of one's own"),
)


def page(name: str) -> Path:
    return FOLDER / f"{name}.html"


def is_there() -> bool:
    """It is made when the extension is packaged; a checkout has its pages in cpp_tools/doc."""
    return page(PAGES[0][0]).is_file()
