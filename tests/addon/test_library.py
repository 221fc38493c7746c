# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The shipped materials as an artist finds them: catalogues, pictures, tags, honest status."""

from __future__ import annotations

import tomllib
from collections import Counter

import OpenImageIO as oiio
import pytest
from nacre_extension.core.catalogues import catalogue_id, catalogue_text, thumbnail

from support.paths import TEMPLATES

MATERIALS = {
    path.stem: tomllib.loads(path.read_text("utf-8"))["material"]
    for path in sorted(TEMPLATES.glob("*.toml"))
}


def test_there_is_much_to_choose_from():
    catalogues = Counter(material["category"] for material in MATERIALS.values())
    assert len(MATERIALS) >= 48
    assert len({category.split("/")[0] for category in catalogues}) >= 8
    assert len({material["name"] for material in MATERIALS.values()}) == len(MATERIALS)


@pytest.mark.parametrize("name", MATERIALS)
def test_each_material_says_what_it_is(name):
    material = MATERIALS[name]
    assert len(material["category"].split("/")) == 2
    assert material["description"][0].isupper()
    assert not material["description"].endswith(".")
    assert len(material["tags"]) >= 3
    assert len(set(material["tags"])) == len(material["tags"])
    # What the text calls typical or assumed is not sourced.
    admits = "typical" in material["source"] or "assumption" in material["source"]
    assert (material["status"] == "typical") == admits, material["source"]


@pytest.mark.parametrize("name", MATERIALS)
def test_each_material_has_a_picture(name):
    picture = oiio.ImageBuf(str(thumbnail(name)))
    assert (picture.spec().width, picture.spec().height) == (256, 256)
    stats = oiio.ImageBufAlgo.computePixelStats(picture)
    assert max(stats.stddev) > 0.03  # not one flat colour


def test_no_picture_is_left_over():
    assert {path.stem for path in thumbnail("x").parent.glob("*")} == set(MATERIALS)


def test_catalogues_keep_their_identifiers():
    text = catalogue_text(["Films/Bubbles", "Films/Slicks"])
    assert text.splitlines()[2] == "VERSION 1"
    assert [line.split(":")[1] for line in text.splitlines()[4:]] == [
        "Films", "Films/Bubbles", "Films/Slicks",
    ]  # fmt: skip
    # Stored in files of users: never to change.
    assert catalogue_id("Films/Bubbles") == "b2cbcb72-12af-59e0-9c3d-b6ac0941ab43"
