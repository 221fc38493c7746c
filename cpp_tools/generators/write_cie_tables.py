# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write the CIE tables of cpp_tools/data/cmf and cpp_tools/data/spd.

    pip install colour-science==0.4.6
    python write_cie_tables.py

colour-science (BSD-3-Clause) carries the tables as the CIE and the CVRL publish them. They are
written in the steps and digits in which they stand there, without any interpolation.
"""

from __future__ import annotations

from pathlib import Path

import colour
from colour.colorimetry import SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES

DATA = Path(__file__).resolve().parents[1] / "data"
TAKEN_FROM = f"Taken from colour-science {colour.__version__} by generators/write_cie_tables.py."
LICENCE = (
    "Licence: the numbers are facts published by the CIE; the transcription is that of "
    "colour-science, BSD-3-Clause."
)
STEP_NOTE = "Between the samples: linear. Above the last sample: its value (CIE 015:2018, 7.2.3)."
BOTH_ENDS_NOTE = (
    "Between the samples: linear. Beyond either end: the value there (CIE 015:2018, 7.2.3)."
)

OBSERVERS = {
    "cie_1931_2deg_1nm": (
        "CIE 1931 2 Degree Standard Observer",
        "CIE 1931 colour-matching functions, 2 degree observer",
        "CIE 018:2019, https://doi.org/10.25039/CIE.DS.xvudnb9b; ISO/CIE 11664-1:2019",
    ),
    "cie_1964_10deg_1nm": (
        "CIE 1964 10 Degree Standard Observer",
        "CIE 1964 colour-matching functions, 10 degree observer",
        "CIE 018:2019, https://doi.org/10.25039/CIE.DS.sqksu2n5; ISO/CIE 11664-1:2019",
    ),
}
ILLUMINANTS = {
    "cie_a": ("A", "CIE standard illuminant A", "ISO/CIE 11664-2:2022"),
    "cie_b": ("B", "CIE illuminant B, withdrawn", "CIE 1931"),
    "cie_c": ("C", "CIE illuminant C", "CIE 015:2018"),
    "cie_d50": ("D50", "CIE standard illuminant D50", "CIE 015:2018, table 6"),
    "cie_d55": ("D55", "CIE illuminant D55", "CIE 015:2018, table 6"),
    "cie_d65": ("D65", "CIE standard illuminant D65", "ISO/CIE 11664-2:2022"),
    "cie_d75": ("D75", "CIE illuminant D75", "CIE 015:2018, table 6"),
}

LED_NAMES = ["B1", "B2", "B3", "B4", "B5", "BH1", "RGB1", "V1", "V2"]
# File, title, source, then the columns: our name and that of colour-science.
FAMILIES = [
    (
        "cie_fluorescent",
        "CIE illuminants F1 to F12 (FL1 to FL12), fluorescent lamps",
        "CIE 015:2018",
        [(f"F{i}", f"FL{i}") for i in range(1, 13)],
    ),
    (
        "cie_led",
        "CIE illuminants LED-B1 to LED-V2, white LEDs",
        "CIE 015:2018",
        [(f"LED-{name}", f"LED-{name}") for name in LED_NAMES],
    ),
]


def write_table(path: Path, header: list[str], columns: list[str], rows) -> None:
    lines = [f"# {line}" for line in header]
    lines.append(",".join(columns))
    lines += [",".join(repr(float(value)) for value in row) for row in rows]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_observers() -> None:
    for name, (key, title, source) in OBSERVERS.items():
        table = colour.MSDS_CMFS[key]
        header = [title, f"Source: {source}", TAKEN_FROM, LICENCE]
        rows = zip(table.wavelengths, *table.values.T, strict=True)
        write_table(
            DATA / "cmf" / f"{name}.csv", header, ["wavelength_nm", "x_bar", "y_bar", "z_bar"], rows
        )


def write_illuminants() -> None:
    for name, (key, title, source) in ILLUMINANTS.items():
        table = colour.SDS_ILLUMINANTS[key]
        header = [title, f"Source: {source}", TAKEN_FROM, LICENCE, STEP_NOTE]
        rows = zip(table.wavelengths, table.values, strict=True)
        write_table(DATA / "spd" / f"{name}.csv", header, ["wavelength_nm", "power"], rows)

    parts = SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES
    header = [
        "Components of daylight used in the calculation of CIE D illuminants",
        "Source: CIE 015:2018, table 6",
        TAKEN_FROM,
        LICENCE,
        "Between the samples: linear.",
    ]
    rows = zip(parts["S0"].wavelengths, *(parts[f"S{i}"].values for i in range(3)), strict=True)
    write_table(
        DATA / "spd" / "cie_daylight_components.csv",
        header,
        ["wavelength_nm", "s0", "s1", "s2"],
        rows,
    )


def write_families() -> None:
    for name, title, source, columns in FAMILIES:
        tables = [colour.SDS_ILLUMINANTS[key] for _, key in columns]
        header = [title, f"Source: {source}", TAKEN_FROM, LICENCE, BOTH_ENDS_NOTE]
        rows = zip(tables[0].wavelengths, *(table.values for table in tables), strict=True)
        names = ["wavelength_nm", *(ours for ours, _ in columns)]
        write_table(DATA / "spd" / f"{name}.csv", header, names, rows)


if __name__ == "__main__":
    write_observers()
    write_illuminants()
    write_families()
