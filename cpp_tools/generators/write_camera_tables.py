# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Write the sensitivities of cameras of cpp_tools/data/cameras.

pip install colour-science==0.4.6
python write_camera_tables.py
"""

from __future__ import annotations

from pathlib import Path

import colour

DATA = Path(__file__).resolve().parents[1] / "data" / "cameras"
SOURCE = (
    "M. M. Darrodi, G. Finlayson, T. Goodman, M. Mackiewicz, J. Opt. Soc. Am. A 32(3), 381 (2015), "
    "https://doi.org/10.1364/JOSAA.32.000381"
)
CAMERAS = {
    "nikon_d5100": ("Nikon 5100 (NPL)", "Nikon D5100"),
    "sigma_sd1_merrill": ("Sigma SDMerill (NPL)", "Sigma SD1 Merrill"),
}


def main() -> None:
    DATA.mkdir(exist_ok=True)
    for file, (taken, name) in CAMERAS.items():
        table = colour.MSDS_CAMERA_SENSITIVITIES[taken]
        lines = [
            f"# Relative sensitivities of the {name}, measured at the National Physical Laboratory",
            f"# Source: {SOURCE}",
            f"# Taken from colour-science {colour.__version__} by generators/write_camera_tables.py.",
            "# Licence: measured values; the transcription is that of colour-science, BSD-3-Clause.",
            "wavelength_nm,red,green,blue",
        ]
        for nm, row in zip(table.wavelengths, table.values, strict=True):
            lines.append(",".join([f"{nm:g}", *(f"{value:.6g}" for value in row)]))
        (DATA / f"{file}.csv").write_text("\n".join(lines) + "\n", "utf-8")


if __name__ == "__main__":
    main()
