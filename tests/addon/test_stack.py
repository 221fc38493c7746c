# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Stacks as the editor and `--set` know them."""

from __future__ import annotations

import json
import tomllib

import numpy as np
import pytest
from nacre_extension.core import plot
from nacre_extension.films.stack import (
    TECHNIQUES,
    StackError,
    edit,
    is_path,
    medium_text,
    parse_medium,
    read_stack,
    write_template,
)

from support.paths import TEMPLATES
from support.tool import nacre

FILMS = [
    path for path in sorted(TEMPLATES.glob("*.toml")) if "[ambient]" in path.read_text("utf-8")
]
SOAP = (TEMPLATES / "soap_film.toml").read_text("utf-8")
BEETLE = (TEMPLATES / "jewel_beetle.toml").read_text("utf-8")


def unrolled(data: dict) -> dict:
    """Groups of layers as single layers, all numbers as floats."""
    layers = []
    for entry in data.get("layer", []):
        layers += entry["group"] * entry.get("repeat", 1) if "group" in entry else [entry]
    return floats({**data, "layer": layers})


def floats(value):
    if isinstance(value, dict):
        return {name: floats(item) for name, item in value.items() if item != {}}
    if isinstance(value, list):
        return [floats(item) for item in value]
    return float(value) if isinstance(value, int) and not isinstance(value, bool) else value


@pytest.mark.parametrize("path", FILMS, ids=lambda path: path.stem)
def test_templates_come_back_as_they_were(path):
    text = path.read_text("utf-8")
    written = write_template(read_stack(text))
    assert unrolled(tomllib.loads(written)) == unrolled(tomllib.loads(text))
    assert write_template(read_stack(written)) == written


@pytest.mark.parametrize("technique", TECHNIQUES)
@pytest.mark.parametrize("text", [SOAP, BEETLE], ids=["soap", "beetle"])
def test_technique_is_kept(text, technique):
    stack = edit(read_stack(text), "technique", technique)
    written = write_template(stack)
    assert read_stack(written) == stack
    whole = tomllib.loads(written).get("stack", {})
    assert whole.get("technique", "multilayer") == technique
    assert ("scale" in whole) == stack.has_scale
    back = edit(read_stack(written), "technique", "multilayer")
    assert write_template(back) == write_template(read_stack(text))


def test_techniques_are_those_of_the_reader():
    schema = json.loads(nacre("library", "schema"))
    names = schema["properties"]["stack"]["properties"]["technique"]["enum"]
    assert list(TECHNIQUES) == names


def test_groups_are_unrolled():
    stack = read_stack(BEETLE)
    assert len(stack.layers) == 16
    assert stack.layers[1].medium == "1.6"
    assert stack.substrate == "1.6+0.05i"
    assert (stack.has_scale, stack.varying) == (True, None)


@pytest.mark.parametrize(
    ("text", "table"),
    [
        ("Fe/Johnson", {"medium": "Fe/Johnson"}),
        ("air", {"medium": "air"}),
        ("1.5", {"n": 1.5}),
        ("2.1+0.05i", {"n": 2.1, "k": 0.05}),
        ("cauchy 1.54 0.004", {"cauchy": [1.54, 0.004]}),
        ("cauchy 1.54 +0.1i", {"cauchy": [1.54], "k": 0.1}),
        ("sellmeier 1.1 0.2 / 0.01 0.02", {"sellmeier": {"b": [1.1, 0.2], "c": [0.01, 0.02]}}),
        ("abbe 1.47 50", {"abbe": {"n_d": 1.47, "v_d": 50.0}}),
    ],
)
def test_media_are_written_as_one_line(text, table):
    assert parse_medium(text) == table
    assert medium_text(table) == text


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "must be named"),
        ("cauchy", "must be a word and numbers"),
        ("cauchy 1.5 x", r"must be a word and numbers.*got 'cauchy 1.5 x'"),
        ("abbe 1.5", "abbe needs n_d and v_d"),
        ("sellmeier 1 2", "must be a word and numbers"),
    ],
)
def test_media_that_say_nothing_are_refused(text, message):
    with pytest.raises(StackError, match=message):
        parse_medium(text)


def test_edits_change_one_thing():
    stack = read_stack(SOAP)
    assert edit(stack, "layers.0.thickness_nm", "420").layers[0].thickness_nm == 420.0
    assert edit(stack, "layers.0.medium", "1.4").layers[0].medium == "1.4"
    assert edit(stack, "layers.0.coherent", "false").layers[0].coherent is False
    assert edit(stack, "substrate", "Au/Johnson").substrate == "Au/Johnson"
    assert edit(stack, "range_nm", "100:800").range_nm == (100.0, 800.0)
    assert stack == read_stack(SOAP)
    assert edit(stack, "technique", "airy").technique == "airy"
    assert is_path("layers.1.medium")
    assert is_path("technique")
    assert not is_path("thickness_nm")


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("layers.1.medium", "air", r"layers\.1\.medium: no such layer; there are layers 0 to 0"),
        ("layers.x.medium", "air", "no such layer"),
        ("layers.0.colour", "1", r"must end in \.medium, \.thickness_nm or \.coherent"),
        ("layers.0.thickness_nm", "-1", r"must be in \[0, 1e8\] nm \(got -1\)"),
        ("layers.0.thickness_nm", "nan", "got nan"),
        ("layers.0.coherent", "no", "must be true or false"),
        ("range_nm", "800:100", "must be LOW:HIGH"),
        ("substrate", "", "must be named"),
        ("technique", "fresnel", r"must be one of multilayer, .*, recursion \(got fresnel\)"),
    ],
)
def test_edits_that_cannot_be(path, value, message):
    with pytest.raises(StackError, match=message):
        edit(read_stack(SOAP), path, value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("schema = [", "not a template"),
        ("[grating]\npitch_nm = 3", "not the template of a film"),
        ("surface glow\n(\n)\n{\n}\n", "not the template of a film: it is a shader"),
        ("[ambient]\nn = 1\n[substrate]\n", "not a template"),
        ("[ambient]\nn = 1\n[substrate]\nn = 1\n[[layer]]\nn = 1", "thickness_nm"),
    ],
)
def test_text_that_is_no_film(text, message):
    with pytest.raises(StackError, match=message):
        read_stack(text)


def test_swatch_has_grazing_light_on_the_right_and_thick_films_on_top():
    table = np.zeros((3, 9, 3))
    table[2, :, 0] = 1.0  # thick: red
    table[:, 0, 2] = 1.0  # grazing: blue
    picture = plot.swatch(table)
    assert picture.shape == (plot.SIZE, plot.SIZE, 4)
    assert picture[-1, 0].tolist() == [1, 0, 0, 1]
    assert picture[0, 0].tolist() == [0, 0, 0, 1]
    assert picture[0, -1, 2] > 0.1


def test_spectrum_fills_what_is_under_the_curve():
    matching = np.zeros((471, 3))
    matching[:, 1] = 1.0
    picture = plot.spectrum(np.full(471, 0.5), matching)
    below, above = picture[plot.SIZE // 3, 10], picture[2 * plot.SIZE // 3, 10]
    assert below[1] > 0.5 > above[1]
    line = picture[plot.SIZE // 2, 10]
    assert line[:3].min() > 0.9
