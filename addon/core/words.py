# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words that artists type, beside the tags that materials have: British and American, of trades and of
everyday. What each stands for are tags, ids, kinds, or parts of a category, all in lower case."""

from __future__ import annotations

from functools import lru_cache

from .library import Entry

_TURNING = ("flip", "colour shift", "colour_shift_ink", "pearl")
_STRUCTURAL = ("insect", "bird", "butterfly", "fish", "lamellae")
_BURNT = ("heat tint",)
_SYNONYMS: dict[str, tuple[str, ...]] = {
    # What it looks like.
    "iridescent": (
        *_STRUCTURAL, *_TURNING, *_BURNT, "rainbow", "bubble", "slick", "anodised", "dichroic", "lustre",
        "tarnish", "disc", "coated", "violet", "oxide",
    ),
    "rainbow": ("bubble", "slick", "disc", "dispersive", "heat tint"),
    "holographic": ("disc", "colour_shift_ink", "bismuth_crystal", "dichroic"),
    "pearlescent": ("pearl", "lustre_ceramic", "ammolite"),
    "opalescent": ("pearl_white", "lustre_ceramic", "labradorite", "tiffany_glass", "ammolite"),
    "opal": ("labradorite", "ammolite", "pearl_white"),
    "nacre": ("pearl", "ammolite", "lustre_ceramic"),
    "mother of pearl": ("pearl_white", "ammolite", "lustre_ceramic"),
    "chameleon": ("flip", "colour_shift_ink"),
    "colour shift": ("flip", "colour_shift_ink", "pearl", "dichroic"),
    "color shift": ("flip", "colour_shift_ink", "pearl", "dichroic"),
    "colorshift": ("flip", "colour_shift_ink"),
    "flip flop": ("flip", "colour_shift_ink"),
    "duochrome": ("flip", "pearl", "colour_shift_ink"),
    "multichrome": ("flip", "colour_shift_ink"),
    "interference": ("film",),
    "thin film": ("film",),
    "structural colour": _STRUCTURAL,
    "structural color": _STRUCTURAL,
    "shimmer": ("pearl", "lustre", "insect", "bird"),
    "glitter": ("pearl", "flip"),
    "metallic": ("metals", "coatings", "flip"),
    "shiny": ("metals", "mirror", "beetle"),
    "see-through": ("bubble", "transparent", "dispersive", "dichroic", "window"),
    "transparent": ("bubble", "dispersive", "dichroic", "window", "lens"),
    "clear": ("bubble", "dispersive", "transparent", "lens"),
    # Metals.
    "burnt": _BURNT,
    "burned": _BURNT,
    "blued": _BURNT,
    "bluing": _BURNT,
    "temper": _BURNT,
    "heat treated": _BURNT,
    "weld": _BURNT,
    "scorched": _BURNT,
    "anodized": ("anodised",),
    "aluminum": ("aluminium",),
    "hematite": ("haematite_steel", "rainbow_haematite"),
    "blade": ("steel", "tempered_titanium"),
    "knife": ("steel",),
    "sword": ("steel",),
    "pipe": ("exhaust",),
    "muffler": ("exhaust",),
    "patina": ("tarnish", "raku_copper"),
    "oxidized": ("tarnish", "heat tint", "anodised"),
    "oxidised": ("tarnish", "heat tint", "anodised"),
    "ring": ("jewellery",),
    "jewelry": ("jewellery", "gem"),
    "jewel": ("jewellery", "gem", "jewel_beetle"),
    "gemstone": ("gem", "diamond"),
    "brilliant": ("diamond",),
    # Liquids and slicks.
    "gasoline": ("petrol",),
    "gas": ("petrol",),
    "fuel": ("petrol", "oil"),
    "diesel": ("petrol", "oil"),
    "oil spill": ("slick",),
    "puddle": ("slick", "water"),
    "soap bubble": ("bubble",),
    "foam": ("bubble",),
    "glycerine": ("glycerin_bubble",),
    # Discs and glass.
    "cd": ("cd",),
    "compact disc": ("cd",),
    "disk": ("disc",),
    "laser disc": ("disc",),
    "blu-ray": ("dvd",),
    "grating": ("disc",),
    "diffraction": ("disc",),
    "prism": ("dispersive",),
    "refraction": ("dispersive",),
    "crystal": ("diamond", "gem"),
    "stained glass": ("dichroic", "tiffany_glass"),
    "art nouveau": ("tiffany_glass",),
    "iris glass": ("carnival_glass", "tiffany_glass"),
    "sunglasses": ("spectacle_coating", "gold_visor"),
    "eyeglasses": ("spectacle_coating",),
    "camera": ("lens_coating",),
    "anti-reflective": ("antireflection",),
    "ar coating": ("antireflection",),
    "chrome": ("mirror",),
    "spacesuit": ("gold_visor",),
    "skyscraper": ("low_e_window",),
    # Paint, print, ceramics.
    "automotive": ("car",),
    "vehicle": ("car",),
    "lacquer": ("car", "pearl"),
    "nail polish": ("pearl", "flip"),
    "makeup": ("pearl",),
    "money": ("banknote",),
    "hologram": ("disc", "colour_shift_ink"),
    "luster": ("lustre",),
    "glaze": ("ceramics",),
    "china": ("porcelain",),
    "pottery": ("ceramics",),
    # Nature.
    "scarab": ("beetle",),
    "bug": ("insect",),
    "dragonfly": ("damselfly_wing",),
    "moth": ("butterfly",),
    "plumage": ("bird",),
    "hummingbird": ("peacock_feather", "duck_speculum"),
    "mallard": ("duck_speculum",),
    "dove": ("pigeon_neck",),
    "scales": ("fish", "butterfly"),
    "mermaid": ("fish", "ammolite", "pearl"),
    "abalone": ("ammolite", "lustre_ceramic"),
    "seashell": ("shell", "lustre_ceramic"),
    "peacock ore": ("bornite",),
    # Technology.
    "microchip": ("chip",),
    "semiconductor": ("semiconductors",),
    "photovoltaic": ("solar_cell",),
    "cpu": ("chip",),
}  # fmt: skip


@lru_cache(maxsize=256)
def synonyms(entry: Entry) -> tuple[str, ...]:
    """Further words for a material, none of which is a tag of its own."""
    parts = {part.strip().lower() for part in entry.category.split("/")}
    tags = {tag.lower() for tag in entry.tags}
    known = {entry.id, entry.kind} | tags | parts | {part.removesuffix("s") for part in parts}
    return tuple(
        word for word, targets in _SYNONYMS.items() if known & set(targets) and word not in tags
    )


def finds(entry: Entry, query: str) -> bool:
    """Whether each word of a query begins a word of the material's, without regard to case."""
    texts = (entry.name, entry.category, *entry.tags, *synonyms(entry))
    words = " ".join(texts).lower().replace("/", " ").replace(",", " ").replace("-", " ").split()
    asked = query.lower().replace("-", " ").replace(",", " ").split()
    return all(any(word.startswith(part) for word in words) for part in asked)
