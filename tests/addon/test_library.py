# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The shipped materials as an artist finds them: catalogues, pictures, tags, honest status."""

from __future__ import annotations

import json
from collections import Counter

import OpenImageIO as oiio
import pytest
from nacre_extension.core.catalogues import catalogue_id, catalogue_text, thumbnail
from nacre_extension.core.library import Entry
from nacre_extension.core.words import finds, synonyms

from support.paths import materials_folder

MATERIALS = {
    path.stem: json.loads(path.read_text("utf-8"))
    for path in sorted(materials_folder().glob("*/*.json"))
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


# What people type for a look or a thing, and one material that must be among what is found.
WORDS = {
    "iridescent": "soap_film", "Iridescent": "peacock_feather", "holographic": "cd",
    "pearlescent": "pearl_white", "chameleon": "car_paint_green_violet", "colour shift": "colour_shift_ink",
    "color shift": "colour_shift_ink", "color-shift": "car_paint_red_green", "flip flop": "car_paint_blue_red",
    "burnt": "tempered_titanium", "burned": "tempered_steel", "rainbow": "petrol_on_asphalt", "cd": "cd",
    "disc": "dvd", "disk": "cd", "gasoline": "petrol_on_asphalt", "anodized": "anodised_titanium",
    "anodised": "anodised_niobium", "opalescent": "labradorite", "opal": "ammolite", "nacre": "pearl_white",
    "mother of pearl": "lustre_ceramic", "bubble": "soap_film", "soap": "glycerin_bubble", "oil": "oil_on_water",
    "oil spill": "oil_on_water", "slick": "petrol_on_asphalt", "puddle": "petrol_on_asphalt",
    "beetle": "jewel_beetle", "scarab": "rose_chafer", "bug": "raja_beetle", "insect": "fly_wing",
    "dragonfly": "damselfly_wing", "butterfly": "morpho_butterfly", "feather": "peacock_feather",
    "hummingbird": "peacock_feather", "bird": "pigeon_neck", "fish": "neon_tetra", "mermaid": "neon_tetra",
    "abalone": "ammolite", "shell": "ammolite", "gem": "labradorite", "gemstone": "mystic_topaz",
    "jewelry": "anodised_titanium", "ring": "anodised_niobium", "diamond": "diamond", "brilliant": "diamond",
    "prism": "n_bk7", "dispersion": "sf11", "glass": "n_bk7", "stained glass": "dichroic_red",
    "dichroic": "dichroic_blue", "lens": "lens_coating", "camera": "lens_coating",
    "anti-reflective": "spectacle_coating", "sunglasses": "gold_visor", "astronaut": "gold_visor",
    "mirror": "enhanced_aluminium", "aluminum": "anodised_aluminium", "steel": "tempered_steel",
    "blade": "tempered_steel", "knife": "tempered_steel", "sword": "haematite_steel", "exhaust": "blued_chrome",
    "weld": "tempered_stainless_steel", "blued steel": "tempered_steel", "heat": "tempered_titanium",
    "titanium": "tempered_titanium", "hematite": "rainbow_haematite", "bismuth": "bismuth_crystal",
    "patina": "bornite", "car paint": "car_paint_red_green", "automotive": "car_paint_blue_red",
    "nail polish": "pearl_red", "makeup": "pearl_gold", "banknote": "colour_shift_ink",
    "money": "colour_shift_ink", "hologram": "cd", "pottery": "raku_copper", "porcelain": "lustre_ceramic",
    "luster": "carnival_glass", "wafer": "photoresist_wafer", "microchip": "oxidised_silicon",
    "solar": "solar_cell", "photovoltaic": "solar_cell", "window": "low_e_window", "thin film": "soap_film",
    "interference": "oil_on_water", "structural color": "morpho_butterfly", "diffraction": "dvd",
    "transparent": "soap_film", "water": "water",
}  # fmt: skip
ENTRIES = [
    Entry(
        name, text["name"], text["category"], text["description"],
        "grating" if name in ("cd", "dvd") else "glass" if "Dispersive" in text["category"] else "film",
        tuple(text["tags"]),
    )
    for name, text in MATERIALS.items()
]  # fmt: skip


def test_words_that_artists_type_find_what_they_should():
    assert len(WORDS) >= 60
    for word, expected in WORDS.items():
        found = {entry.id for entry in ENTRIES if finds(entry, word)}
        assert expected in found, (word, found)
    # A word that says something does not find everything.
    for word in ("cd", "gasoline", "diamond", "beetle", "window", "blade"):
        assert sum(finds(entry, word) for entry in ENTRIES) <= 6, word
    assert not [entry.id for entry in ENTRIES if finds(entry, "spaghetti")]
    assert all(finds(entry, "") for entry in ENTRIES)


def test_each_synonym_is_of_use():
    from nacre_extension.core.words import vocabulary

    found = {word for entry in ENTRIES for word in synonyms(entry)}
    tags = {tag for entry in ENTRIES for tag in entry.tags}
    assert set(vocabulary()) <= found | tags
    known = tags | {entry.id for entry in ENTRIES} | {entry.kind for entry in ENTRIES}
    parts = {part.lower() for entry in ENTRIES for part in entry.category.split("/")}
    targets = {target for group in vocabulary().values() for target in group}
    assert targets <= known | parts | {part.removesuffix("s") for part in parts}


def test_catalogues_keep_their_identifiers():
    text = catalogue_text(["Films/Bubbles", "Films/Slicks"])
    assert text.splitlines()[2] == "VERSION 1"
    assert [line.split(":")[1] for line in text.splitlines()[4:]] == [
        "Films", "Films/Bubbles", "Films/Slicks",
    ]  # fmt: skip
    # Stored in files of users: never to change.
    assert catalogue_id("Films/Bubbles") == "b2cbcb72-12af-59e0-9c3d-b6ac0941ab43"
