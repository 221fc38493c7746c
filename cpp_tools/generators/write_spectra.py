# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write the named spectra of cpp_tools/data/spectra.

    pip install colour-science==0.4.6
    python write_spectra.py

Measured spectra are those that colour-science (BSD-3-Clause) carries, in the steps and digits in
which they stand there. The family `study` is of our own making, but for daylight and for gold, whose
reflectance follows from the optical constants of the library. The form of the files is in
cpp_tools/doc/library.md.
"""

from __future__ import annotations

import math
import re
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import colour
from colour.quality.datasets import SDS_TCS, SDS_VS

DATA = Path(__file__).resolve().parents[1] / "data"
OUTPUT = DATA / "spectra"
TRANSCRIPTION = f"transcription of colour-science {colour.__version__}, BSD-3-Clause"

WORDS = {"FL": "fluorescent", "HPS": "high-pressure sodium", "LPS": "low-pressure sodium"}
LAMP_TAGS = [
    ("LED|PHOS|Luxeon", "led"),
    ("fluorescent|Triphosphor|^F34|^F40", "fluorescent"),
    ("sodium|Mercury|Metal Halide|^MHC", "discharge"),
    ("ncandescent|^60 A", "incandescent"),
]
TINTS = {
    "TCS01": "light greyish red",
    "TCS02": "dark greyish yellow",
    "TCS03": "strong yellow green",
    "TCS04": "moderate yellowish green",
    "TCS05": "light bluish green",
    "TCS06": "light blue",
    "TCS07": "light violet",
    "TCS08": "light reddish purple",
    "TCS09": "strong red",
    "TCS10": "strong yellow",
    "TCS11": "strong green",
    "TCS12": "strong blue",
    "TCS13": "light yellowish pink, complexion",
    "TCS14": "moderate olive green, leaf",
}


@dataclass(frozen=True)
class Family:
    folder: str
    kind: str
    references: str
    licence: str
    tags: tuple[str, ...]


CIE = Family(
    "cie",
    "emission",
    "CIE 015:2018, Colorimetry, 4th edition, https://doi.org/10.25039/TR.015.2018",
    f"facts published by the CIE; {TRANSCRIPTION}",
    ("illuminant",),
)
ISO = Family(
    "iso7589",
    "emission",
    "ISO 7589:2002, Photography: illuminants for sensitometry",
    f"facts published by the ISO; {TRANSCRIPTION}",
    ("illuminant", "photography"),
)
LAMPS = Family(
    "lamp",
    "emission",
    "Y. Ohno and W. Davis, NIST CQS simulation 7.4, National Institute of Standards and Technology, 2008",
    f"work of the United States government, public domain (17 U.S.C. 105); {TRANSCRIPTION}",
    ("lamp",),
)
CHART = Family(
    "colorchecker",
    "reflectance",
    "N. Ohta, The Basis of Color Reproduction Engineering, Corona-sha, 1997; the same in ISO 17321-1:2012",
    f"facts published by their author; {TRANSCRIPTION}",
    ("colorchecker", "patch"),
)
TEST_COLOURS = Family(
    "cie13.3",
    "reflectance",
    "CIE 13.3-1995, Method of measuring and specifying colour rendering properties of light sources",
    f"facts published by the CIE; {TRANSCRIPTION}",
    ("test colour",),
)
SATURATED = Family(
    "cqs",
    "reflectance",
    "W. Davis and Y. Ohno, Color quality scale, Optical Engineering 49(3), 033602 (2010), "
    "https://doi.org/10.1117/1.3360335; version 9.0",
    f"work of the United States government, public domain (17 U.S.C. 105); {TRANSCRIPTION}",
    ("test colour", "saturated"),
)


def slug(name: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def write(
    family: Family,
    page: str,
    name: str,
    samples: Iterable[tuple[float, float]],
    *,
    tags: Iterable[str] = (),
    comments: str = "",
) -> None:
    header = {
        "NAME": name,
        "KIND": family.kind,
        "REFERENCES": family.references,
        "LICENCE": family.licence,
        "COMMENTS": comments,
        "TAGS": ", ".join([*family.tags, *tags]),
    }
    lines = [f"# {key}: {value}" for key, value in header.items() if value]
    lines += ["wavelength_nm,value", *(f"{nm:.10g},{value:.10g}" for nm, value in samples)]
    path = OUTPUT / family.folder / f"{page}.csv"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def pairs(table: colour.SpectralDistribution) -> list[tuple[float, float]]:
    return list(zip(table.wavelengths, table.values, strict=True))


def write_illuminants() -> None:
    tables = colour.SDS_ILLUMINANTS
    for number in range(1, 16):
        page = f"FL3.{number}"
        write(CIE, page, f"CIE fluorescent lamp {page}", pairs(tables[page]), tags=["fluorescent"])
    for number in range(1, 6):
        page = f"HP{number}"
        write(CIE, page, f"CIE discharge lamp {page}", pairs(tables[page]), tags=["discharge"])
    for page in ("ID50", "ID65"):
        name = f"CIE indoor daylight {page}"
        write(CIE, page, name, pairs(tables[page]), tags=["daylight"])
    for name, table in tables.items():
        # The printer's table ends at 560 nm.
        if name.startswith("ISO 7589 ") and "Printer" not in name:
            page = slug(name.removeprefix("ISO 7589 "))
            write(ISO, page, name, pairs(table))


def write_lamps() -> None:
    skipped = ("Natural", "Philips TL-84", "SA", "SC", "T8", "Thorn", "Kinoton")
    for name, table in colour.SDS_LIGHT_SOURCES.items():
        if name.startswith(skipped):  # of sources whose terms nobody states
            continue
        short = name.replace("Neodimium", "Neodymium").replace("Delux FL", "Deluxe FL")
        readable = short
        for abbreviation, words in WORDS.items():
            readable = re.sub(rf"\b{abbreviation}\b", words, readable)
        tags = [tag for pattern, tag in LAMP_TAGS if re.search(pattern, readable)]
        write(LAMPS, slug(short), readable, pairs(table), tags=tags[:1])


def write_reflectances() -> None:
    for name, table in colour.SDS_COLOURCHECKERS["ColorChecker N Ohta"].items():
        plain = re.sub(r" \(.*", "", name)
        write(CHART, slug(plain), f"ColorChecker, {plain}", pairs(table))
    for page, tint in TINTS.items():
        table = SDS_TCS[page]
        write(TEST_COLOURS, page, f"CIE test colour {page[3:]}, {tint}", pairs(table))
    for page, table in SDS_VS["NIST CQS 9.0"].items():
        write(SATURATED, page, f"CQS test colour {page[2:]}", pairs(table))


def study(kind: str, references: str, licence: str) -> Family:
    return Family("study", kind, references, licence, ("study",))


def gaussian(centre: float, width: float, nm: float) -> float:
    return math.exp(-0.5 * ((nm - centre) / width) ** 2)


def gold() -> list[tuple[float, float]]:
    """Normal reflectance of a bulk in vacuum at the wavelengths of the optical constants."""
    text = (DATA / "optical_constants" / "Au" / "Johnson.yml").read_text(encoding="utf-8")
    rows = re.findall(r"^ +([0-9.]+) ([0-9.]+) ([0-9.]+)$", text, re.MULTILINE)
    samples = []
    for um, n, k in ([float(word) for word in row] for row in rows):
        reflectance = ((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2)
        if 0.3 <= um <= 1.0:
            samples.append((1000 * um, reflectance))
    return samples


def write_study() -> None:
    ours = "Made by formula for this library"
    light = study("emission", ours, "Apache-2.0")
    body = study("reflectance", ours, "Apache-2.0")
    grid = range(360, 831)

    def sampled(curve):
        return [(nm, curve(nm)) for nm in grid]

    comb = range(420, 701, 40)
    write(light, "constant", "Constant", [(360, 1), (830, 1)], comments="1 at every wavelength")
    write(
        light,
        "box",
        "Box, 450 to 650 nm",
        sampled(lambda nm: 1.0 if 450 <= nm <= 650 else 0.0),
        comments="1 from 450 to 650 nm, 0 elsewhere",
    )
    write(
        body,
        "red-band",
        "Red band",
        sampled(lambda nm: 0.05 + 0.85 * gaussian(620, 30, nm)),
        comments="0.05 and a Gaussian of height 0.85 at 620 nm, standard deviation 30 nm",
    )
    write(
        body,
        "two-bands",
        "Two bands",
        sampled(lambda nm: 0.8 * gaussian(460, 20, nm) + 0.6 * gaussian(580, 25, nm)),
        comments="Gaussians of height 0.8 at 460 nm and 0.6 at 580 nm, standard deviations 20 and 25 nm",
    )
    write(
        body,
        "ramp",
        "Ramp",
        [(360, 0.05), (450, 0.05), (650, 0.9), (830, 0.9)],
        comments="0.05 up to 450 nm, 0.9 from 650 nm, a straight line between",
    )
    cie = study(CIE.kind, "ISO/CIE 11664-2:2022", CIE.licence)
    d65 = pairs(colour.SDS_ILLUMINANTS["D65"])
    write(cie, "daylight", "Daylight", d65, tags=["daylight"], comments="CIE D65")
    write(
        light,
        "comb",
        "Comb of lines",
        sampled(lambda nm: sum(gaussian(centre, 2, nm) for centre in comb)),
        comments="Gaussians of height 1 every 40 nm from 420 to 700 nm, standard deviation 2 nm",
    )
    johnson = study(
        "reflectance",
        "P. B. Johnson and R. W. Christy, Phys. Rev. B 6, 4370-4379 (1972), https://doi.org/10.1103/PhysRevB.6.4370",
        "computed from optical constants in the public domain (CC0 1.0)",
    )
    write(
        johnson,
        "gold",
        "Gold",
        gold(),
        tags=["metal"],
        comments="Normal reflectance of a bulk in vacuum from n and k of Au/Johnson",
    )


if __name__ == "__main__":
    shutil.rmtree(OUTPUT, ignore_errors=True)
    write_illuminants()
    write_lamps()
    write_reflectances()
    write_study()
