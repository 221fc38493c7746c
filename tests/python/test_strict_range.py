# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Media whose data end within 360 … 830 nm, from Python."""

from __future__ import annotations

import numpy as np
import pytest

import nacre

ENDS = "BaTiO3/Wemple-o"  # 400 … 700 nm
GRID = np.arange(360.0, 831.0)
NOTE = (
    f"{ENDS}: n and k are held beyond 400 … 700 nm, 0.0402 % of the luminous weight (D65, cie1931)"
)
REFUSED = r"must be within the data, 400 … 700 nm \(got 360\); without --strict-range"
FILM = f"""\
schema = 1
[material]
id = "t"
name = "T"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
medium = "{ENDS}"
thickness_nm = 200
[substrate]
medium = "Ag/Johnson"
"""


def test_the_index_is_held_at_both_ends():
    medium = nacre.library.medium(ENDS)
    index = medium.index_on_grid()
    assert np.array_equal(index, medium.index(np.clip(GRID, 400, 700)))
    with pytest.raises(nacre.NacreError, match=f"{ENDS}: wavelength_nm: {REFUSED}"):
        medium.index_on_grid(strict_range=True)
    with pytest.raises(
        nacre.NacreError, match=r"must be within the data, 400 … 700 nm \(got 380\)"
    ):
        medium.index(380.0)
    with pytest.raises(nacre.NacreError, match="what is needed is 400 … 700 nm"):
        nacre.library.medium("TiO2/Devore-o").index_on_grid()
    silver = nacre.library.medium("Ag/Johnson")
    assert np.array_equal(silver.index_on_grid(strict_range=True), silver.index(GRID))


def test_what_is_held_is_said():
    medium = nacre.library.medium(ENDS)
    held = medium.held_ends()
    assert held.note == NOTE
    assert held.percent == pytest.approx(0.0402, abs=5e-5)
    assert medium.held_ends(illuminant="A").percent > held.percent
    assert nacre.library.medium("Ag/Johnson").held_ends(strict_range=True) == (0.0, "")
    with pytest.raises(nacre.NacreError, match=REFUSED):
        medium.held_ends(strict_range=True)


def test_stacks_take_such_media_alike():
    n = [np.ones(471), nacre.library.medium(ENDS).index_on_grid(), np.full(471, 1.5)]
    by_key = nacre.film_lut([1, ENDS, 1.5], [200], size=(4, 1), tolerance=None)
    by_numbers = nacre.film_lut(n, [200], size=(4, 1), tolerance=None)
    assert np.array_equal(by_key.reflectance.texels, by_numbers.reflectance.texels)
    spectrum = nacre.stack(np.stack(n, axis=-1), [200.0], 30.0, GRID, pol="u")
    wanted = nacre.spectrum_to_colour(GRID, spectrum.R)
    colour = nacre.stack_colour([1, ENDS, 1.5], [200.0], 30.0, sampling="full")
    assert colour.reflectance.rgb == pytest.approx(wanted.rgb, abs=1e-12)
    by_template = nacre.template_spectrum(FILM.replace('medium = "Ag/Johnson"', "n = 1.5"))
    straight = nacre.stack(np.stack(n, axis=-1), [200.0], 0.0, GRID, pol="u")
    assert by_template.reflectance == pytest.approx(straight.R, abs=1e-12)


def test_templates_say_what_is_held():
    made = nacre.compile_template(FILM, tolerance=2)
    (held,) = made.manifest["held_ends"]
    assert held["note"] == NOTE
    sizes = {"R": made.tables["R"].shape[:2]}
    assert nacre.preview_tables(FILM, sizes)["R"].shape == made.tables["R"].shape
    strict = {"strict_range": True}
    for call in (
        lambda: nacre.compile_template(FILM, "f.toml", **strict),
        lambda: nacre.preview_tables(FILM, sizes, "f.toml", **strict),
        lambda: nacre.template_spectrum(FILM, file="f.toml", **strict),
    ):
        with pytest.raises(nacre.NacreError, match=rf"f\.toml:10: layer\[0\]\.medium: {REFUSED}"):
            call()
    with pytest.raises(nacre.NacreError, match=REFUSED):
        nacre.film_lut([1, ENDS, 1.5], [200], size=(4, 1), tolerance=None, **strict)
    whole = FILM.replace(ENDS, "SiO2/Malitson")
    assert "held_ends" not in nacre.compile_template(whole, tolerance=2, **strict).manifest
