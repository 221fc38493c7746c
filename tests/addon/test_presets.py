# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Presets of manifests: what is read, what is refused, and how they are named."""

from __future__ import annotations

import pytest
from nacre_extension.core.manifest import ManifestError
from nacre_extension.core.presets import Preset, PresetError, named, read, text

THIN = {"name": "Thin", "values": {"thickness_nm": 200}}


def test_presets_are_read_and_kept(film, edited):
    assert film.presets == ()
    presets = edited(lambda manifest: manifest.update(presets=[THIN])).presets
    assert presets == (Preset("Thin", {"thickness_nm": 200}),)
    assert read(text(presets)) == presets
    assert read("not JSON") == read('[{"name": 1}]') == ()


@pytest.mark.parametrize(
    ("presets", "message"),
    [
        ({}, "presets: must be a list (got {})"),
        (["Thin"], "presets[0]: must be an object with a name and values (got 'Thin')"),
        ([{"name": "", "values": {}}], "presets[0]: must be an object with a name and values"),
        (
            [THIN, {"name": "Wrong", "values": {"colour": 1}}],
            "presets[1].values: 'colour' must be one of the numbers: thickness_nm",
        ),
        (
            [{"name": "Wrong", "values": {"thickness_nm": "200"}}],
            "presets[0].values.thickness_nm: must be a number (got '200')",
        ),
    ],
)
def test_wrong_presets_name_the_field(edited, presets, message):
    with pytest.raises(ManifestError) as error:
        edited(lambda manifest: manifest.update(presets=presets))
    assert message in str(error.value)


def test_names_are_found_in_any_case():
    presets = (Preset("Thin", {}), Preset("Thick", {}))
    assert named(presets, "thick") is presets[1]
    with pytest.raises(PresetError, match="there is no preset 'wet'; there are: Thin, Thick"):
        named(presets, "wet")
    with pytest.raises(PresetError, match="there are: none"):
        named((), "wet")
