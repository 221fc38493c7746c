# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write tests/cpp/spectral/colour_references.h: XYZ of test spectra by colour-science.

    pip install colour-science==0.4.6
    python write_colour_references.py

The spectra are closed formulas, so that the test makes the very same samples; the measured patches
are those that colour-science carries.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import colour
import numpy as np

OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "cpp" / "spectral" / "colour_references.h"
OBSERVERS = {
    "cie1931": "CIE 1931 2 Degree Standard Observer",
    "cie1964": "CIE 1964 10 Degree Standard Observer",
}
# Base, amplitude, centre and width of base + amplitude exp(-((λ - centre) / width)²).
BELLS = [
    (0.0, 1.0, 450.0, 15.0),
    (0.0, 1.0, 532.0, 2.0),
    (0.0, 0.8, 550.0, 60.0),
    (0.05, 0.9, 620.0, 40.0),
    (0.9, -0.8, 500.0, 30.0),
    (0.5, 0.4, 700.0, 150.0),
    (0.04, 0.0, 560.0, 1.0),
    (1.0, -0.95, 600.0, 80.0),
]
LIGHTS = [("D65", "cie1931"), ("A", "cie1931"), ("D50", "cie1964"), ("D75", "cie1964")]
PATCHES = ["dark skin", "blue sky", "orange yellow", "cyan"]

HEADER = """// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
// Written by cpp_tools/generators/write_colour_references.py with colour-science {version}.
#pragma once

#include <array>
#include <vector>

namespace nacre::spectral::reference {{

/// base + amplitude exp(-((λ - centre) / width)²) as a reflectance: sd_to_XYZ_integration, Y = 1.
struct Bell {{
    double base, amplitude, centre_nm, width_nm;
    const char *illuminant, *observer;
    std::array<double, 3> xyz;
}};

/// A patch of the ColorChecker of BabelColor's average, 380 … 730 nm in 10 nm, under D65.
struct Patch {{
    const char* name;
    std::vector<double> values;
    std::array<double, 3> xyz;
}};
"""


def xyz_of(values: colour.SpectralDistribution, illuminant: str, observer: str) -> np.ndarray:
    return (
        colour.colorimetry.sd_to_XYZ_integration(
            values,
            cmfs=colour.MSDS_CMFS[OBSERVERS[observer]],
            illuminant=colour.SDS_ILLUMINANTS[illuminant],
        )
        / 100.0
    )


def numbers(values) -> str:
    return "{" + ", ".join(repr(float(value)) for value in values) + "}"


def bells() -> list[str]:
    rows = []
    wavelengths = np.arange(360.0, 831.0)
    for base, amplitude, centre, width in BELLS:
        values = base + amplitude * np.exp(-(((wavelengths - centre) / width) ** 2))
        spectrum = colour.SpectralDistribution(values, wavelengths)
        for illuminant, observer in LIGHTS:
            xyz = numbers(xyz_of(spectrum, illuminant, observer))
            rows.append(
                f'    {{{base}, {amplitude}, {centre}, {width}, "{illuminant}", "{observer}", {xyz}}},'
            )
    return rows


def patches() -> list[str]:
    rows = []
    for name in PATCHES:
        patch = colour.SDS_COLOURCHECKERS["BabelColor Average"][name]
        xyz = numbers(xyz_of(patch, "D65", "cie1931"))
        rows.append(f'    {{"{name}", {numbers(patch.values)}, {xyz}}},')
    return rows


def main() -> None:
    lines = [HEADER.format(version=colour.__version__)]
    lines += [
        "// clang-format off",
        "inline const std::vector<Bell> kBells = {",
        *bells(),
        "};",
        "",
    ]
    lines += ["inline const std::vector<Patch> kPatches = {", *patches(), "};"]
    lines += ["// clang-format on", "", "}  // namespace nacre::spectral::reference"]
    OUTPUT.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    main()
