# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What manifests say may be asked of a material."""

from __future__ import annotations

import pytest
from nacre_extension.core.library import Library
from nacre_extension.core.manifest import ManifestError, load_folder
from nacre_extension.core.traits import Closure, Traits
from nacre_extension.core.traits import read as read_traits

from support.paths import OTHER_KINDS


def test_traits_are_read(film, grating):
    assert film.traits == Traits(
        editable_stack=True, probe=True, closures=(Closure("BSDF", "surface"),), truth="stack"
    )
    mist = load_folder(OTHER_KINDS / "test_mist")
    assert (mist.kind, mist.traits.stage, mist.traits.furnace) == ("mist", "furnace", "body")
    assert [closure.role for closure in mist.traits.closures] == ["surface", "emission", "volume"]
    assert mist.traits.truth is None
    for made in (film, grating, mist):
        assert read_traits(made.traits.text()) == made.traits
    assert Library(OTHER_KINDS).entries()["test_mist"].traits == mist.traits


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"stage": 7}, "traits.stage: must be the name of a stage (got 7)"),
        ({"editable_stack": "yes"}, "traits.editable_stack: must be true or false (got 'yes')"),
        ({"probe": None}, "traits.probe: must be true or false (got None)"),
        ({"truth": 1}, "traits.truth: must be a word or null (got 1)"),
        ({"furnace": "hot"}, "traits.furnace: must be one of surface, body (got 'hot')"),
        ({"closures": []}, "traits.closures: must be a list of objects, one for each output"),
        ({"closures": ["BSDF"]}, "traits.closures[0]: must be an object with an output and a role"),
        (
            {"closures": [{"output": "BSDF", "role": "foam"}]},
            "traits.closures[0].role: must be one of surface, emission, volume (got 'foam')",
        ),
        (
            {"closures": [{"output": "Glow", "role": "emission"}]},
            "traits.closures[0].output: must be an output: BSDF (got 'Glow')",
        ),
    ],
)
def test_wrong_traits_name_the_field(edited, change, message):
    with pytest.raises(ManifestError) as error:
        edited(lambda manifest: manifest["traits"].update(change))
    assert message in str(error.value)


def test_traits_must_be_an_object(edited):
    with pytest.raises(ManifestError, match=r"traits: must be an object \(got \[\]\)"):
        edited(lambda manifest: manifest.update(traits=[]))


@pytest.mark.parametrize(
    ("template", "layered"),
    [
        ("[ambient]\nmedium = 'air'\n[substrate]\nn = 1.5\n", True),
        ("[grooves]\npitch_nm = 1600\n", False),
        ("[ambient", False),
        ("", False),
    ],
)
def test_manifests_of_older_tools_are_taken_by_their_template(edited, template, layered):
    def change(manifest):
        del manifest["traits"]
        manifest["template"] = template

    said = edited(change).traits
    assert (said.editable_stack, said.probe, said.truth == "stack") == (layered,) * 3
    assert said.closures == (Closure("BSDF", "surface"),)
    assert (said.stage, said.furnace) == ("shaderball", "surface")


def test_any_word_is_a_kind(edited):
    assert edited(lambda manifest: manifest.update(kind="foam")).kind == "foam"
