# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write cpp_tools/data/optical_constants from a checkout of the refractiveindex.info database.

    git clone https://github.com/polyanskiy/refractiveindex.info-database
    python import_optical_constants.py refractiveindex.info-database

The database is in the public domain (CC0 1.0). Every entry keeps its references, comments and data
as they are, but for misplaced rows and rows with gain; comment lines say so and where it is from,
and NAMES (a key of the database's own about files) gives it a readable name. `book/page` is the key
under which templates name a medium.
"""

from __future__ import annotations

import argparse
import re
import subprocess
from pathlib import Path

OUTPUT = Path(__file__).resolve().parents[1] / "data" / "optical_constants"

POLYMER = {
    "pc": "organic/(C16H14O3)n - polycarbonate/nk",
    "pmma": "organic/(C5H8O2)n - poly(methyl methacrylate)/nk",
    "ps": "organic/(C8H8)n - polystyrene/nk",
}

# key: (file below database/data, readable name)
ENTRIES = {
    # Liquids
    "water/Daimon-20C": ("main/H2O/nk/Daimon-20.0C", "Water, 20 °C"),
    "water/Hale": ("main/H2O/nk/Hale", "Water, 25 °C, with absorption"),
    # Metals
    "Ag/Johnson": ("main/Ag/nk/Johnson", "Silver"),
    "Al/Rakic": ("main/Al/nk/Rakic", "Aluminium"),
    "Au/Johnson": ("main/Au/nk/Johnson", "Gold"),
    "Co/Johnson": ("main/Co/nk/Johnson", "Cobalt"),
    "Cr/Johnson": ("main/Cr/nk/Johnson", "Chromium"),
    "Cu/Johnson": ("main/Cu/nk/Johnson", "Copper"),
    "Fe/Johnson": ("main/Fe/nk/Johnson", "Iron"),
    "Ni/Johnson": ("main/Ni/nk/Johnson", "Nickel"),
    "Pt/Werner": ("main/Pt/nk/Werner", "Platinum"),
    "Ti/Johnson": ("main/Ti/nk/Johnson", "Titanium"),
    "W/Werner": ("main/W/nk/Werner", "Tungsten"),
    # Semiconductors and nitrides
    "Ge/Jellison": ("main/Ge/nk/Jellison", "Germanium"),
    "Si/Green-2008": ("main/Si/nk/Green-2008", "Silicon"),
    "Si3N4/Luke": ("main/Si3N4/nk/Luke", "Silicon nitride, film"),
    "TiN/Pfluger": ("main/TiN/nk/Pfluger", "Titanium nitride"),
    # Oxides
    "Al2O3/Malitson-o": ("main/Al2O3/nk/Malitson-o", "Sapphire, ordinary ray"),
    "Al2O3/Malitson-e": ("main/Al2O3/nk/Malitson-e", "Sapphire, extraordinary ray"),
    "CaCO3/Ghosh-o": ("main/CaCO3/nk/Ghosh-o", "Calcite, ordinary ray"),
    "CaCO3/Ghosh-e": ("main/CaCO3/nk/Ghosh-e", "Calcite, extraordinary ray"),
    "Fe2O3/Querry-o": ("main/Fe2O3/nk/Querry-o", "Hematite, ordinary ray"),
    "Fe2O3/Querry-e": ("main/Fe2O3/nk/Querry-e", "Hematite, extraordinary ray"),
    "Fe3O4/Querry": ("main/Fe3O4/nk/Querry", "Magnetite"),
    "HfO2/Al-Kuhaili": ("main/HfO2/nk/Al-Kuhaili", "Hafnium dioxide, film"),
    "Nb2O5/Lemarchand": ("main/Nb2O5/nk/Lemarchand", "Niobium pentoxide, film"),
    "SiO/Hass": ("main/SiO/nk/Hass", "Silicon monoxide, film"),
    "SiO2/Malitson": ("main/SiO2/nk/Malitson", "Fused silica"),
    "SiO2/Lemarchand": ("main/SiO2/nk/Lemarchand", "Silicon dioxide, film"),
    "SiO2/Ghosh-o": ("main/SiO2/nk/Ghosh-o", "Quartz, ordinary ray"),
    "SiO2/Ghosh-e": ("main/SiO2/nk/Ghosh-e", "Quartz, extraordinary ray"),
    "Ta2O5/Gao": ("main/Ta2O5/nk/Gao", "Tantalum pentoxide, film"),
    "TiO2/Devore-o": ("main/TiO2/nk/Devore-o", "Rutile, ordinary ray"),
    "TiO2/Devore-e": ("main/TiO2/nk/Devore-e", "Rutile, extraordinary ray"),
    "TiO2/Sarkar": ("main/TiO2/nk/Sarkar", "Titanium dioxide, film"),
    "TiO2/Siefke": ("main/TiO2/nk/Siefke", "Titanium dioxide, film by ALD"),
    "ZnO/Stelling": ("main/ZnO/nk/Stelling", "Zinc oxide, film"),
    "ZrO2/Synowicki": ("main/ZrO2/nk/Synowicki", "Cubic zirconia"),
    # Other crystals and film materials
    "CaF2/Malitson": ("main/CaF2/nk/Malitson", "Calcium fluoride"),
    "diamond/Peter": ("main/C/nk/Peter", "Diamond"),
    "MgF2/Dodge-o": ("main/MgF2/nk/Dodge-o", "Magnesium fluoride, ordinary ray"),
    "MgF2/Dodge-e": ("main/MgF2/nk/Dodge-e", "Magnesium fluoride, extraordinary ray"),
    "NaCl/Li": ("main/NaCl/nk/Li", "Sodium chloride"),
    "ZnS/Ozaki": ("main/ZnS/nk/Ozaki", "Zinc sulphide"),
    # Polymers
    "PC/Sultanova": (POLYMER["pc"] + "/Sultanova", "Polycarbonate"),
    "PMMA/Sultanova": (POLYMER["pmma"] + "/Sultanova", "Acrylic glass (PMMA)"),
    "PS/Sultanova": (POLYMER["ps"] + "/Sultanova", "Polystyrene"),
    # Optical glasses
    "F2/SCHOTT": ("specs/schott/optical/F2", "SCHOTT F2 flint glass"),
    "N-BK7/SCHOTT": ("specs/schott/optical/N-BK7", "SCHOTT N-BK7 crown glass"),
    "N-SF11/SCHOTT": ("specs/schott/optical/N-SF11", "SCHOTT N-SF11 dense flint glass"),
    "SF11/SCHOTT": ("specs/schott/optical/SF11", "SCHOTT SF11 dense flint glass"),
}


ROW = re.compile(r"^ {4,}[0-9][0-9.eE+-]*( +[0-9.eE+-]+){1,2} *$")


def numbers(row: str) -> list[float]:
    return [float(word) for word in row.split()]


def mended_rows(rows: list[str]) -> tuple[list[str], list[str]]:
    """Rows that a reader can use, and what had to be changed for it."""
    changes = []
    ordered = sorted(rows, key=lambda row: numbers(row)[0])
    if ordered != rows:
        changes.append("rows sorted by wavelength")
    first = {}
    for row in ordered:
        first.setdefault(numbers(row)[0], row)
    unique = list(first.values())
    if len(unique) != len(ordered):
        changes.append("second row of a repeated wavelength left out")
    passive = [row for row in unique if min(numbers(row)) >= 0.0]
    if len(passive) != len(unique):
        changes.append("rows with k < 0 left out")
    return passive, changes


def mended_tables(lines: list[str]) -> tuple[list[str], list[str]]:
    """The same for every table of a file."""
    result, changes = [], []
    start = 0
    while start < len(lines):
        end = start
        while end < len(lines) and ROW.match(lines[end]):
            end += 1
        if end > start:
            rows, why = mended_rows(lines[start:end])
            result += rows
            changes += why
        else:
            result.append(lines[start])
            end += 1
        start = end
    return result, changes


def entry_text(database: Path, commit: str, source: str, name: str) -> str:
    path = f"database/data/{source}.yml"
    body = (database / path).read_text(encoding="utf-8").replace("\r\n", "\n")
    lines = body.split("\n")
    # The database's own three lines on the licence stay on top.
    header = [line for line in lines if line.startswith("#")]
    lines = lines[len(header) :]
    header.append(f"# {path} at commit {commit}")
    lines, changes = mended_tables(lines)
    header += [f"# changed: {change}" for change in changes]
    rest = "\n".join(lines).strip("\n")
    return "\n".join(header) + f"\n\nNAMES:\n  - {name}\n{rest}\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("database", type=Path, help="checkout of refractiveindex.info-database")
    parser.add_argument("--commit", help="its commit; asked from git by default")
    arguments = parser.parse_args()
    commit = (
        arguments.commit
        or subprocess.run(
            ["git", "-C", arguments.database, "rev-parse", "HEAD"],
            check=True,
            capture_output=True,
            text=True,
        ).stdout.strip()
    )

    for key, (source, name) in ENTRIES.items():
        output = OUTPUT / f"{key}.yml"
        output.parent.mkdir(parents=True, exist_ok=True)
        output.write_text(entry_text(arguments.database, commit, source, name), encoding="utf-8")


if __name__ == "__main__":
    main()
